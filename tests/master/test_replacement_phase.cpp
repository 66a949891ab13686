// Replacement trials as a phase of the whole loop: when it takes place, and what it gains.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "core/base/stop.h"
#include "replacement_phase.h"

namespace tessera::master {
namespace test_replacement_phase {

using namespace replacement_phase;

/// Coverage of so few pieces differs by some points from seed to seed.
TEST(ReplacementPhase, CoversMoreAndKeepsTheRules) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  double gained = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    CollageSettings s = settings(30);
    s.seed = seed;
    test::AskedReplacer trying(test::real_trials(library()));
    const CollageResult with = run(canvas, s, &trying);
    test::AskedReplacer idle;
    gained += quality(canvas, with).coverage - quality(canvas, run(canvas, s, &idle)).coverage;
    EXPECT_GT(trying.batches.size(), 3u);
    EXPECT_LT(quality(canvas, with).overlap, 0.01);
    EXPECT_LT(quality(canvas, with).outside, 0.002);
    EXPECT_EQ(with.statistics.trials, 30u);
    EXPECT_FALSE(with.unfinished);
  }
  EXPECT_GT(gained / 4, 0.01);
}

/// The pieces that the phase works on are not the placed collage.
TEST(ReplacementPhase, ItIsSaidWhilePiecesAreExchanged) {
  class Steps : public SilentObserver {
   public:
    void progressed(const Progress& now) override { steps.push_back(now); }
    std::vector<Progress> steps;
  } observer;
  test::AskedReplacer trying(test::real_trials(library()));
  run(make_rectangle_canvas(240, 160), settings(10), &trying, observer);
  std::size_t exchanging = 0;
  for (std::size_t i = 1; i < observer.steps.size(); ++i) {
    const Progress &now = observer.steps[i], &before = observer.steps[i - 1];
    exchanging += now.exchanging;
    EXPECT_TRUE(!now.exchanging || now.coverage == before.coverage);
  }
  EXPECT_EQ(exchanging, trying.batches.size());
  EXPECT_FALSE(observer.steps.back().exchanging);
}

/// The replacer of this thread gives the same result as one that is passed in.
TEST(ReplacementPhase, DoesNotDependOnWhoTries) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  test::AskedReplacer trying(test::real_trials(library()));
  const CollageResult given = run(canvas, settings(10), &trying);
  EXPECT_FALSE(trying.batches.empty());
  EXPECT_EQ(run(canvas, settings(10), nullptr).placements, given.placements);
}

/// There are eight trials for each of five sixths of the trials between the first and the last. The temperature falls from the first batch
/// to the last.
TEST(ReplacementPhase, HasSoManyTrials) {
  test::AskedReplacer idle;
  const CollageResult result = run(make_rectangle_canvas(300, 220), settings(40), &idle);
  std::uint64_t trials = 0;
  float temperature_px2 = std::numeric_limits<float>::infinity();
  for (const std::vector<ReplacementWindow>& windows : idle.batches) {
    trials += trials_of(windows);
    for (const ReplacementWindow& w : windows) EXPECT_LT(w.first_temperature_px2, temperature_px2);
    temperature_px2 = windows.at(0).first_temperature_px2;
  }
  EXPECT_EQ(trials, 253u);
  EXPECT_NEAR(idle.batches.back().at(0).last_temperature_px2, 0, 0.01);
  EXPECT_EQ(result.statistics.trials, 40u);
}

/// Returns whether the replacer was asked about any window.
bool takes_place(const CollageSettings& s, const Canvas& canvas = make_rectangle_canvas(240, 160)) {
  test::AskedReplacer idle;
  run(canvas, s, &idle);
  return !idle.batches.empty();
}

TEST(ReplacementPhase, TakesPlaceWhereAnyPieceMayStandForAnyOther) {
  const CollageSettings usual = settings(8);
  ASSERT_TRUE(takes_place(usual));
  CollageSettings s = usual;
  s.pieces.uses = 2;
  EXPECT_FALSE(takes_place(s));
  s = usual;
  s.pieces.least_uses = 1;
  EXPECT_FALSE(takes_place(s));
  s = usual;
  s.pieces.apart_px = 30;
  EXPECT_FALSE(takes_place(s));
  s = usual;
  s.stop.pieces = 5;
  EXPECT_FALSE(takes_place(s));
  s.stop.pieces = 1000;
  EXPECT_FALSE(takes_place(s)) << "there may be more afterwards";
  s = usual;
  s.start.grow_outward = true;
  s.wishes.given = {{ShapeId{2}, {40, 0, 120, 80}, true}};
  EXPECT_FALSE(takes_place(s));
  s = usual;
  s.improve.relax = false;
  EXPECT_FALSE(takes_place(s));
  s = usual;
  s.pieces.max_scale_px = 201;
  EXPECT_FALSE(takes_place(s)) << "sizes differ much";
  s = usual;
  s.wishes.classes.resize(1);
  s.wishes.classes[0].uses = 3;
  s.wishes.class_of_shape.assign(library().size(), 0);
  EXPECT_FALSE(takes_place(s)) << "uses of a class";
}

/// The phase needs at least one trial for each piece. The first trial moves all pieces; the last trial of the phase settles them.
TEST(ReplacementPhase, TakesPlaceWhereThereAreTrialsEnough) {
  EXPECT_FALSE(takes_place(settings(1)));
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const std::size_t pieces = run(canvas, settings(1), nullptr).placements.size();
  const auto enough = 2 + int(std::ceil(double(pieces) / (8 * 5. / 6)));
  ASSERT_GT(enough, 4);
  EXPECT_FALSE(takes_place(settings(enough - 1), canvas));
  EXPECT_TRUE(takes_place(settings(enough), canvas));
}

TEST(ReplacementPhase, GivenPiecesStay) {
  CollageSettings s = settings(12);
  s.wishes.given = {{ShapeId{2}, {50, 0, 120, 80}, true}, {ShapeId{4}, {90, 0, 60, 50}, false}};
  test::AskedReplacer trying(test::real_trials(library()));
  const CollageResult result = run(make_rectangle_canvas(240, 160), s, &trying);
  EXPECT_FALSE(trying.batches.empty());
  EXPECT_EQ(result.placements.at(0).canvas_from_shape, s.wishes.given[0].canvas_from_shape);
  for (const auto& windows : trying.batches) {
    for (const ReplacementWindow& w : windows) {
      for (const WindowPiece& p : w.moving) EXPECT_NE(p.canvas_from_shape, s.wishes.given[0].canvas_from_shape);
    }
  }
}

/// The result of the trials is kept if it covers more, and put back otherwise.
TEST(ReplacementPhase, WorseThanBeforeIsPutBack) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  test::AskedReplacer idle;
  const CollageResult before = run(canvas, settings(8), &idle);
  test::AskedReplacer shrinking([](const ReplacementWindow& window) {
    ReplacementOutcome outcome = test::as_it_was(window);
    for (ReplacedPiece& p : outcome.pieces) p.canvas_from_shape = {40, 0, 120, 80};  // all pieces at one place
    return outcome;
  });
  const CollageResult after = run(canvas, settings(8), &shrinking);
  EXPECT_FALSE(shrinking.batches.empty());
  EXPECT_GT(quality(canvas, after).coverage, quality(canvas, before).coverage - 0.03);
  EXPECT_LT(quality(canvas, after).overlap, 0.01);
}

TEST(ReplacementPhase, TimeEndsItWithPiecesThatStand) {
  CollageSettings s = settings(0, 30, 60);
  s.improve.seconds = 1;
  const auto try_it = test::real_trials(library());
  test::AskedReplacer slow([&](const ReplacementWindow& window) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1010));
    return try_it(window);
  });
  KeepLatest keeper;
  SilentObserver silent;
  const CollageResult result = run(small_canvas(), s, &slow, silent, {nullptr, &keeper});
  EXPECT_FALSE(result.unfinished);
  EXPECT_LE(slow.batches.size(), 1u);
  EXPECT_TRUE(keeper.latest.loop.moving.empty()) << "settled";
  EXPECT_LT(quality(small_canvas(), result).overlap, 0.01);
  EXPECT_GT(quality(small_canvas(), result).coverage, 0.6);
}

/// Two regions side by side.
Canvas two_regions() {
  Canvas canvas = make_rectangle_canvas(240, 140);
  for (const bool right : {false, true}) {
    Grid<float> coverage(480, 280, 0.f);
    for (int y = 0; y < 280; ++y) {
      for (int x = 0; x < 480; ++x) coverage(x, y) = float((x >= 240) == right);
    }
    const Canvas part = make_mask_canvas(coverage);
    canvas.regions.push_back({part.distance, part.area_px2});
  }
  return canvas;
}

TEST(ReplacementPhase, EachRegionHasItsOwn) {
  CollageSettings s = settings(12, 30, 60);
  s.wishes.regions.resize(2);
  const Canvas canvas = two_regions();
  test::AskedReplacer trying(test::real_trials(library()));
  const CollageResult result = run(canvas, s, &trying);
  EXPECT_EQ(result.statistics.trials, 12u);
  int left = 0;
  int right = 0;
  for (const auto& windows : trying.batches) {
    for (const ReplacementWindow& w : windows) {
      for (const WindowPiece& p : w.moving) ++(p.canvas_from_shape.tx < 120 ? left : right);
    }
    if (right > 0) continue;
    EXPECT_GT(left, 0) << "the first comes first";
  }
  EXPECT_GT(right, 0);
  for (const ReplacementWindow& w : trying.batches.back()) {
    for (const WindowPiece& p : w.moving) EXPECT_GT(p.canvas_from_shape.tx, 120) << "pieces of the first region stand";
  }
  const Quality q = quality(canvas, result);
  EXPECT_LT(q.overlap, 0.01);
  KeepLatest keeper;
  SilentObserver silent;
  // The run is stopped in the phase of the second region.
  std::size_t asked = 0;
  const auto try_it = test::real_trials(library());
  const std::size_t last = trying.batches.size();
  test::AskedReplacer giving_up([&](const ReplacementWindow& window) {
    if (++asked == last) throw Interrupted{StopReason::signal};
    return try_it(window);
  });
  EXPECT_TRUE(run(canvas, s, &giving_up, silent, {nullptr, &keeper}).unfinished);
  EXPECT_EQ(keeper.latest.loop.region, 1u);
  EXPECT_EQ(run(canvas, s, nullptr, silent, {&keeper.latest, nullptr}).placements, result.placements);
}

}  // namespace test_replacement_phase
}  // namespace tessera::master
