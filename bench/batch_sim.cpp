#include "batch_sim.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <queue>

#include "core/ranks/partition.h"
#include "master/replacing.h"
#include "sim_cluster.h"

namespace tessera::bench {
namespace {

namespace sg4 = simgrid::s4u;

using Windows = std::vector<std::size_t>;  // of the case

/// The rank and all below it.
int subtree(int rank, const BatchScenario& scenario) {
  int ranks = 1;
  for (const int child : place_in_tree(rank, scenario.workers + 1, scenario.fan_out).children) {
    ranks += subtree(child, scenario);
  }
  return ranks;
}

/// The play of one rank. A message holds no windows: a rank computes its windows in the way of the rank that asks it.
class RankPlay {
 public:
  RankPlay(const BatchScenario& scenario, int rank)
      : case_(*scenario.measured),
        scenario_(scenario),
        rank_(rank),
        children_(place_in_tree(rank, scenario.workers + 1, scenario.fan_out).children) {
    for (const int child : children_) breadths_.push_back(subtree(child, scenario) * scenario.cores);
    if (rank > 0) breadths_.push_back(scenario.cores);
    inbox(rank_)->set_receiver(sg4::Actor::self());
    for (const int child : children_) outbox(child)->set_receiver(sg4::Actor::self());
  }

  double lead() {
    work(case_.master_s);
    for (std::size_t begin = 0; begin < case_.windows.size(); begin += at_a_time()) {
      Windows windows;
      for (std::size_t i = begin; i < std::min(begin + at_a_time(), case_.windows.size()); ++i) windows.push_back(i);
      share_out(windows);
      join();
    }
    return busy_s_;
  }

  void serve() {
    for (std::size_t begin = 0; begin < case_.windows.size(); begin += at_a_time()) answer();
  }

 private:
  /// Windows of a question of the master (master/replacing.h).
  std::size_t at_a_time() const {
    return master::kWindowsAtATime * std::size_t(scenario_.workers) * std::size_t(scenario_.cores);
  }

  void answer() {
    const auto windows = *std::unique_ptr<Windows>(inbox(rank_)->get<Windows>());
    work(case_.unpack_s * double(windows.size()));
    share_out(windows);
    pass(on_own_cores_s(shares_.back()));
    join();
    work(case_.reply_s * double(windows.size()));
    double bytes = 0;
    for (const std::size_t i : windows) bytes += case_.windows[i].reply_bytes;
    send(outbox(rank_), bytes);
  }

  void work(double seconds) {
    pass(seconds);
    busy_s_ += seconds;
  }

  void share_out(const Windows& windows) {
    shares_.clear();
    std::vector<std::uint64_t> trials;
    for (const std::size_t i : windows) trials.push_back(case_.windows[i].trials);
    for (const Windows& of_part : fair_shares(trials, breadths_)) {
      Windows share;
      for (const std::size_t k : of_part) share.push_back(windows[k]);
      shares_.push_back(share);
    }
    for (std::size_t c = 0; c < children_.size(); ++c) {
      work(case_.request_s * double(shares_[c].size()));
      double bytes = 0;
      for (const std::size_t i : shares_[c]) bytes += case_.windows[i].request_bytes;
      inbox(children_[c])->put_init(new Windows(shares_[c]), std::uint64_t(std::max(1., bytes)))->detach();
    }
  }

  /// The last one first, as ReplacerTeam does.
  void join() {
    for (std::size_t c = children_.size(); c-- > 0;) {
      outbox(children_[c])->get<int>();
      work(case_.reply_s * double(shares_[c].size()));
    }
  }

  /// The time that the cores of one rank take for the windows. As in core/replacing/replaced_windows.h, the windows with most
  /// trials come first, and each goes to the core that is free first.
  double on_own_cores_s(Windows windows) const {
    std::stable_sort(windows.begin(), windows.end(),
                     [&](std::size_t a, std::size_t b) { return case_.windows[a].trials > case_.windows[b].trials; });
    std::priority_queue<double, std::vector<double>, std::greater<>> free_s;
    for (int core = 0; core < scenario_.cores; ++core) free_s.push(0);
    double end_s = 0;
    for (const std::size_t i : windows) {
      const double until_s = free_s.top() + case_.windows[i].work_s;
      free_s.pop();
      free_s.push(until_s);
      end_s = std::max(end_s, until_s);
    }
    return end_s;
  }

  const ReplacingCase& case_;
  const BatchScenario& scenario_;
  int rank_;
  std::vector<int> children_;
  std::vector<int> breadths_;    // of the children and those below them; then the rank's own
  std::vector<Windows> shares_;  // as many
  double busy_s_ = 0;
};

SimulatedBatch play(const BatchScenario& scenario) {
  std::vector<sg4::ActorPtr> workers;
  for (int rank = 1; rank <= scenario.workers; ++rank) {
    workers.push_back(sg4::Actor::create("worker" + std::to_string(rank), host_of(rank),
                                         [&scenario, rank] { RankPlay(scenario, rank).serve(); }));
  }
  sg4::this_actor::sleep_for(1);  // all mailboxes have their receivers
  const double before_s = sg4::Engine::get_clock();
  const double busy_s = RankPlay(scenario, 0).lead();
  const double batch_s = sg4::Engine::get_clock() - before_s;
  for (const sg4::ActorPtr& worker : workers) worker->join();
  return {batch_s, busy_s};
}

}  // namespace

std::vector<SimulatedBatch> simulate_batches(const std::vector<BatchScenario>& scenarios, const Cluster& cluster) {
  int ranks = 2;
  for (const BatchScenario& scenario : scenarios) ranks = std::max(ranks, scenario.workers + 1);
  std::vector<SimulatedBatch> batches;
  simulate(ranks, cluster, [&] {
    for (const BatchScenario& scenario : scenarios) batches.push_back(play(scenario));
  });
  return batches;
}

}  // namespace tessera::bench
