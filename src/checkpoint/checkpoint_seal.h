// The first bytes of a checkpoint file, before its HDF5 part: the kind of file, the format version, the size, and a
// digest of all that follows. The reader checks them before it reads anything else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace tessera {

/// Rises with every change of the format, and with every change of the algorithm after which an old state would
/// continue differently.
inline constexpr int kCheckpointVersion = 19;
/// Size of the seal: HDF5 leaves this many bytes free before its own part (its "user block").
inline constexpr std::size_t kSealBytes = 512;
/// Largest checkpoint file that is read. The largest canvas, 100 million px, full of pieces of 20 px needs about 40 MB.
/// Reading takes three times the file's size in memory.
inline constexpr std::uint64_t kMaxCheckpointBytes = std::uint64_t(256) << 20;

/// Writes the seal into the first kSealBytes of a finished file.
void seal_checkpoint(std::span<std::uint8_t> file);

/// Checks the seal of the file. Throws InputError as read_checkpoint does (checkpoint_file.h).
void check_seal(const std::string& path);

}  // namespace tessera
