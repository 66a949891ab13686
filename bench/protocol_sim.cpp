#include "protocol_sim.h"

#include <algorithm>
#include <string>

#include "core/base/portable_math.h"
#include "sim_cluster.h"

namespace tessera::bench {
namespace {

namespace sg4 = simgrid::s4u;

constexpr int kRounds = 3;  // all alike

/// The kinds of messages of a round, with what they weigh and what the workers do for them.
struct Question {
  double work_s;
  double request_bytes;  // to each worker of a subtree, where `own`; else the same to all
  double reply_bytes;
  bool own;        // a part for each worker alone
  double ahead_s;  // what the master does before it waits for the answers
};

std::vector<Question> questions_of(const RoundCosts& c) {
  std::vector<Question> questions{{c.measure_s, 1, 1, true, 0}};  // its bytes are counted with those of refine
  questions.insert(questions.end(), std::size_t(c.counts), {c.count_s, c.request_bytes, c.reply_bytes, false, 0});
  questions.push_back({c.dock_s, c.request_bytes, c.reply_bytes, false, c.ahead_s});
  questions.push_back({c.refine_s, c.refine_request_bytes, c.refine_reply_bytes, true, 0});
  return questions;
}

/// The rank and all below it.
int subtree(int rank, const Scenario& scenario) {
  int ranks = 1;
  for (const int child : place_in_tree(rank, scenario.costs.workers + 1, scenario.fan_out).children) {
    ranks += subtree(child, scenario);
  }
  return ranks;
}

/// The play of one rank in a scenario.
class RankPlay {
 public:
  RankPlay(const Scenario& scenario, int rank)
      : costs_(scenario.costs),
        rank_(rank),
        children_(place_in_tree(rank, scenario.costs.workers + 1, scenario.fan_out).children),
        below_(subtree(rank, scenario)) {
    for (const int child : children_) subtrees_.push_back(subtree(child, scenario));
    // Deterministic, from -1 to 1: who is slower than others and by how much.
    const double random = double(mix_bits(std::uint64_t(rank)) >> 11) / double(1ull << 53);
    slowness_ = costs_.workers > 1 ? 1 + costs_.imbalance * (2 * random - 1) : 1;
    inbox(rank_)->set_receiver(sg4::Actor::self());
    for (const int child : children_) outbox(child)->set_receiver(sg4::Actor::self());
  }

  double lead() {
    for (int round = 0; round < kRounds; ++round) {
      send_field();
      for (const Question& question : questions_of(costs_)) {
        pass_on(question, costs_.ask_s);
        compute(question.ahead_s);
        join();
      }
      compute(costs_.master_s);
    }
    return busy_s_;
  }

  void serve() {
    for (int round = 0; round < kRounds; ++round) {
      receive(inbox(rank_));
      send_field();
      compute(costs_.field_s);
      for (const Question& question : questions_of(costs_)) {
        receive(inbox(rank_));
        pass_on(question, costs_.ask_s);
        compute(question.work_s * slowness_ + costs_.messages_s);
        join();
        send(outbox(rank_), question.reply_bytes * (question.own ? below_ : 1));
      }
    }
  }

 private:
  void compute(double seconds) {
    if (seconds <= 0) return;
    pass(seconds);
    busy_s_ += seconds;
  }

  /// A rank that has waited sleeps between its looks.
  void receive(sg4::Mailbox* mailbox) {
    const double before_s = sg4::Engine::get_clock();
    mailbox->get<int>();
    if (sg4::Engine::get_clock() > before_s) sg4::this_actor::sleep_for(costs_.notice_s);
  }

  void send_field() {
    for (const int child : children_) send(inbox(child), costs_.field_bytes);
  }

  void pass_on(const Question& question, double ask_s) {
    for (std::size_t k = 0; k < children_.size(); ++k) {
      compute(ask_s);
      send(inbox(children_[k]), question.request_bytes * (question.own ? subtrees_[k] : 1));
    }
  }

  void join() {
    for (const int child : children_) {
      receive_in_turn(child);
      compute(costs_.join_s);
    }
  }

  /// Answers arrive while others are waited for: only the first wait of a question is one of an idle rank.
  void receive_in_turn(int child) {
    if (child == children_.front()) {
      receive(outbox(child));
    } else {
      outbox(child)->get<int>();
    }
  }

  const RoundCosts& costs_;
  int rank_;
  std::vector<int> children_;
  int below_;  // itself included
  std::vector<int> subtrees_;
  double slowness_ = 1;
  double busy_s_ = 0;
};

SimulatedRound play(const Scenario& scenario) {
  std::vector<sg4::ActorPtr> workers;
  for (int rank = 1; rank <= scenario.costs.workers; ++rank) {
    workers.push_back(sg4::Actor::create("worker" + std::to_string(rank), host_of(rank),
                                         [&scenario, rank] { RankPlay(scenario, rank).serve(); }));
  }
  sg4::this_actor::sleep_for(1);  // all mailboxes have their receivers
  const double before_s = sg4::Engine::get_clock();
  const double busy_s = RankPlay(scenario, 0).lead();
  const double round_s = (sg4::Engine::get_clock() - before_s) / kRounds;
  for (const sg4::ActorPtr& worker : workers) worker->join();
  return {round_s, busy_s / kRounds};
}

}  // namespace

std::vector<SimulatedRound> simulate_rounds(const std::vector<Scenario>& scenarios, const Cluster& cluster) {
  int ranks = 2;
  for (const Scenario& scenario : scenarios) ranks = std::max(ranks, scenario.costs.workers + 1);
  std::vector<SimulatedRound> rounds;
  simulate(ranks, cluster, [&] {
    for (const Scenario& scenario : scenarios) rounds.push_back(play(scenario));
  });
  return rounds;
}

}  // namespace tessera::bench
