// The origin of a checkpoint: its job, the content of its library and its canvas. It can only be resumed with the same.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "checkpoint/checkpoint_file.h"
#include "core/field/canvas.h"
#include "job/job_file.h"
#include "job/job_keys.h"
#include "library/storage/shape_library.h"

namespace tessera {

struct CheckpointOrigin {
  std::string job;  // the effective job, as to_toml writes it
  std::uint64_t library_digest = 0;
  std::uint64_t canvas_digest = 0;
  std::uint64_t overlay_digest = 0;  // Job::overlay_digest
};

/// A digest of the area to be filled.
std::uint64_t canvas_digest(const Canvas& canvas);

CheckpointOrigin make_origin(const Job& job, const ShapeLibrary& library, std::uint64_t canvas_digest);

Checkpoint make_checkpoint(const CheckpointOrigin& origin, const CheckpointState& state);

/// "; KEY: then A, now B" for each difference that changes the collage; empty where there is none. Keys that do not
/// decide about the collage (JobKey::decides) may differ, and files may have moved. Only keys for which `concerned`
/// returns true are compared; files are always compared.
std::string origin_differences(
    const CheckpointOrigin& then, const CheckpointOrigin& now,
    const std::function<bool(const JobKey&)>& concerned = [](const JobKey&) { return true; });

/// Throws InputError where `checkpoint` has another origin than `now`. The message names the file, then each difference
/// with its key and both values (origin_differences).
void check_origin(const Checkpoint& checkpoint, const CheckpointOrigin& now);

}  // namespace tessera
