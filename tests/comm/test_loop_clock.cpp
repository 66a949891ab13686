// Times of the ranks: each rank's stages add up to its loop, and the bytes sent equal the bytes received.
#include "comm/teams/loop_clock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "comm/teams/replacer_team.h"
#include "comm/teams/worker_server.h"
#include "comm/teams/worker_team.h"
#include "core/base/stopwatch.h"
#include "core/ranks/worker_tree.h"
#include "idle_replacer.h"
#include "job_fixture.h"
#include "on_all_ranks.h"
#include "support/idle_matcher.h"

namespace tessera::comm {
namespace test_loop_clock {

using test::on_all_ranks;
using test::run_job;

constexpr std::chrono::milliseconds kNap{20};
constexpr double kNap_s = 0.02;
constexpr double kRounding_s = 1e-6;

/// A matcher that takes time to count, and has nothing to dock or refine.
class SlowCounter : public tessera::test::IdleMatcher {
 public:
  explicit SlowCounter(ShapeRange shapes) : shapes_(shapes) {}
  ShapeRange shapes() const override { return shapes_; }
  void post_count(const CountRequest& request) override { samples_ = tessera::test::samples_asked(request); }
  std::vector<DistanceHistogram> take_count() override {
    std::this_thread::sleep_for(kNap);
    return std::vector<DistanceHistogram>(samples_);
  }

 private:
  ShapeRange shapes_;
  std::size_t samples_ = 0;
};

/// A replacer that takes time for every question.
class SlowReplacer : public test::IdleReplacer {
 public:
  std::vector<ReplacementOutcome> take_replaced() override {
    std::this_thread::sleep_for(kNap);
    return IdleReplacer::take_replaced();
  }
};

template <class Times, class Stages>
double sum_of_stages(const Times& times, const Stages& stages) {
  double sum_s = 0;
  for (const auto& stage : stages) {
    EXPECT_GE(times.*stage.seconds, 0) << stage.name;
    sum_s += times.*stage.seconds;
  }
  return sum_s;
}

/// Plays a loop of two regions with one round each, and counts in `run` as a master does.
void play_loop(Matcher& team, Replacer& replacers, RunStatistics& run) {
  const Stopwatch loop;
  for (run.rounds = 0; run.rounds < 2; ++run.rounds) {
    Stopwatch stage;
    team.start_field(3, 2, {});
    team.update_field({{{0, 0, 3, 2}, std::vector<float>(6)}});
    run.merge_s += stage.lap();
    team.post_count({std::vector<TargetSample>(5), std::vector<std::uint32_t>(5, 9)});
    team.take_count();
    run.prune_s += stage.lap();
    team.post_dock({});
    const Stopwatch ahead;  // the master does work of its own while it waits
    std::this_thread::sleep_for(kNap / 10);
    run.ahead_s += ahead.seconds();
    team.take_dock();
    run.dock_s += stage.lap();
    replacers.post_replace(std::vector<ReplacementWindow>(3));
    replacers.take_replaced();
    run.replace_s += stage.lap();
  }
  run.total_s = loop.seconds();
}

void expect_master(const MasterTimes& master, int asked) {
  EXPECT_NEAR(sum_of_stages(master, kMasterStages), master.loop_s, kRounding_s);
  EXPECT_GE(master.waiting_s, 2 * 2 * kNap_s * 0.9);
  EXPECT_GE(master.ahead_s, 2 * kNap_s / 10);
  EXPECT_EQ(master.sent.messages, std::uint64_t(asked) * 2 * 5);
  EXPECT_EQ(master.sent_fields.messages, std::uint64_t(asked) * 2);
  EXPECT_GE(master.sent_fields.bytes, master.sent_fields.messages * 6 * sizeof(float));
  EXPECT_LT(master.sent_fields.bytes, master.sent.bytes);
}

/// Expects the times of a worker that asks `asked` workers below it.
void expect_worker(const WorkerTimes& worker, int asked) {
  EXPECT_NEAR(sum_of_stages(worker, kWorkerStages), worker.loop_s, kRounding_s);
  EXPECT_GE(worker.count_s, 2 * kNap_s * 0.99);
  EXPECT_EQ(worker.counts, 2u);
  EXPECT_EQ(worker.docks, 2u);
  EXPECT_EQ(worker.refines, 0u);
  EXPECT_GE(worker.replace_s, 2 * kNap_s * 0.99);
  EXPECT_EQ(worker.replaces, 2u);
  EXPECT_EQ(worker.sent.messages, 6u + std::uint64_t(asked) * 2 * 5);
  EXPECT_GE(worker.sent.bytes, 2 * 5 * sizeof(DistanceHistogram));
}

int asked_by(int rank, const Communicator& ranks) { return int(place_in_tree(rank, ranks.size()).children.size()); }

TEST(LoopClock, StagesOfEveryRankAddUpLoopAfterLoop) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() == 1) return;
    const auto outcome = run_job(
        ranks,
        [](Communicator& c) {
          const auto team = gather_workers(c);
          const auto replacers = gather_replacers(c);
          for (int loop = 0; loop < 2; ++loop) {
            LoopClock clock(c);
            RunStatistics run;
            play_loop(*team, *replacers, run);
            const RankStatistics times = clock.stop(run);
            EXPECT_EQ(times.rounds, 2u);
            EXPECT_EQ(times.asked, asked_by(0, c));
            expect_master(times.master, asked_by(0, c));
            EXPECT_EQ(times.workers.size(), std::size_t(c.size() - 1));
            for (int worker = 1; worker < c.size(); ++worker) {
              expect_worker(times.workers[std::size_t(worker) - 1], asked_by(worker, c));
            }
          }
          return 0;
        },
        [](Communicator& c) {
          serve(c, std::make_unique<SlowCounter>(ShapeRange{std::uint32_t(c.rank()), std::uint32_t(c.rank() + 1)}),
                std::make_unique<SlowReplacer>());
        });
    EXPECT_EQ(outcome.result.exit_code, 0);
  });
}

TEST(LoopClock, AMasterWithoutWorkersHasNothingToSay) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() > 1) return;
    EXPECT_TRUE(LoopClock(ranks).stop({}).workers.empty());
  });
}

}  // namespace test_loop_clock
}  // namespace tessera::comm
