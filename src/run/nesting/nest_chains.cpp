#include "run/nesting/nest_chains.h"

#include <algorithm>
#include <mutex>
#include <numeric>
#include <vector>

#include "comm/encode.h"
#include "comm/heartbeat.h"
#include "comm/rank_watch.h"
#include "core/base/rank_pool.h"
#include "core/base/stop.h"
#include "core/base/stopwatch.h"
#include "products/nesting/layout/column_layout.h"
#include "run/nesting/nest_messages.h"
#include "run/program_identity.h"

namespace tessera {
namespace {

/// The best layout and the progress of this rank's chains. Several threads may call it: a mutex lets one in at a time.
class ChainResults {
 public:
  /// `looked` is called for every piece that is moved.
  using Looked = std::function<void(double done, const NestLayout& best)>;
  ChainResults(std::size_t chains, Looked looked) : done_(chains, 0), looked_(std::move(looked)) {}

  void add(const NestLayout& layout) {
    const std::lock_guard lock(mutex_);
    if (best_.pieces.empty() || is_better(layout, best_)) best_ = layout;
  }

  void report_progress(std::size_t chain, double done) {
    const std::lock_guard lock(mutex_);
    done_[chain] = done;
    looked_(std::accumulate(done_.begin(), done_.end(), 0.0) / double(done_.size()), best_);
  }

  /// The best layout. To be called when no chain is at work any more.
  const NestLayout& best() const { return best_; }

 private:
  std::mutex mutex_;
  std::vector<double> done_;  // of each chain
  NestLayout best_;           // without a piece: none yet
  Looked looked_;
};

/// The number of this rank's chains: first, first + step and so on.
std::size_t chains_of(const comm::Communicator& ranks, const NestEffort& effort) {
  return ranks.rank() < effort.chains ? std::size_t((effort.chains - 1 - ranks.rank()) / ranks.size()) + 1 : 0;
}

/// Runs this rank's chains, at least one, and returns their best layout.
NestLayout best_of(const NestSearch& search, const comm::Communicator& ranks, ChainResults& findings) {
  std::vector<NestLayout> layouts(chains_of(ranks, search.effort));
  const PosedItems shapes = posed_items(search.problem, [&] { findings.report_progress(0, 0); });
  parallel_for(layouts.size(), [&](std::size_t i) {
    layouts[i] = nest_chain(
        search.problem, shapes, search.effort, search.seed, ranks.rank() + int(i) * ranks.size(),
        [&](const NestLayout& layout) { findings.add(layout); },
        [&](double done) { findings.report_progress(i, done); });
  });
  return best_layout(layouts);
}

void send(comm::Communicator& ranks, const NestReport& report) {
  ranks.send(0, comm::Tag::nest_layout, comm::encode(report));
}

NestReport receive(comm::Communicator& ranks, int from) {
  return comm::decode<NestReport>(ranks.receive(from, comm::Tag::nest_layout));
}

NestLayout last_of(comm::Communicator& ranks, int worker) {
  for (;;) {
    NestReport report = receive(ranks, worker);
    if (report.is_last) return std::move(report.layout);
  }
}

/// Adds all layouts that have arrived by now. To be called after a stop was asked for.
void add_arrived(comm::Communicator& ranks, int worker, ChainResults& findings) {
  try {
    for (;;) {
      const NestLayout layout = receive(ranks, worker).layout;
      if (!layout.pieces.empty()) findings.add(layout);
    }
  } catch (const Interrupted&) {  // nothing more is there
  }
}

/// Runs a worker's chains. Reports the best layout to rank 0 regularly, even if it has not changed: rank 0 takes a worker
/// for lost that sends nothing for RankWatch::kMostBusy times `silence_s`.
void search_and_tell(const NestSearch& search, comm::Communicator& ranks, double silence_s) {
  // Rank 0 keeps all reports until the end, so a longer search reports less often.
  constexpr double kLeastPause_s = 0.25, kPausePart = 0.02;
  const double most_pause_s = silence_s * comm::RankWatch::kMostBusy / 6;
  const Stopwatch watch;
  double sent_s = -1;
  ChainResults findings(chains_of(ranks, search.effort), [&](double, const NestLayout& best) {
    ranks.check_arrivals();
    const double now_s = watch.seconds();
    if (now_s - sent_s < std::clamp(kPausePart * now_s, kLeastPause_s, most_pause_s)) return;
    send(ranks, {best, false});
    sent_s = now_s;
  });
  send(ranks, {best_of(search, ranks, findings), true});
}

/// Waits, with heartbeats, for rank 0 to end the job; the other ranks may still be at work.
[[noreturn]] void wait_until_job_ends(comm::Communicator& ranks) {
  for (;;) ranks.receive(0, comm::Tag::nest_layout);  // which never comes: JobEnded
}

}  // namespace

NestOutcome best_nesting(comm::Communicator& ranks, const NestProblem& problem, const NestEffort& effort,
                         std::uint64_t seed, const NestProgress& progress, const StopQuestion& shall_stop) {
  ranks.interrupt_waits_when(shall_stop);
  const StopCheck check_stop = stop_check(shall_stop);
  const int workers = std::min(ranks.size(), effort.chains) - 1;
  ChainResults findings(chains_of(ranks, effort), [&](double done, const NestLayout& best) {
    ranks.check_arrivals();
    progress(done, best);
    check_stop();
  });
  findings.add(ColumnLayout(problem).all());
  try {
    const NestSearch search{problem, effort, seed};
    announce_program(ranks, program_identity());
    ranks.broadcast(comm::encode(search));
    std::vector<NestLayout> of_ranks{best_of(search, ranks, findings)};
    for (int worker = 1; worker <= workers; ++worker) of_ranks.push_back(last_of(ranks, worker));
    return {best_layout(of_ranks), std::nullopt};
  } catch (const Interrupted& stop) {
    for (int worker = 1; worker <= workers; ++worker) add_arrived(ranks, worker, findings);
    return {findings.best(), stop.reason};
  }
}

void work_on_nesting(comm::Communicator& ranks, double silence_s) {
  check_program(ranks, program_identity());
  const comm::HeartbeatSender heart(ranks, silence_s);
  const auto search = comm::decode<NestSearch>(ranks.broadcast({}));
  if (chains_of(ranks, search.effort) > 0) search_and_tell(search, ranks, silence_s);
  wait_until_job_ends(ranks);
}

}  // namespace tessera
