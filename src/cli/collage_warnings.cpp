#include "cli/collage_warnings.h"

#include <cstdio>

#include "io/job/job_keys.h"
#include "io/job/job_value.h"

namespace tessera::cli {
namespace {

/// "pieces.scale_px (now [20, 160])"
std::string with_value(const io::Job& job, const char* section, const char* name) {
  const io::JobKey& key = *io::find_job_key(section, name);
  return key.full_name() + " (now " + io::job_value_to_toml(key, job) + ")";
}

bool is_default(const io::Job& job, const char* section, const char* name) {
  const io::JobKey& key = *io::find_job_key(section, name);
  return key.get(job) == key.get(io::Job());
}

/// Of the keys that keep pieces out, those that do. Uses cannot: the first piece is free of them.
std::string what_to_try(const io::Job& job) {
  std::string text = "smaller pieces, " + with_value(job, "pieces", "scale_px");
  if (!is_default(job, "pieces", "padding_px")) text += "; less " + with_value(job, "pieces", "padding_px");
  if (!is_default(job, "pieces", "rotation_deg")) text += "; a wider " + with_value(job, "pieces", "rotation_deg");
  if (job.settings.match.tangent_dockings == 0) {
    text += "; more " + with_value(job, "match", "tangent_dockings") + ": without, nothing docks along straight sides";
  }
  return text + "; a larger " + with_value(job, "canvas", "size_px");
}

}  // namespace

std::string replaced_result_warning(const io::EarlierResult& earlier, const io::Job& job) {
  if (!earlier.damage.empty()) {
    return earlier.folder + ": this run replaces a result that is not whole: " + earlier.damage;
  }
  const std::string differences = earlier.finished() ? io::result_differences(earlier.whole->job, job) : "";
  if (differences.empty()) return "";
  return earlier.folder + ": the finished result of another job is replaced as soon as a piece is placed" +
         differences + "; another --out keeps it";
}

std::string empty_result_warning(const std::string& folder, const io::Job& job, const master::CollageResult& result) {
  if (result.unfinished || !result.placements.empty()) return "";
  if (result.statistics.stopped_by == "seconds") {
    return folder + ": the collage is empty: " + with_value(job, "stop", "seconds") +
           " ended it before the first piece";
  }
  return folder + ": the collage is empty: nothing fits; try " + what_to_try(job);
}

void print_warning(const std::string& warning) {
  if (!warning.empty()) std::fprintf(stderr, "tessera: warning: %s\n", warning.c_str());
}

}  // namespace tessera::cli
