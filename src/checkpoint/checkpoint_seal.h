// The first bytes of a checkpoint, before its HDF5 part: what it is, its version, its size, and a digest over all that
// follows. Nothing else is read of a file before they are found to be right.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace tessera {

/// Counted up with every change of the format, and of the algorithm, that would make an old state go on differently.
inline constexpr int kCheckpointVersion = 17;
/// HDF5 leaves so much room before its own part (its "user block").
inline constexpr std::size_t kSealBytes = 512;
/// The largest canvas, 100 million px, full of pieces of 20 px has about 40 MB. Reading takes three times the file in
/// memory.
inline constexpr std::uint64_t kMaxCheckpointBytes = std::uint64_t(256) << 20;

/// Fills in the first kSealBytes of a finished file.
void seal_checkpoint(std::span<std::uint8_t> file);

/// Throws InputError, as read_checkpoint (checkpoint_file.h).
void check_seal(const std::string& path);

}  // namespace tessera
