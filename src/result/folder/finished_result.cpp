#include "result/folder/finished_result.h"

#include <algorithm>

#include "core/base/error.h"
#include "files/output_lock.h"
#include "job/job_difference.h"
#include "result/folder/result_file.h"

namespace tessera {
namespace {

std::string another_job(const EarlierResult& earlier, const std::string& differences) {
  const std::string what = earlier.finished() ? "the finished result" : "an unfinished result";
  return earlier.folder + ": holds " + what + " of another job" + differences + "; give what it was then, ";
}

bool has_picture(const std::string& dir, const ResultManifest& manifest, const char* name) {
  const auto& pictures = manifest.pictures;
  return std::any_of(pictures.begin(), pictures.end(), [&](const DrawnPicture& p) { return p.file == name; }) &&
         is_in_result(dir, name);
}

WholeResult whole_result_in(const std::string& dir) {
  WholeResult result;
  result.manifest = read_manifest(dir);
  result.job = job_from_toml(read_result_file(dir, "job.toml"), path_in_result(dir, "job.toml"));
  result.drawn = has_picture(dir, result.manifest, "collage.svg") && has_picture(dir, result.manifest, "collage.png");
  return result;
}

}  // namespace

WholeResult read_result(const std::string& dir) {
  try {
    return whole_result_in(dir);
  } catch (const InputError&) {
    const std::string holder = holder_of_lock(folder_lock_path(dir));
    if (holder.empty()) throw;
    throw InputError(dir + ": no whole result is there yet: a run is at work here: " + holder + "; wait for its end");
  }
}

EarlierResult find_earlier_result(const std::string& dir) {
  EarlierResult earlier;
  earlier.folder = dir;
  if (!is_in_result(dir, kManifestName)) return earlier;
  try {
    earlier.whole = whole_result_in(dir);
  } catch (const InputError& error) {
    earlier.damage = error.what();
  }
  return earlier;
}

bool is_finished_result_of(const EarlierResult& earlier, const Job& job) {
  if (!earlier.whole) return false;
  const std::string differences = result_differences(earlier.whole->job, job);
  if (differences.empty()) return earlier.finished();
  throw InputError(another_job(earlier, differences) + "another --out, or remove that folder");
}

void check_finished_result(const EarlierResult& earlier, const CheckpointOrigin& now, std::uint64_t start_digest) {
  const ResultManifest& manifest = earlier.whole->manifest;
  std::string differences = origin_differences(
      {to_toml(earlier.whole->job), manifest.library_digest, manifest.canvas_digest, manifest.overlay_digest}, now);
  const bool same_start = manifest.start.empty() || manifest.start_digest == start_digest;
  if (!same_start) differences += "; start.pieces: another content";
  if (differences.empty()) return;
  throw InputError(another_job(earlier, differences) + "or leave --resume out to replace it");
}

std::string result_differences(const Job& then, const Job& now) {
  return job_differences(then, now, [](const JobKey& key) { return key.in_result; });
}

}  // namespace tessera
