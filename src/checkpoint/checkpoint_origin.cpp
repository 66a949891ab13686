#include "checkpoint/checkpoint_origin.h"

#include "core/base/digest.h"
#include "core/base/error.h"
#include "job/job_difference.h"
#include "job/pieces/job_library.h"

namespace tessera {
namespace {

/// Whether a different value of this key changes the collage. Files are compared by their content.
bool counts(const JobKey& key) { return key.decides && key.kind != JobKind::file && key.kind != JobKind::files; }

std::string differing_file(const char* key, const std::string& then, const std::string& now) {
  const std::string names =
      then == now ? "\"" + now + "\" has changed since" : "then \"" + then + "\", now \"" + now + "\"";
  return std::string("; ") + key + ": another content: " + names;
}

/// `before` and `after` are the jobs of `then` and `now`.
std::string differences_of(const Job& before, const Job& after, const CheckpointOrigin& then,
                           const CheckpointOrigin& now, const std::function<bool(const JobKey&)>& concerned) {
  std::string differences =
      job_differences(before, after, [&](const JobKey& key) { return counts(key) && concerned(key); });
  if (then.library_digest != now.library_digest) {
    differences += differing_file("library.file", library_text(before), library_text(after));
  }
  // Where other canvas keys differ the canvas differs anyway, and needs no message of its own.
  const auto told = [&](const char* key) { return differences.find(key) != std::string::npos; };
  if (then.canvas_digest != now.canvas_digest && !told("; canvas.") && !told("; [[keep_out]]")) {
    const bool zones = !before.canvas.keep_out.empty() || !after.canvas.keep_out.empty();
    const bool mask = !before.canvas.file.empty() || !after.canvas.file.empty();
    if (mask || !zones) differences += differing_file("canvas.file", before.canvas.file, after.canvas.file);
    if (zones) differences += differing_file("canvas.keep_out", before.canvas.keep_out, after.canvas.keep_out);
  }
  if (then.overlay_digest != now.overlay_digest) {
    const bool colours = !before.colour.image.empty() || !after.colour.image.empty();
    const bool sizes = !before.size_map.empty() || !after.size_map.empty();
    if (colours) differences += differing_file("colour.image", before.colour.image, after.colour.image);
    if (sizes) differences += differing_file("pieces.size_map", before.size_map, after.size_map);
  }
  return differences;
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
  return {to_toml(job), library.content_digest(), canvas_digest, job.overlay_digest};
}

Checkpoint make_checkpoint(const CheckpointOrigin& origin, const CheckpointState& state) {
  return {origin.job, origin.library_digest, origin.canvas_digest, origin.overlay_digest, state};
}

std::string origin_differences(const CheckpointOrigin& then, const CheckpointOrigin& now,
                               const std::function<bool(const JobKey&)>& concerned) {
  return differences_of(job_from_toml(then.job, "the job of then"), job_from_toml(now.job, "the job of now"), then, now,
                        concerned);
}

void check_origin(const Checkpoint& checkpoint, const CheckpointOrigin& now) {
  const CheckpointOrigin then{checkpoint.job, checkpoint.library_digest, checkpoint.canvas_digest,
                              checkpoint.overlay_digest};
  const Job before = job_from_toml(then.job, checkpoint.state.name + ", its job");
  const std::string differences =
      differences_of(before, job_from_toml(now.job, "the job of now"), then, now, [](const JobKey&) { return true; });
  if (differences.empty()) return;
  throw InputError(checkpoint.state.name + ": unfinished work of another job" + differences +
                   "; give what it was then, or another --out");
}

}  // namespace tessera
