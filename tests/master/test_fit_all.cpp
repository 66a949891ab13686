// fit = "all" searches for sizes at which every required piece finds a place. If there are none, it keeps the attempt that lacks the fewest
// pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/base/stop.h"
#include "core/collage/missing_pieces.h"
#include "core/matching/sized_settings.h"
#include "core/settings/tuning.h"
#include "foreign_state.h"
#include "stopped_collage.h"

namespace tessera::master {
namespace test_fit_all {

using stopped_collage::Cuts;
using stopped_collage::KeepLatest;
using stopped_collage::StopAfter;

/// Three bars, 17 times as long as wide.
const std::vector<Shape>& bars() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> made;
    for (const float length : {16.8f, 17.f, 17.2f}) {
      made.push_back(test::make_library_shape("bar" + std::to_string(made.size()), test::rectangle_outline(length, 1)));
    }
    return made;
  }();
  return shapes;
}

/// Two lines of letters with a connecting bar: long and thin, with an edge like a comb.
const std::vector<Shape>& phrases() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> made;
    for (const int letters : {24, 27}) {
      Outline outline;
      std::vector<Vec2> edge;
      for (int i = letters; i > 0; --i) {
        for (const Vec2 at : {Vec2{0, 0}, Vec2{0, 1.4f}, Vec2{-0.5f, 1.4f}, Vec2{-0.5f, 0}}) {
          edge.push_back(Vec2{float(i), 0} + at);
        }
      }
      edge.insert(edge.end(), {{0, 0}, {0, -0.5f}, {float(letters), -0.5f}});
      outline.curves.push_back(test::resampled(edge, test::kOuterPoints));
      made.push_back(test::make_library_shape("phrase" + std::to_string(letters), outline));
    }
    return made;
  }();
  return shapes;
}

const std::vector<Shape>& blobs() { return stopped_collage::library(); }

CollageSettings all_of_one_size(float scale_px) {
  CollageSettings s;
  s.seed = 7;
  s.match.tangent_dockings = 60;
  s.pieces.fit_all = true;
  s.pieces.uses = 1;
  s.pieces.min_scale_px = s.pieces.max_scale_px = scale_px;
  return s;
}

/// Sets the sizes of the first attempt, as tessera collage does.
CollageSettings sized(const CollageSettings& s, const Canvas& canvas, const std::vector<Shape>& library) {
  return with_sizes_times(first_size_factor(s, std::uint32_t(library.size()), canvas.area_px2), s);
}

/// Counts the attempts in which a piece was placed.
struct Attempts : SilentObserver {
  void progressed(const Progress& progress) override { most = std::max(most, progress.attempt); }
  int most = 0;
};

std::vector<MissingPieces> missing_of(const CollageSettings& s, const CollageResult& result, std::size_t shapes) {
  std::vector<std::uint32_t> drawings;
  for (std::uint32_t i = 0; i < shapes; ++i) drawings.push_back(i);
  return missing_pieces(s, drawings, result.placements);
}

float largest_px(const CollageResult& result) {
  float largest = 0;
  for (const Placement& p : result.placements) largest = std::max(largest, p.canvas_from_shape.scale());
  return largest;
}

/// Expects the same pieces on another division of the library, and if the run is stopped after every so many steps.
void expect_repeatable(const CollageSettings& s, const Canvas& canvas, const std::vector<Shape>& library,
                       const CollageResult& whole, const std::vector<std::size_t>& stops_after = {1, 2}) {
  for (const std::size_t steps : stops_after) {
    KeepLatest keeper;
    Checkpoints checkpoints{nullptr, &keeper};
    CheckpointState from;
    bool ends = false;
    for (int part = 0; part < 200 && !ends; ++part) {
      StopAfter observer(steps);
      const CollageResult result = stopped_collage::run(s, Cuts{1}, observer, checkpoints, canvas, library);
      ends = !result.unfinished;
      if (ends) {
        EXPECT_EQ(result.placements, whole.placements) << "stopped after every " << steps << " steps";
      }
      from = keeper.latest;
      checkpoints.from = &from;
    }
    EXPECT_TRUE(ends);
  }
}

/// The first sizes follow from the area alone: 700 px long bars on a canvas of 400 px.
TEST(FitAll, LongBarsOfOneSizeFindAPlace) {
  const Canvas canvas = make_rectangle_canvas(400, 300);
  const CollageSettings s = sized(all_of_one_size(100), canvas, bars());
  SilentObserver silent;
  const CollageResult result = stopped_collage::run(s, {}, silent, {}, canvas, bars());
  ASSERT_EQ(result.placements.size(), 3u);
  EXPECT_GT(largest_px(result), 85) << "nearly as long as the canvas";
  expect_repeatable(s, canvas, bars(), result);
}

TEST(FitAll, PhrasesWithPaddingOfWhichNoneFitsAtFirstFindAPlace) {
  const Canvas canvas = make_rectangle_canvas(300, 200);
  CollageSettings s = all_of_one_size(100);
  s.pieces.padding_px = 4;
  s = sized(s, canvas, phrases());
  Attempts attempts;
  const CollageResult result = stopped_collage::run(s, {}, attempts, {}, canvas, phrases());
  EXPECT_EQ(result.placements.size(), 2u);
  EXPECT_GT(attempts.most, 2);
  EXPECT_LE(attempts.most, int(kMostAttempts));
  expect_repeatable(s, canvas, phrases(), result);
}

TEST(FitAll, EachAsOftenAsIsWantedWithoutTurning) {
  const Canvas canvas = make_rectangle_canvas(240, 200);
  CollageSettings s = all_of_one_size(100);
  s.pieces.min_scale_px = 40;
  s.pieces.least_uses = s.pieces.uses = 5;
  s.pieces.min_rotation_rad = s.pieces.max_rotation_rad = 0;
  s = sized(s, canvas, blobs());
  SilentObserver silent;
  const CollageResult result = stopped_collage::run(s, {}, silent, {}, canvas, blobs());
  EXPECT_EQ(result.placements.size(), 5 * blobs().size());
  EXPECT_TRUE(missing_of(s, result, blobs().size()).empty());
}

/// If shapes may be used any number of times, the rest of the canvas is filled after all required pieces have a place.
TEST(FitAll, WhatMayComeAgainComesAfterTheSearch) {
  const Canvas canvas = make_rectangle_canvas(200, 150);
  CollageSettings s = all_of_one_size(100);
  s.pieces.min_scale_px = 30;
  s.pieces.uses = 0;
  s.pieces.least_uses = 2;
  s = sized(s, canvas, blobs());
  SilentObserver silent;
  const CollageResult result = stopped_collage::run(s, {}, silent, {}, canvas, blobs());
  EXPECT_GT(result.placements.size(), 2 * blobs().size());
  EXPECT_TRUE(missing_of(s, result, blobs().size()).empty());
  std::map<ShapeId, int> first;
  for (std::size_t i = 0; i < 2 * blobs().size(); ++i) ++first[result.placements[i].shape];
  for (const auto& [shape, uses] : first) EXPECT_EQ(uses, 2) << index_of(shape);
  expect_repeatable(s, canvas, blobs(), result, {7});
}

/// Two pieces of a shape must be farther apart than the canvas is wide, so no size helps.
TEST(FitAll, WhatCannotBeMetKeepsTheLargestOfTheBestAttempts) {
  const Canvas canvas = make_rectangle_canvas(120, 90);
  CollageSettings s = all_of_one_size(40);
  s.pieces.least_uses = s.pieces.uses = 2;
  s.pieces.apart_px = 500;
  s = sized(s, canvas, bars());
  Attempts attempts;
  const CollageResult result = stopped_collage::run(s, {}, attempts, {}, canvas, bars());
  EXPECT_EQ(result.placements.size(), bars().size()) << "each once";
  EXPECT_EQ(missing_of(s, result, bars().size()).size(), bars().size());
  EXPECT_LE(attempts.most, int(kMostAttempts));
  EXPECT_GT(largest_px(result), 10) << "as small as allowed, 2 px, would lack as many";
  expect_repeatable(s, canvas, bars(), result);
}

TEST(FitAll, NoPieceBecomesSmallerThanTheJobAllows) {
  const Canvas canvas = make_rectangle_canvas(400, 300);
  CollageSettings s = all_of_one_size(100);
  s.pieces.least_scale_px = 120;
  s = sized(s, canvas, bars());
  SilentObserver silent;
  const CollageResult result = stopped_collage::run(s, {}, silent, {}, canvas, bars());
  EXPECT_TRUE(result.placements.empty());
  EXPECT_EQ(missing_of(s, result, bars().size()).size(), 3u);
}

/// The first attempt reaches that coverage before all pieces have a place.
TEST(FitAll, ALimitOfCoverageEndsAnAttemptAndNotTheSearch) {
  const Canvas canvas = make_rectangle_canvas(200, 150);
  CollageSettings s = all_of_one_size(60);
  s.stop.coverage = 0.4f;
  s = sized(s, canvas, blobs());
  SilentObserver silent;
  const CollageResult result = stopped_collage::run(s, {}, silent, {}, canvas, blobs());
  EXPECT_TRUE(missing_of(s, result, blobs().size()).empty());
}

TEST(FitAll, ALimitOfPiecesEndsTheSearch) {
  const Canvas canvas = make_rectangle_canvas(200, 150);
  CollageSettings s = all_of_one_size(60);
  s.stop.pieces = 5;
  s = sized(s, canvas, blobs());
  Attempts attempts;
  const CollageResult result = stopped_collage::run(s, {}, attempts, {}, canvas, blobs());
  EXPECT_EQ(result.placements.size(), 5u);
  EXPECT_EQ(result.statistics.stopped_by, StopReason::pieces);
  EXPECT_EQ(attempts.most, 1);
}

/// Improving may exchange pieces, but never ends with fewer of the required ones.
TEST(FitAll, ImprovingLosesNoPieceThatIsWanted) {
  const Canvas canvas = make_rectangle_canvas(150, 120);
  for (const std::uint64_t seed : {1u, 2u}) {
    CollageSettings s = all_of_one_size(28);
    s.seed = seed;
    s.pieces.min_scale_px = s.pieces.least_scale_px = 22;
    s.pieces.least_uses = s.pieces.uses = 4;
    const auto missing = [&](int trials) {
      s.improve.trials = trials;
      SilentObserver silent;
      const CollageResult result = stopped_collage::run(s, {}, silent, {}, canvas, blobs());
      return 4 * blobs().size() - result.placements.size();
    };
    const std::size_t before = missing(0);
    EXPECT_GT(before, 0u);
    EXPECT_LE(missing(20), before) << "seed " << seed;
  }
}

TEST(FitAll, TheFirstSizesGoByUsesAndPadding) {
  CollageSettings s = all_of_one_size(20);
  const double once = first_size_factor(s, 10, 1e6);
  EXPECT_NEAR(once, std::sqrt(kFirstFilling * 1e6 / (10 * 400)), 1e-6);
  s.pieces.least_uses = s.pieces.uses = 4;
  EXPECT_NEAR(first_size_factor(s, 10, 1e6), once / 2, 1e-6);
  s.pieces.padding_px = 10;
  const double side_px = 20 * first_size_factor(s, 10, 1e6);
  EXPECT_NEAR(40 * (side_px + 10) * (side_px + 10), kFirstFilling * 1e6, 1);
  s.pieces.padding_px = 500;
  EXPECT_NEAR(20 * first_size_factor(s, 10, 1e6), 2, 1e-6) << "no piece is smaller";
}

/// A state of a search whose second attempt has begun.
class ForeignSearch : public test::ForeignStateTest {
 protected:
  void SetUp() override {
    KeepLatest keeper;
    struct UntilSecondAttempt : SilentObserver {
      void progressed(const Progress& progress) override { attempt = progress.attempt; }
      std::optional<StopReason> stop_requested() override {
        return attempt > 1 ? std::optional(StopReason::signal) : std::nullopt;
      }
      int attempt = 0;
    } observer;
    stopped_collage::run(settings_, {}, observer, {nullptr, &keeper}, canvas_, blobs());
    state_ = keeper.latest;
    state_.name = "checkpoint.h5";
    ASSERT_GT(state_.best.placements.size(), 0u);
  }

  void go_on() const override {
    SilentObserver silent;
    stopped_collage::run(settings_, {}, silent, {&state_, nullptr}, canvas_, blobs());
  }

  Canvas canvas_ = make_rectangle_canvas(200, 150);
  CollageSettings settings_ = sized(all_of_one_size(60), canvas_, blobs());
};

TEST_F(ForeignSearch, IsFineBeforeTheChange) { EXPECT_EQ(complaint(), "none"); }

TEST_F(ForeignSearch, SizesThatNoSearchComesTo) {
  const CheckpointState whole = state_;
  const auto refused = [&](auto change) {
    state_ = whole;
    change(state_);
    EXPECT_NE(complaint().find("not a checkpoint of this job: region 0, attempt"), std::string::npos) << complaint();
  };
  refused([](CheckpointState& s) { s.sizes.factor = 1e-9f; });
  refused([](CheckpointState& s) { s.sizes.attempt = kMostAttempts; });
  refused([](CheckpointState& s) { s.best.factor = 2; });
  refused([](CheckpointState& s) { s.best.factor = 0; });
  refused([](CheckpointState& s) { s.sizes.over = true; });
}

TEST_F(ForeignSearch, ABestAttemptOutOfAllProportion) {
  const CheckpointState whole = state_;
  state_.best.placements[0].shape = ShapeId{12};
  expect_complaint("a piece of its best attempt with an impossible size or place");
  state_ = whole;
  state_.best.placements[0].canvas_from_shape.tx = 1e30f;
  expect_complaint("a piece of its best attempt with an impossible size or place");
  state_ = whole;
  state_.best.placements[0].canvas_from_shape.a = 900;
  expect_complaint("its best attempt has far more pieces than fit");
}

}  // namespace test_fit_all
}  // namespace tessera::master
