// A matcher on other ranks behaves like a local one: the same requests reach it, and the same replies and errors come back.
#include "comm/teams/worker_team.h"

#include <gtest/gtest.h>

#include "comm/teams/worker_server.h"
#include "core/base/error.h"
#include "core/matching/reference_matcher.h"
#include "idle_replacer.h"
#include "job_fixture.h"
#include "on_all_ranks.h"
#include "support/matcher_round.h"

namespace tessera::comm {
namespace test_worker_team {

using tessera::test::MatchingScene;
using tessera::test::Round;
using tessera::test::set_field;
using test::IdleReplacer;
using test::on_all_ranks;
using test::run_job;

/// A matcher whose answers show the requests that it got.
class EchoMatcher : public Matcher {
 public:
  explicit EchoMatcher(ShapeRange shapes) : shapes_(shapes) {}

  ShapeRange shapes() const override { return shapes_; }
  void start_field(int width, int height, Vec2 origin) override {
    field_ = Grid<float>(width, height);
    origin_ = origin;
  }
  void update_field(const std::vector<FieldPatch>& patches) override { write_patches(patches, field_); }
  void limit(const StanceLimits& limits) override { limits_ = limits; }

  void post_count(const CountRequest& request) override {
    if (!request.samples.empty()) samples_ = request.samples;
    counted_ = request;
  }
  std::vector<DistanceHistogram> take_count() override {
    std::vector<DistanceHistogram> counts;
    for (std::size_t t = 0; t < counted_.bins.size(); ++t) {
      if (counted_.bins[t] == 0) continue;
      counts.push_back({edge_number(samples_[t].id), shapes_.size(), counted_.bins[t], counted_.segment_stride});
    }
    return counts;
  }

  void post_dock(const DockRequest& request) override { request_ = request; }
  /// Returns one docking for each sample and shape, best first. Its pose shows the field and the number of shapes used up.
  DockReply take_dock() override {
    DockReply reply;
    for (std::uint32_t t = 0; t < request_.samples.size(); ++t) {
      for (std::uint32_t shape = shapes_.end; shape-- > shapes_.begin;) {
        const float field_sum = field_(0, 0) + field_(field_.width() - 1, field_.height() - 1);
        const Similarity shown{origin_.x, origin_.y, field_sum, float(limits_.used_up.size())};
        reply.dockings.push_back({t, ShapeId{shape}, request_.bin_limit[t], 0, float(shape), shown});
      }
    }
    reply.evaluated = request_.tangent_dockings;
    return reply;
  }

  void post_refine(const std::vector<Docking>& dockings) override { dockings_ = dockings; }
  std::vector<RefinedDocking> take_refine() override {
    std::vector<RefinedDocking> refined;
    for (const Docking& docking : dockings_) refined.push_back({docking, {docking.key, 0, 0, 0, 0}, true});
    return refined;
  }

  void post_measure(const std::vector<Docking>& dockings) override { dockings_ = dockings; }
  std::vector<DockingTerms> take_measure() override {
    std::vector<DockingTerms> terms;
    for (const Docking& docking : dockings_) terms.push_back({docking.key, 1, 2, 3, 4});
    return terms;
  }

 private:
  ShapeRange shapes_;
  Grid<float> field_;
  Vec2 origin_;
  std::vector<TargetSample> samples_;
  CountRequest counted_;
  DockRequest request_;
  StanceLimits limits_;
  std::vector<Docking> dockings_;
};

/// Returns the part of the `shapes` shapes that worker `rank` has.
ShapeRange part_of(std::uint32_t shapes, const Communicator& ranks) {
  const std::uint32_t workers = std::uint32_t(ranks.size() - 1);
  const std::uint32_t worker = std::uint32_t(ranks.rank() - 1);
  return {shapes * worker / workers, shapes * (worker + 1) / workers};
}

std::vector<TargetSample> samples_of_edges(std::initializer_list<std::uint32_t> edges) {
  std::vector<TargetSample> samples;
  for (const std::uint32_t edge : edges) samples.emplace_back().id = SampleId{edge};
  return samples;
}

CountRequest count_of_edges(std::initializer_list<std::uint32_t> edges) {
  return {samples_of_edges(edges), std::vector<std::uint32_t>(edges.size(), 9), 3};
}

/// Runs `master` with all workers' matchers as one. `make_matcher` makes them on each worker.
template <class MakeMatcher>
void with_team(const std::function<void(Matcher&)>& master, MakeMatcher make_matcher) {
  on_all_ranks([&](Communicator& ranks) {
    if (ranks.size() == 1) return;
    const auto outcome = run_job(
        ranks,
        [&](Communicator& c) {
          master(*gather_workers(c));
          return 0;
        },
        [&](Communicator& c) { serve(c, make_matcher(c), std::make_unique<IdleReplacer>()); });
    EXPECT_EQ(outcome.result.exit_code, 0);
    EXPECT_TRUE(outcome.reported.empty()) << outcome.reported[0];
  });
}

/// With only two shapes, one of three workers has none.
constexpr std::uint32_t kEchoShapes = 2;

void with_echo_team(const std::function<void(Matcher&)>& master) {
  with_team(master, [](Communicator& c) { return std::make_unique<EchoMatcher>(part_of(kEchoShapes, c)); });
}

TEST(WorkerTeam, KnowsTheWorkersShapes) {
  with_echo_team([](Matcher& team) {
    EXPECT_EQ(team.shapes().begin, 0u);
    EXPECT_EQ(team.shapes().end, kEchoShapes);
  });
}

TEST(WorkerTeam, CountsReachAllWorkersAndAreAdded) {
  with_echo_team([](Matcher& team) {
    team.post_count(count_of_edges({7}));
    const auto counts = team.take_count();
    ASSERT_EQ(counts.size(), 1u);
    const std::uint32_t workers = counts[0][0] / 7;
    EXPECT_EQ(counts[0], (DistanceHistogram{7 * workers, kEchoShapes, 9 * workers, 3 * workers}));
    team.post_count({{}, {}});
    EXPECT_TRUE(team.take_count().empty());
  });
}

/// The samples are sent only once.
TEST(WorkerTeam, CountsGoOnWithTheSamplesOfTheLastOne) {
  with_echo_team([](Matcher& team) {
    team.post_count(count_of_edges({7, 8, 11}));
    const std::uint32_t workers = team.take_count().at(0)[0] / 7;
    team.post_count({{}, {0, 5, 6}});
    const auto counts = team.take_count();
    ASSERT_EQ(counts.size(), 2u);
    EXPECT_EQ(counts[0], (DistanceHistogram{8 * workers, kEchoShapes, 5 * workers, workers}));
    EXPECT_EQ(counts[1], (DistanceHistogram{11 * workers, kEchoShapes, 6 * workers, workers}));
  });
}

/// A matcher that counts in three steps.
class SteppingMatcher : public EchoMatcher {
 public:
  using EchoMatcher::EchoMatcher;
  void post_count(const CountRequest& request) override {
    EchoMatcher::post_count(request);
    steps_left_ = 3;
  }
  bool step_count() override { return --steps_left_ > 0; }
  std::vector<DistanceHistogram> take_count() override {
    EXPECT_EQ(steps_left_, 0);
    return EchoMatcher::take_count();
  }

 private:
  int steps_left_ = 0;
};

TEST(WorkerTeam, OwnDevicesTakeAllStepsOfEveryCountWhileTheWorkersCount) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() == 1) return;
    run_job(
        ranks,
        [](Communicator& c) {
          const ShapeRange own{kEchoShapes, kEchoShapes + 1};
          const auto team = gather_workers(c, std::make_unique<SteppingMatcher>(own));
          for (int count = 0; count < 2; ++count) {
            team->post_count(count_of_edges({7}));
            EXPECT_EQ(team->take_count().at(0)[1], kEchoShapes + 1);
          }
          return 0;
        },
        [](Communicator& c) {
          serve(c, std::make_unique<EchoMatcher>(part_of(kEchoShapes, c)), std::make_unique<IdleReplacer>());
        });
  });
}

TEST(WorkerTeam, DockingsSeeTheFieldAsItWasWhenPosted) {
  with_echo_team([](Matcher& team) {
    team.start_field(30, 20, {-5.5f, 2.f});
    team.update_field({{{0, 0, 30, 20}, std::vector<float>(600, 1.f)}});
    team.post_dock({samples_of_edges({1, 2}), {5, 9}, 300});
    team.update_field({{{29, 19, 30, 20}, {40.f}}, {{29, 19, 30, 20}, {41.f}}});
    const DockReply before = team.take_dock();
    ASSERT_EQ(before.dockings.size(), 2 * kEchoShapes);
    EXPECT_EQ(before.dockings[0], (Docking{0, ShapeId{1}, 5, 0, 1.f, {-5.5f, 2.f, 2.f, 0}}));
    EXPECT_EQ(before.dockings[3], (Docking{1, ShapeId{0}, 9, 0, 0.f, {-5.5f, 2.f, 2.f, 0}}));
    EXPECT_EQ(before.evaluated % 300, 0u);
    team.post_dock({samples_of_edges({1}), {5}, 300});
    EXPECT_EQ(team.take_dock().dockings.at(0).canvas_from_shape.tx, 42.f);
  });
}

TEST(WorkerTeam, LimitsReachAllWorkers) {
  with_echo_team([](Matcher& team) {
    team.start_field(30, 20, {});
    team.limit({0, 1, 50.f, {ShapeId{0}, ShapeId{3}}});
    team.post_dock({samples_of_edges({1}), {5}, 300});
    for (const Docking& docking : team.take_dock().dockings) EXPECT_EQ(docking.canvas_from_shape.ty, 2.f);
  });
}

TEST(WorkerTeam, RefinedDockingsComeBackInTheOrderPosted) {
  with_echo_team([](Matcher& team) {
    std::vector<Docking> dockings(9);
    for (std::uint32_t i = 0; i < dockings.size(); ++i) {
      dockings[i].shape = ShapeId{i * 5 % kEchoShapes};
      dockings[i].key = float(i);
    }
    team.post_refine(dockings);
    const auto refined = team.take_refine();
    ASSERT_EQ(refined.size(), dockings.size());
    for (std::size_t i = 0; i < refined.size(); ++i) {
      EXPECT_EQ(refined[i], (RefinedDocking{dockings[i], {float(i), 0, 0, 0, 0}, true}));
    }
  });
}

TEST(WorkerTeam, AQuestionMayBePostedBeforeTheLastOneIsTaken) {
  with_echo_team([](Matcher& team) {
    team.post_count(count_of_edges({3, 4, 5}));
    team.post_refine(std::vector<Docking>(100000));
    EXPECT_EQ(team.take_refine().size(), 100000u);
    EXPECT_EQ(team.take_count().size(), 3u);
  });
}

TEST(WorkerTeam, LargeMessagesBothWaysDoNotLockUp) {
  constexpr int kNodes = 5000;  // gives a field of 100 MB
  constexpr std::uint32_t kShapes = 60;
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() != 2) return;
    run_job(
        ranks,
        [](Communicator& c) {
          const auto team = gather_workers(c);
          auto* const worker = team.get();
          worker->start_field(kNodes, kNodes, {});
          const std::vector<FieldPatch> whole{
              {{0, 0, kNodes, kNodes}, std::vector<float>(std::size_t(kNodes) * kNodes, 2.f)}};
          worker->update_field(whole);
          for (int i = 0; i < 2; ++i)
            worker->post_refine(std::vector<Docking>(1'000'000));  // sends 40 MB and gets 60 MB back
          worker->update_field(whole);
          for (int i = 0; i < 2; ++i)
            EXPECT_EQ(c.receive(1, Tag::refine_reply).size() / 1'000'000, sizeof(RefinedDocking));
          return 0;
        },
        [](Communicator& c) {
          serve(c, std::make_unique<EchoMatcher>(ShapeRange{0, kShapes}), std::make_unique<IdleReplacer>());
        });
  });
}

/// A matcher that fails during its work.
class FailingMatcher : public EchoMatcher {
 public:
  using EchoMatcher::EchoMatcher;
  void post_dock(const DockRequest&) override { throw EnvironmentError("the device was lost"); }
};

TEST(WorkerTeam, AWorkersErrorReachesWhoeverTakes) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() == 1) return;
    const auto outcome = run_job(
        ranks,
        [](Communicator& c) {
          const auto team = gather_workers(c);
          team->post_count(count_of_edges({1}));
          EXPECT_EQ(team->take_count().size(), 1u);
          team->post_dock({});
          team->take_dock();
          ADD_FAILURE() << "no error came";
          return 0;
        },
        [](Communicator& c) {
          serve(c, std::make_unique<FailingMatcher>(part_of(kEchoShapes, c)), std::make_unique<IdleReplacer>());
        });
    if (ranks.rank() != 0) return;
    EXPECT_EQ(outcome.result.exit_code, 1);
    ASSERT_EQ(outcome.reported.size(), 1u);
    EXPECT_NE(outcome.reported[0].find(": the device was lost"), std::string::npos) << outcome.reported[0];
  });
}

TEST(WorkerTeam, AWorkerThatCannotStartEndsTheJob) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() == 1) return;
    const auto outcome = run_job(
        ranks,
        [](Communicator& c) {
          gather_workers(c);
          return 0;
        },
        [](Communicator& c) {
          if (c.rank() == c.size() - 1) throw InputError("library.h5: not a library");
          serve(c, std::make_unique<EchoMatcher>(part_of(kEchoShapes, c)), std::make_unique<IdleReplacer>());
        });
    EXPECT_EQ(outcome.result.exit_code, ranks.rank() == 0 ? 2 : 0);
  });
}

/// The reference matcher for the shapes `range` of the scene.
ReferenceMatcher reference_matcher(const MatchingScene& scene, ShapeRange range) {
  return {scene.context, range.begin, {scene.models.begin() + range.begin, scene.models.begin() + range.end}};
}

TEST(WorkerTeam, PartsOfTheLibraryOnAnyNumberOfRanksAnswerAsTheWhole) {
  const MatchingScene scene = tessera::test::make_scene();
  const std::uint32_t shapes = std::uint32_t(scene.models.size());
  ReferenceMatcher whole = reference_matcher(scene, {0, shapes});
  set_field(whole, scene.field);
  const Round expected = run_round(whole, scene);
  ASSERT_GT(expected.docked.dockings.size(), 20u);
  with_team(
      [&](Matcher& team) {
        set_field(team, scene.field);
        expect_same_round(run_round(team, scene), expected);
      },
      [&](Communicator& c) {
        return std::make_unique<ReferenceMatcher>(reference_matcher(scene, part_of(shapes, c)));
      });
}

}  // namespace test_worker_team
}  // namespace tessera::comm
