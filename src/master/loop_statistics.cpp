#include "master/loop_statistics.h"

namespace tessera::master {

RunStatistics LoopStatistics::of_run(const LoopState& state) const {
  RunStatistics run = filling;
  copy_to_statistics(run, state);
  return run;
}

RunStatistics LoopStatistics::of_this_call(double own_s) const {
  RunStatistics work = improving;
  work.setup_processor_s = set_up_processor_s_;
  work.total_s = own_s;
  work.prune_s += filling.prune_s - earlier_.prune_s;
  work.dock_s += filling.dock_s - earlier_.dock_s;
  work.ahead_s += filling.ahead_s - earlier_.ahead_s;
  work.objective_s += filling.objective_s - earlier_.objective_s;
  work.merge_s += filling.merge_s - earlier_.merge_s;
  work.rounds += filling.rounds - earlier_.rounds;
  work.target_samples += filling.target_samples - earlier_.target_samples;
  return work;
}

}  // namespace tessera::master
