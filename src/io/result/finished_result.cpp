#include "io/result/finished_result.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "io/job/job_difference.h"
#include "io/result/card_input.h"

namespace tessera::io {
namespace {

bool is_there(const std::string& dir, const char* name) {
  std::error_code error;
  return std::filesystem::is_regular_file(std::filesystem::path(dir) / name, error);
}

Job job_in(const std::string& dir) { return load_job((std::filesystem::path(dir) / "job.toml").string(), {}); }

std::string another_job(const std::string& dir, const std::string& differences) {
  return dir + ": holds the finished result of another job" + differences + "; give what it was then, ";
}

}  // namespace

ResultManifest read_result(const std::string& dir) {
  ResultManifest manifest = read_manifest(dir);
  job_in(dir);
  read_card(dir);
  if (!is_there(dir, "card.txt")) throw InputError((std::filesystem::path(dir) / "card.txt").string() + ": not found");
  return manifest;
}

std::string damage_of_result(const std::string& dir) {
  if (!is_there(dir, kManifestName)) return "";
  try {
    read_result(dir);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::optional<Job> job_of_finished_result(const std::string& dir) {
  try {
    if (!read_result(dir).finished) return {};
    return job_in(dir);
  } catch (const InputError&) {  // no result, or not one of ours: the run makes a new one
    return {};
  }
}

bool is_finished_result_of(const std::string& dir, const Job& job) {
  const std::optional<Job> then = job_of_finished_result(dir);
  if (!then) return false;
  const std::string differences = result_differences(*then, job);
  if (differences.empty()) return true;
  throw InputError(another_job(dir, differences) + "another --out, or remove that folder");
}

void check_finished_result(const std::string& dir, const CheckpointOrigin& now) {
  const ResultManifest manifest = read_result(dir);
  const Job then = job_in(dir);
  const std::string differences = origin_differences({&then, manifest.library_digest, manifest.canvas_digest}, now);
  if (!differences.empty()) throw InputError(another_job(dir, differences) + "or leave --resume out to replace it");
}

bool is_drawn(const std::string& dir) {
  const std::vector<DrawnPicture> pictures = read_result(dir).pictures;
  const auto has = [&](const char* name) {
    return std::any_of(pictures.begin(), pictures.end(), [&](const DrawnPicture& p) { return p.file == name; }) &&
           is_there(dir, name);
  };
  return has("collage.svg") && has("collage.png");
}

std::string result_differences(const Job& then, const Job& now) {
  return job_differences(then, now, [](const JobKey& key) { return key.in_result; });
}

}  // namespace tessera::io
