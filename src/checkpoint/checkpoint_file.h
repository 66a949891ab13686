// A checkpoint as bytes of a file (docs/checkpoint-format.md), and back. What is read is not trusted.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/collage/checkpoint_state.h"

namespace tessera {

struct Checkpoint {
  std::string job;                   // the effective one, as to_toml gives it
  std::uint64_t library_digest = 0;  // of its content, wherever it lies
  std::uint64_t canvas_digest = 0;
  std::uint64_t overlay_digest = 0;
  CheckpointState state;
};

/// The same checkpoint gives the same bytes. Throws EnvironmentError where it is too large for the format.
std::vector<std::uint8_t> checkpoint_bytes(const Checkpoint& checkpoint);

/// Throws InputError that names the file: it is missing, not a checkpoint, of another version, cut off or damaged.
/// Every changed byte is noticed. `state.name` is the path.
Checkpoint read_checkpoint(const std::string& path);

}  // namespace tessera
