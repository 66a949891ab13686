#include "run/collage_journal.h"

#include "core/base/count_text.h"
#include "terminal/terminal.h"
#include "text/digest_text.h"
#include "text/utc_time.h"

namespace tessera {

CollageJournal::CollageJournal(const std::string& folder, RunRecord record) : log_(folder), record_(std::move(record)) {
  log_.info("start: tessera " + record_.version + ", commit " + record_.commit + "; job " + record_.job_file +
            "; library " + record_.library_file + ", digest " + digest_text(record_.library_digest));
  log_.info("command: " + record_.command_line);
  if (!log_.problem().empty()) warn("no run log: " + log_.problem());
}

void CollageJournal::set_rank_sites(std::vector<RankSite> sites) {
  record_.ranks = std::move(sites);
  for (std::size_t rank = 0; rank < record_.ranks.size(); ++rank) {
    const RankSite& site = record_.ranks[rank];
    log_.info("rank " + std::to_string(rank) + " of " + std::to_string(record_.ranks.size()) + " on " + site.host +
              ": " + devices_text(site.devices));
  }
}

void CollageJournal::resumed(const CheckpointState& from) {
  record_.resumed_from = from.name;
  record_.resumed_pieces = from.placements.size();
  log_.info("going on from " + record_.resumed_from + ", " + count_text(record_.resumed_pieces, "piece"));
}

void CollageJournal::warn(const std::string& warning) {
  print_warning(warning);
  keep_warning(warning);
}

void CollageJournal::keep_warning(const std::string& warning) {
  if (warning.empty()) return;
  record_.warnings.push_back(warning);
  log_.warning(warning);
}

void CollageJournal::set_growth(std::vector<GrowthMoment> growth) { record_.growth = std::move(growth); }

const RunRecord& CollageJournal::ended(StopReason stopped_by, std::size_t pieces) {
  record_.ended_utc = utc_now();
  log_.info("end: stopped by " + std::string(stop_word(stopped_by)) + ", " + count_text(pieces, "piece"));
  return record_;
}

}  // namespace tessera
