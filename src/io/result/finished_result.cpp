#include "io/result/finished_result.h"

#include <filesystem>

#include "core/base/error.h"
#include "io/job/job_difference.h"
#include "io/result/card_input.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

/// The picture is written last: one that is older belongs to the run before.
bool picture_is_newest(const fs::path& dir) {
  std::error_code error;
  const auto picture = fs::last_write_time(dir / "collage.png", error);
  return !error && picture >= fs::last_write_time(dir / "job.toml", error) && !error;
}

bool ended_early(const ResultCard& card) {
  return card.stopped_by == "signal" || card.stopped_by == "time_limit" || card.stopped_by == "lost_rank";
}

}  // namespace

std::optional<Job> job_of_finished_result(const std::string& dir) {
  if (!picture_is_newest(dir)) return {};
  try {
    if (ended_early(read_card(dir))) return {};
    return load_job((fs::path(dir) / "job.toml").string(), {});
  } catch (const InputError&) {  // no card or job, or not one of ours: the run makes a new one
    return {};
  }
}

bool is_finished_result_of(const std::string& dir, const Job& job) {
  const std::optional<Job> then = job_of_finished_result(dir);
  if (!then) return false;
  const std::string differences = result_differences(*then, job);
  if (differences.empty()) return true;
  throw InputError(dir + ": holds the finished result of another job" + differences +
                   "; give what it was then, another --out, or remove that folder");
}

std::string result_differences(const Job& then, const Job& now) {
  return job_differences(then, now, [](const JobKey& key) { return key.in_result; });
}

}  // namespace tessera::io
