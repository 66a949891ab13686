// Replacement trials on any number of ranks. The answers equal those of one rank, in the order of the questions; a worker's errors come
// back, too.
#include "comm/teams/replacer_team.h"

#include <gtest/gtest.h>

#include "comm/teams/worker_server.h"
#include "core/base/error.h"
#include "core/matching/reference_matcher.h"
#include "core/replacing/own_replacer.h"
#include "job_fixture.h"
#include "on_all_ranks.h"
#include "support/replacement_windows.h"

namespace tessera::comm {
namespace test_replacer_team {

using tessera::test::any_windows;
using tessera::test::endless_windows;
using tessera::test::EndlessShapes;
using test::JobOutcome;
using test::on_all_ranks;
using test::run_job;

std::unique_ptr<Matcher> no_matcher() {
  return std::make_unique<ReferenceMatcher>(MatchingContext{}, 0, std::vector<ShapeModel>{});
}

/// A replacer whose answers show which windows it got: each window's box, and the number of windows in its question.
class EchoReplacer : public Replacer {
 public:
  explicit EchoReplacer(int breadth) : breadth_(breadth) {}

  int breadth() const override { return breadth_; }
  void post_replace(std::vector<ReplacementWindow> windows) override { windows_ = windows; }
  std::vector<ReplacementOutcome> take_replaced() override {
    std::vector<ReplacementOutcome> outcomes;
    for (const ReplacementWindow& window : windows_) {
      const Similarity shown{0, 0, window.box.low.x, float(breadth_)};
      outcomes.push_back({{{ShapeId{0}, shown}}, std::uint32_t(windows_.size())});
    }
    return outcomes;
  }

 private:
  int breadth_;
  std::vector<ReplacementWindow> windows_;
};

/// A replacer that fails during its work.
class FailingReplacer : public EchoReplacer {
 public:
  using EchoReplacer::EchoReplacer;
  std::vector<ReplacementOutcome> take_replaced() override { throw EnvironmentError("the memory was lost"); }
};

/// Runs `master` with all workers' replacers as one. `make_replacer` makes them on each worker.
JobOutcome with_team(Communicator& ranks, const std::function<void(Replacer&)>& master,
                     const std::function<std::unique_ptr<Replacer>(Communicator&)>& make_replacer) {
  return run_job(
      ranks,
      [&](Communicator& c) {
        master(*gather_replacers(c));
        return 0;
      },
      [&](Communicator& c) { serve(c, no_matcher(), make_replacer(c)); });
}

/// Runs with_team on all ranks of jobs that have workers, and expects no error.
void with_team_everywhere(const std::function<void(Replacer&, int workers)>& master,
                          const std::function<std::unique_ptr<Replacer>(Communicator&)>& make_replacer) {
  on_all_ranks([&](Communicator& ranks) {
    const int workers = ranks.size() - 1;
    if (workers == 0) return;
    const JobOutcome outcome = with_team(
        ranks, [&](Replacer& team) { master(team, workers); }, make_replacer);
    EXPECT_EQ(outcome.result.exit_code, 0);
    EXPECT_TRUE(outcome.reported.empty()) << outcome.reported[0];
  });
}

std::unique_ptr<Replacer> echo_of_rank(Communicator& c) { return std::make_unique<EchoReplacer>(c.rank()); }

/// Windows of one trial each. Their boxes tell them apart.
std::vector<ReplacementWindow> numbered_windows(std::size_t count) {
  std::vector<ReplacementWindow> windows(count);
  for (std::size_t i = 0; i < count; ++i) {
    windows[i].box.low.x = float(i);
    windows[i].trials = 1;
  }
  return windows;
}

TEST(ReplacerTeam, IsAsBroadAsAllWorkersTogether) {
  with_team_everywhere([](Replacer& team, int workers) { EXPECT_EQ(team.breadth(), workers * (workers + 1) / 2); },
                       echo_of_rank);
}

TEST(ReplacerTeam, AnswersStandInTheOrderOfTheQuestion) {
  with_team_everywhere(
      [](Replacer& team, int) {
        for (const std::size_t count : {40, 0, 1, 7}) {
          team.post_replace(numbered_windows(count));
          const std::vector<ReplacementOutcome> outcomes = team.take_replaced();
          ASSERT_EQ(outcomes.size(), count);
          for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(outcomes[i].pieces.size(), 1u);
            EXPECT_EQ(outcomes[i].pieces[0].canvas_from_shape.tx, float(i));
          }
        }
      },
      echo_of_rank);
}

TEST(ReplacerTeam, EachWorkerHasAsMuchAsItIsBroad) {
  with_team_everywhere(
      [](Replacer& team, int workers) {
        team.post_replace(numbered_windows(std::size_t(team.breadth())));
        std::vector<std::uint32_t> windows_of(std::size_t(workers) + 1, 0);
        for (const ReplacementOutcome& outcome : team.take_replaced()) {
          const auto worker = std::size_t(outcome.pieces.at(0).canvas_from_shape.ty);
          ++windows_of.at(worker);
        }
        for (int worker = 1; worker <= workers; ++worker) EXPECT_EQ(windows_of[std::size_t(worker)], worker);
      },
      echo_of_rank);
}

/// A replacer that also owns its shapes.
class WorkersReplacer : public Replacer {
 public:
  explicit WorkersReplacer(Communicator& ranks)
      : own_(shapes_, 1 + ranks.rank() % 3, [&ranks] { ranks.check_arrivals(); }) {}

  int breadth() const override { return own_.breadth(); }
  void post_replace(std::vector<ReplacementWindow> windows) override { own_.post_replace(windows); }
  std::vector<ReplacementOutcome> take_replaced() override { return own_.take_replaced(); }

 private:
  EndlessShapes shapes_;
  OwnReplacer own_;
};

TEST(ReplacerTeam, AnyNumberOfRanksAnswersAsOneDoes) {
  const std::vector<ReplacementWindow> windows = any_windows(9, 11);
  EndlessShapes shapes;
  OwnReplacer alone(shapes, 1, [] {});
  alone.post_replace(windows);
  const std::vector<ReplacementOutcome> expected = alone.take_replaced();
  with_team_everywhere(
      [&](Replacer& team, int) {
        team.post_replace(windows);
        EXPECT_EQ(team.take_replaced(), expected);
      },
      [](Communicator& c) { return std::make_unique<WorkersReplacer>(c); });
}

/// The last worker fails while the others work for ever. It asks no other worker, but another worker may ask it.
TEST(ReplacerTeam, AWorkersErrorEndsTheJobWhileOthersWork) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() == 1) return;
    const JobOutcome outcome = with_team(
        ranks,
        [](Replacer& team) {
          team.post_replace(endless_windows(std::size_t(2 * team.breadth())));
          team.take_replaced();
          ADD_FAILURE() << "no error came";
        },
        [](Communicator& c) -> std::unique_ptr<Replacer> {
          if (c.rank() == c.size() - 1) return std::make_unique<FailingReplacer>(1);
          return std::make_unique<WorkersReplacer>(c);
        });
    if (ranks.rank() != 0) return;
    EXPECT_EQ(outcome.result.exit_code, 1);
    ASSERT_EQ(outcome.reported.size(), 1u);
    EXPECT_NE(outcome.reported[0].find(": the memory was lost"), std::string::npos) << outcome.reported[0];
  });
}

}  // namespace test_replacer_team
}  // namespace tessera::comm
