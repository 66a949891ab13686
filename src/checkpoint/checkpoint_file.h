// A checkpoint as the bytes of a file (docs/checkpoint-format.md), and back. The reader does not trust the file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/collage/checkpoint_state.h"

namespace tessera {

struct Checkpoint {
  std::string job;                   // the effective job, as to_toml writes it
  std::uint64_t library_digest = 0;  // of the library's content, wherever its file is
  std::uint64_t canvas_digest = 0;
  std::uint64_t overlay_digest = 0;
  CheckpointState state;
};

/// The bytes of the file. The same checkpoint always gives the same bytes. Throws EnvironmentError where the checkpoint
/// is too large for the format.
std::vector<std::uint8_t> checkpoint_bytes(const Checkpoint& checkpoint);

/// Reads a checkpoint. Throws InputError, which names the file, where it is missing, not a checkpoint, of another
/// version, cut off or damaged. Every changed byte is noticed. `state.name` of the result is the path.
Checkpoint read_checkpoint(const std::string& path);

}  // namespace tessera
