// What a checkpoint belongs to: a job, a library's content, a canvas. With others it cannot go on.
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
  std::string job;  // the effective one, as to_toml writes it
  std::uint64_t library_digest = 0;
  std::uint64_t canvas_digest = 0;
  std::uint64_t overlay_digest = 0;  // Job::overlay_digest
};

/// A digest of what is to be filled.
std::uint64_t canvas_digest(const Canvas& canvas);

CheckpointOrigin make_origin(const Job& job, const ShapeLibrary& library, std::uint64_t canvas_digest);

Checkpoint make_checkpoint(const CheckpointOrigin& origin, const CheckpointState& state);

/// "; KEY: then A, now B" for each difference that decides about the collage; empty where there is none. Keys that do
/// not decide may differ, and files may have moved. Of keys only those count that are `concerned`, of files all.
std::string origin_differences(
    const CheckpointOrigin& then, const CheckpointOrigin& now,
    const std::function<bool(const JobKey&)>& concerned = [](const JobKey&) { return true; });

/// Throws InputError where `checkpoint` belongs to others: the file, then each difference with its key, what it was
/// then and what it is now (origin_differences).
void check_origin(const Checkpoint& checkpoint, const CheckpointOrigin& now);

}  // namespace tessera
