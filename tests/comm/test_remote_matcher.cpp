// A matcher on other ranks behaves as it does here: the same requests reach it, the same replies come back, and its
// errors too.
#include "comm/remote_matcher.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "comm/matcher_server.h"
#include "comm/worker_team.h"
#include "core/error.h"
#include "core/free_field.h"
#include "core/reference_matcher.h"
#include "job_fixture.h"
#include "on_all_ranks.h"
#include "support/synthetic_library.h"

namespace tessera::comm {
namespace {

using test::on_all_ranks;
using test::run_job;
using tessera::test::models_of;
using tessera::test::synthetic_library;

/// Answers with what it was told, in a form that shows it.
class EchoMatcher : public Matcher {
 public:
  explicit EchoMatcher(ShapeRange shapes) : shapes_(shapes) {}

  ShapeRange shapes() const override { return shapes_; }
  void start_field(int width, int height, Vec2 origin) override {
    field_ = Grid<float>(width, height);
    origin_ = origin;
  }
  void update_field(const FieldPatch& patch) override { write_patch(patch, field_); }

  void post_count(const std::vector<TargetSample>& samples) override { samples_ = samples; }
  std::vector<DistanceHistogram> take_count() override {
    std::vector<DistanceHistogram> counts(samples_.size());
    for (std::size_t t = 0; t < samples_.size(); ++t) counts[t] = {samples_[t].edge, shapes_.end - shapes_.begin};
    return counts;
  }

  void post_dock(const DockRequest& request) override { request_ = request; }
  /// One docking for each sample and shape; its pose shows the field.
  DockReply take_dock() override {
    DockReply reply;
    for (std::uint32_t t = 0; t < request_.samples.size(); ++t) {
      for (std::uint32_t shape = shapes_.begin; shape < shapes_.end; ++shape) {
        const float field_sum = field_(0, 0) + field_(field_.width() - 1, field_.height() - 1);
        reply.dockings.push_back({t, shape, request_.bin_limit[t], float(shape), {origin_.x, origin_.y, field_sum, 0}});
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

 private:
  ShapeRange shapes_;
  Grid<float> field_;
  Vec2 origin_;
  std::vector<TargetSample> samples_;
  DockRequest request_;
  std::vector<Docking> dockings_;
};

/// Worker `rank`'s part of `shapes` shapes.
ShapeRange part_of(std::uint32_t shapes, const Communicator& ranks) {
  const std::uint32_t workers = std::uint32_t(ranks.size() - 1);
  const std::uint32_t worker = std::uint32_t(ranks.rank() - 1);
  return {shapes * worker / workers, shapes * (worker + 1) / workers};
}

std::vector<TargetSample> samples_of_edges(std::initializer_list<std::uint32_t> edges) {
  std::vector<TargetSample> samples;
  for (const std::uint32_t edge : edges) samples.emplace_back().edge = edge;
  return samples;
}

/// Runs `master` with the workers' matchers, made by `make_matcher` on each of them, as one.
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
        [&](Communicator& c) {
          auto matcher = make_matcher(c);
          serve(c, matcher);
        });
    EXPECT_EQ(outcome.result.exit_code, 0);
    EXPECT_TRUE(outcome.reported.empty()) << outcome.reported[0];
  });
}

/// Two shapes only: with three workers one has none.
constexpr std::uint32_t kEchoShapes = 2;

void with_echo_team(const std::function<void(Matcher&)>& master) {
  with_team(master, [](Communicator& c) { return EchoMatcher(part_of(kEchoShapes, c)); });
}

TEST(RemoteMatcher, KnowsTheWorkersShapes) {
  with_echo_team([](Matcher& team) {
    EXPECT_EQ(team.shapes().begin, 0u);
    EXPECT_EQ(team.shapes().end, kEchoShapes);
  });
}

TEST(RemoteMatcher, CountsReachAllWorkersAndAreAdded) {
  with_echo_team([](Matcher& team) {
    team.post_count(samples_of_edges({7}));
    const auto counts = team.take_count();
    ASSERT_EQ(counts.size(), 1u);
    EXPECT_EQ(counts[0][0] % 7, 0u);
    EXPECT_EQ(counts[0][1], kEchoShapes);
    team.post_count({});
    EXPECT_TRUE(team.take_count().empty());
  });
}

TEST(RemoteMatcher, DockingsSeeTheFieldAsItWasWhenPosted) {
  with_echo_team([](Matcher& team) {
    team.start_field(30, 20, {-5.5f, 2.f});
    team.update_field({{0, 0, 30, 20}, std::vector<float>(600, 1.f)});
    team.post_dock({samples_of_edges({1, 2}), {5, 9}, 300});
    team.update_field({{29, 19, 30, 20}, {41.f}});
    const DockReply before = team.take_dock();
    ASSERT_EQ(before.dockings.size(), 2 * kEchoShapes);
    EXPECT_EQ(before.dockings[0], (Docking{0, 1, 5, 1.f, {-5.5f, 2.f, 2.f, 0}}));
    EXPECT_EQ(before.dockings[3], (Docking{1, 0, 9, 0.f, {-5.5f, 2.f, 2.f, 0}}));
    EXPECT_EQ(before.evaluated % 300, 0u);
    team.post_dock({samples_of_edges({1}), {5}, 300});
    EXPECT_EQ(team.take_dock().dockings.at(0).canvas_from_shape.tx, 42.f);
  });
}

TEST(RemoteMatcher, RefinedDockingsComeBackInTheOrderPosted) {
  with_echo_team([](Matcher& team) {
    std::vector<Docking> dockings(9);
    for (std::uint32_t i = 0; i < dockings.size(); ++i) {
      dockings[i].shape = i * 5 % kEchoShapes;
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

TEST(RemoteMatcher, AQuestionMayBePostedBeforeTheLastOneIsTaken) {
  with_echo_team([](Matcher& team) {
    team.post_count(samples_of_edges({3, 4, 5}));
    team.post_refine(std::vector<Docking>(100000));
    EXPECT_EQ(team.take_refine().size(), 100000u);
    EXPECT_EQ(team.take_count().size(), 3u);
  });
}

TEST(RemoteMatcher, LargeMessagesBothWaysDoNotLockUp) {
  constexpr int kNodes = 5000;  // of a field of 100 MB
  constexpr std::uint32_t kShapes = 60;
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() != 2) return;
    run_job(
        ranks,
        [](Communicator& c) {
          const auto team = gather_workers(c);
          auto* const worker = team.get();
          worker->start_field(kNodes, kNodes, {});
          const FieldPatch whole{{0, 0, kNodes, kNodes}, std::vector<float>(std::size_t(kNodes) * kNodes, 2.f)};
          worker->update_field(whole);
          for (int i = 0; i < 2; ++i) worker->post_refine(std::vector<Docking>(1'000'000));  // 40 MB, 60 MB back
          worker->update_field(whole);
          for (int i = 0; i < 2; ++i) EXPECT_EQ(c.receive(1, Tag::refine_reply).size() / 1'000'000, sizeof(RefinedDocking));
          return 0;
        },
        [](Communicator& c) {
          EchoMatcher matcher({0, kShapes});
          serve(c, matcher);
        });
  });
}

/// Fails in the middle of the work.
class FailingMatcher : public EchoMatcher {
 public:
  using EchoMatcher::EchoMatcher;
  void post_dock(const DockRequest&) override { throw EnvironmentError("the device was lost"); }
};

TEST(RemoteMatcher, AWorkersErrorReachesWhoeverTakes) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() == 1) return;
    const auto outcome = run_job(
        ranks,
        [](Communicator& c) {
          const auto team = gather_workers(c);
          team->post_count(samples_of_edges({1}));
          EXPECT_EQ(team->take_count().size(), 1u);
          team->post_dock({});
          team->take_dock();
          ADD_FAILURE() << "no error came";
          return 0;
        },
        [](Communicator& c) {
          FailingMatcher matcher(part_of(kEchoShapes, c));
          serve(c, matcher);
        });
    if (ranks.rank() != 0) return;
    EXPECT_EQ(outcome.result.exit_code, 1);
    ASSERT_EQ(outcome.reported.size(), 1u);
    EXPECT_NE(outcome.reported[0].find(": the device was lost"), std::string::npos) << outcome.reported[0];
  });
}

TEST(RemoteMatcher, AWorkerThatCannotStartEndsTheJob) {
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
          EchoMatcher matcher(part_of(kEchoShapes, c));
          serve(c, matcher);
        });
    EXPECT_EQ(outcome.result.exit_code, ranks.rank() == 0 ? 2 : 0);
  });
}

/// A half-filled canvas with samples along its target curve.
struct Scene {
  CollageSettings settings;
  std::vector<Shape> shapes = synthetic_library(5);
  MatchingContext context;
  CanvasField field;
  std::vector<TargetSample> samples;

  Scene() {
    settings.pieces.min_scale_px = 15;
    settings.pieces.max_scale_px = 90;
    settings.match.beta = 0.4f;
    context = make_matching_context(settings, std::uint32_t(shapes.size()));
    FreeField free(make_rectangle_canvas(160, 140), settings.pieces);
    free.stamp(shapes[0], {50, 20, 60, 55});
    free.stamp(shapes[1], {30, -10, 120, 90});
    field = free.field();
    OpenedField opened(free, settings.pieces);
    TargetCurve curve(settings.pieces, settings.match.pad);
    curve.retrace(opened, field.origin, field.value.bounds());
    const std::vector<std::uint32_t> edges = curve.sample_edges();
    for (std::size_t i = 0; i < edges.size(); i += 1 + edges.size() / 12) samples.push_back(curve.sample(edges[i]));
  }

  ReferenceMatcher matcher(ShapeRange range) const {
    return ReferenceMatcher(context, range.begin, models_of(shapes, context, range.begin, range.end));
  }
};

struct Answers {
  std::vector<DistanceHistogram> counts;
  std::vector<Docking> dockings;
  std::uint64_t evaluated = 0;
  std::vector<RefinedDocking> refined;
};

Answers ask(Matcher& matcher, const Scene& scene) {
  matcher.start_field(scene.field.value.width(), scene.field.value.height(), scene.field.origin);
  matcher.update_field(read_patch(scene.field.value, scene.field.value.bounds()));
  Answers answers;
  matcher.post_count(scene.samples);
  answers.counts = matcher.take_count();
  DockRequest request{scene.samples, {}, 100};
  for (const DistanceHistogram& histogram : answers.counts) request.bin_limit.push_back(bin_limit_for(histogram, 20));
  matcher.post_dock(request);
  const DockReply docked = matcher.take_dock();
  answers.dockings = docked.dockings;
  answers.evaluated = docked.evaluated;
  matcher.post_refine(docked.dockings);
  answers.refined = matcher.take_refine();
  return answers;
}

TEST(RemoteMatcher, PartsOfTheLibraryOnAnyNumberOfRanksAnswerAsTheWhole) {
  static const Scene scene;
  ReferenceMatcher whole = scene.matcher({0, std::uint32_t(scene.shapes.size())});
  const Answers expected = ask(whole, scene);
  ASSERT_GT(expected.dockings.size(), 20u);
  with_team(
      [&](Matcher& team) {
        const Answers answers = ask(team, scene);
        EXPECT_EQ(answers.counts, expected.counts);
        EXPECT_EQ(answers.dockings, expected.dockings);
        EXPECT_EQ(answers.evaluated, expected.evaluated);
        EXPECT_EQ(answers.refined, expected.refined);
      },
      [](Communicator& c) { return scene.matcher(part_of(std::uint32_t(scene.shapes.size()), c)); });
}

}  // namespace
}  // namespace tessera::comm
