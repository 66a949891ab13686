#include "checkpoint/checkpoint_origin.h"

#include "core/base/digest.h"
#include "core/base/error.h"
#include "job/job_difference.h"
#include "job/pieces/job_library.h"

namespace tessera {
namespace {

/// Files go by their content.
bool counts(const JobKey& key) { return key.decides && key.kind != JobKind::file && key.kind != JobKind::files; }

std::string differing_file(const char* key, const std::string& then, const std::string& now) {
  const std::string names =
      then == now ? "\"" + now + "\" has changed since" : "then \"" + then + "\", now \"" + now + "\"";
  return std::string("; ") + key + ": another content: " + names;
}

}  // namespace

std::uint64_t canvas_digest(const Canvas& canvas) {
  Digest digest;
  digest.add(std::uint64_t(canvas.width_px));
  digest.add(std::uint64_t(canvas.height_px));
  digest.add_all(std::span<const float>(canvas.distance.value.data()));
  for (const CanvasRegion& region : canvas.regions) {
    digest.add_all(std::span<const float>(region.distance.value.data()));
  }
  if (canvas.has_zones()) digest.add_all(std::span<const float>(canvas.keep_out.value.data()));
  return digest.value();
}

CheckpointOrigin make_origin(const Job& job, const ShapeLibrary& library, std::uint64_t canvas_digest) {
  return {&job, library.content_digest(), canvas_digest, job.overlay_digest};
}

Checkpoint make_checkpoint(const CheckpointOrigin& origin, const CheckpointState& state) {
  return {to_toml(*origin.job), origin.library_digest, origin.canvas_digest, origin.overlay_digest, state};
}

std::string origin_differences(const CheckpointOrigin& then, const CheckpointOrigin& now,
                               const std::function<bool(const JobKey&)>& concerned) {
  std::string differences =
      job_differences(*then.job, *now.job, [&](const JobKey& key) { return counts(key) && concerned(key); });
  if (then.library_digest != now.library_digest) {
    differences += differing_file("library.file", library_text(*then.job), library_text(*now.job));
  }
  // The canvas of other keys is another one anyway.
  const auto told = [&](const char* key) { return differences.find(key) != std::string::npos; };
  if (then.canvas_digest != now.canvas_digest && !told("; canvas.") && !told("; [[keep_out]]")) {
    const CanvasSpec& before = then.job->canvas;
    const CanvasSpec& after = now.job->canvas;
    const bool zones = !before.keep_out.empty() || !after.keep_out.empty();
    const bool mask = !before.file.empty() || !after.file.empty();
    if (mask || !zones) differences += differing_file("canvas.file", before.file, after.file);
    if (zones) differences += differing_file("canvas.keep_out", before.keep_out, after.keep_out);
  }
  if (then.overlay_digest != now.overlay_digest) {
    const bool colours = !then.job->colour.image.empty() || !now.job->colour.image.empty();
    const bool sizes = !then.job->size_map.empty() || !now.job->size_map.empty();
    if (colours) differences += differing_file("colour.image", then.job->colour.image, now.job->colour.image);
    if (sizes) differences += differing_file("pieces.size_map", then.job->size_map, now.job->size_map);
  }
  return differences;
}

void check_origin(const Checkpoint& checkpoint, const CheckpointOrigin& now) {
  const Job then = job_from_toml(checkpoint.job, checkpoint.state.name + ", its job");
  const std::string differences =
      origin_differences({&then, checkpoint.library_digest, checkpoint.canvas_digest, checkpoint.overlay_digest}, now);
  if (differences.empty()) return;
  throw InputError(checkpoint.state.name + ": written for another job" + differences +
                   "; give what it was then, or another --out");
}

}  // namespace tessera
