#include "run/refined_result.h"

#include <algorithm>
#include <filesystem>

#include "checkpoint/checkpoint_folder.h"
#include "core/base/error.h"
#include "files/output_lock.h"
#include "job/job_tables.h"
#include "job/toml_string.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_unfinished(const std::string& folder) {
  const std::string holder = holder_of_lock(folder_lock_path(folder));
  if (!holder.empty()) {
    throw InputError(folder + ": found unfinished work, allowed: a finished result; a run is at work here: " + holder +
                     "; wait for its end");
  }
  throw InputError(folder + ": found unfinished work, allowed: a finished result; the command that made it finishes " +
                   "it with --resume");
}

/// The limit of pieces for relaxing; 0: none. Where a limit may have ended the result's run, its free room was left on
/// purpose, and no piece is added.
int most_pieces(const RefinedResult& result) {
  const StopSettings& stop = result.whole.job.settings.stop;
  const int pieces = int(result.whole.manifest.shapes.size());
  if (stop.coverage < 1 || stop.seconds > 0) return pieces;
  return stop.pieces > 0 ? std::max(stop.pieces, pieces) : 0;
}

/// The number of relaxations: one for each region.
int relaxations(const Job& job) { return std::max(1, int(rows_of(job, "regions").size())); }

}  // namespace

RefinedResult read_refined_result(const std::string& folder) {
  const bool has_checkpoint = CheckpointFolder(folder).has_any();
  try {
    RefinedResult result{folder, read_result(folder)};
    if (has_checkpoint || !result.whole.manifest.finished) fail_unfinished(folder);
    return result;
  } catch (const InputError&) {
    if (has_checkpoint) fail_unfinished(folder);
    throw;
  }
}

std::string folder_beside(const std::string& folder, const std::string& suffix) {
  fs::path path = fs::path(folder).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();  // a slash at its end
  if (path == "." || path.filename() == "..") path = fs::canonical(folder);
  return path.string() + suffix;
}

void check_other_folder(const RefinedResult& result, const std::string& out) {
  std::error_code is_not_there;
  if (!fs::equivalent(result.folder, out, is_not_there)) return;
  throw InputError("--out: found " + out + ", the result itself, which stays as it is; allowed: another folder");
}

void check_overrides(const std::vector<std::string>& overrides) {
  for (const std::string& override : overrides) {
    std::string key = override.substr(0, override.find('='));
    std::erase(key, ' ');
    if (key == "quality") {
      throw InputError("--set " + override +
                       ": no key to refine a result with; allowed: --relax --trials N, or improve.trials=N");
    }
    if (!key.starts_with("start.") || key == "start.grow") continue;
    throw InputError("--set " + override +
                     ": the pieces come from RESULT; allowed: start.grow, and the keys of other sections");
  }
}

std::vector<std::string> relaxing_keys(const RefinedResult& result, int trials) {
  const int least = relaxations(result.whole.job);
  if (trials > 0 && trials < least) {
    throw InputError("--trials: found " + std::to_string(trials) + ", allowed: " + std::to_string(least) +
                     " or more, one for each of the [[regions]]");
  }
  return {"improve.relax=true", "improve.seconds=0", "improve.trials=" + std::to_string(std::max(trials, least)),
          "stop.coverage=1",    "stop.seconds=0",    "stop.pieces=" + std::to_string(most_pieces(result))};
}

std::vector<std::string> deforming_keys(const RefinedResult& result, const std::string& kind) {
  return {"improve.seconds=0",   "improve.trials=0",
          "stop.coverage=1",     "stop.seconds=0",
          "deform.kind=" + kind, "stop.pieces=" + std::to_string(result.whole.manifest.shapes.size())};
}

std::vector<std::string> starting_keys(const RefinedResult& result) {
  return {"start.pieces=" + toml_string(result.folder), "start.keep=free", "start.remove=[]", "start.lock=[]",
          "start.not_anew=[]"};
}

std::vector<std::string> erasing_keys() { return {"start.keep=standing", "stop.coverage=1"}; }

void check_can_be_erased(const RefinedResult& result, const std::vector<PlacedPiece>& all) {
  if (result.whole.job.settings.pieces.fit_all) {
    throw InputError(result.folder + ": its job has pieces.fit = \"all\", with sizes that follow from all pieces; " +
                     "allowed: --relax, --deform");
  }
  if (std::all_of(all.begin(), all.end(), [](const PlacedPiece& piece) { return piece.exact; })) return;
  throw InputError(result.folder + ": pieces.geojson does not say exactly where pieces lie: found no " +
                   "\"canvas_from_shape\", because an earlier version made it; tessera collage " + result.folder +
                   "/job.toml --out DIR makes one that does");
}

Job with_pieces_of(const RefinedResult& result, Job job) {
  job.start.remove = result.erased;
  job.start.lock = result.locked;
  job.start.not_anew = result.not_anew;
  return checked_job(job);
}

void check_is_the_same_collage(const RefinedResult& result, const CheckpointOrigin& now,
                               const std::vector<GivenPiece>& given) {
  const Job& then = result.whole.job;
  const ResultManifest& manifest = result.whole.manifest;
  const auto concerned = [](const JobKey& key) { return key.section == "library" || key.section == "canvas"; };
  const std::string differences = origin_differences(
      {to_toml(then), manifest.library_digest, manifest.canvas_digest, manifest.overlay_digest}, now, concerned);
  if (!differences.empty()) {
    throw InputError(result.folder + ": made from other input" + differences +
                     "; give the same input (--set library.file=FILE where the library has moved)");
  }
  const bool locks = !then.start.pieces.empty() && then.start.keep == StartKeep::locked;
  const auto for_good =
      std::count_if(given.begin(), given.end(), [](const GivenPiece& piece) { return piece.locked && piece.for_good; });
  if (locks && std::size_t(for_good) == rows_of(then, "given").size()) {
    throw InputError(result.folder + ": pieces.geojson does not say which pieces are locked, as start.pieces of its " +
                     "job wants: found no \"locked\", because an earlier version made it; tessera collage " +
                     result.folder + "/job.toml --out DIR makes one that does");
  }
}

}  // namespace tessera
