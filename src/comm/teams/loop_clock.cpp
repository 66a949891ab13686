#include "comm/teams/loop_clock.h"

#include "comm/teams/worker_team.h"
#include "core/ranks/worker_tree.h"

namespace tessera::comm {
namespace {

MessageCount difference(const TrafficCount& now, const TrafficCount& before) {
  return {now.messages - before.messages, now.bytes - before.bytes};
}

}  // namespace

LoopClock::LoopClock(Communicator& ranks)
    : ranks_(ranks),
      waited_before_s_(ranks.waited_s()),
      processor_before_s_(busy_processor_s(ranks)),
      traffic_before_(ranks.traffic()) {}

MasterTimes LoopClock::master_times(const RunStatistics& run) const {
  MasterTimes times;
  times.objective_s = run.objective_s;
  times.merge_s = run.merge_s;
  times.waiting_s = ranks_.waited_s() - waited_before_s_;
  times.ahead_s = run.ahead_s;
  times.questions_s = run.prune_s + run.dock_s + run.replace_s - times.waiting_s - times.ahead_s;
  times.loop_s = run.total_s;
  times.other_s =
      times.loop_s - times.objective_s - times.merge_s - times.questions_s - times.ahead_s - times.waiting_s;
  times.processor_s = busy_processor_s(ranks_) - processor_before_s_ - run.setup_processor_s;
  const Traffic& now = ranks_.traffic();
  times.sent = difference(now.sent_in_loop(), traffic_before_.sent_in_loop());
  times.sent_fields = difference(now.sent(Tag::update_field), traffic_before_.sent(Tag::update_field));
  return times;
}

RankStatistics LoopClock::stop(const RunStatistics& run) {
  if (ranks_.size() == 1) return {};
  const MasterTimes master = master_times(run);
  const int asked = int(place_in_tree(0, ranks_.size()).children.size());
  return {master, gather_times(ranks_), asked, run.rounds, run.target_samples};
}

}  // namespace tessera::comm
