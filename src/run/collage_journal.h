// Keeps what happened in a run of tessera collage: a record for the card, and a line in run.log for each event. Warnings go
// to stderr as well.
#pragma once

#include <exception>
#include <string>
#include <vector>

#include "core/base/stop.h"
#include "core/collage/checkpoint_state.h"
#include "result/folder/run_log.h"
#include "result/folder/run_record.h"

namespace tessera {

class CollageJournal {
 public:
  /// `record`: what is known about the run when it starts.
  CollageJournal(const std::string& folder, RunRecord record);

  /// Notes where all ranks run; the master comes first.
  void set_rank_sites(std::vector<RankSite> sites);
  void resumed(const CheckpointState& from);
  /// Writes a warning to run.log and to stderr. Does nothing where it is empty.
  void warn(const std::string& warning);
  /// Writes a warning to run.log that is already on stderr.
  void keep_warning(const std::string& warning);
  /// Notes how the coverage rose during the loop.
  void set_growth(std::vector<GrowthMoment> growth);
  /// Notes the end of the loop, why it ended and with how many pieces. Returns the record for the card.
  const RunRecord& ended(StopReason stopped_by, std::size_t pieces);

  /// Does `work` and returns its result. An error that ends `work` is logged before it is passed on.
  template <class Work>
  auto watch(Work work) {
    try {
      return work();
    } catch (const Interrupted& interrupted) {
      log_.info("end: stopped by " + std::string(stop_word(interrupted.reason)) + " before the first round");
      throw;
    } catch (const std::exception& error) {
      log_.error(error.what());
      throw;
    }
  }

 private:
  RunLog log_;
  RunRecord record_;
};

}  // namespace tessera
