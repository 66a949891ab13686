// Batches of replacement trials: their windows, and how the answers are used.
#include "master/replacing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "replacing_batches.h"

namespace tessera::master {
namespace test_replacing {

using namespace replacing_batches;

Box box_of(const WindowPiece& piece) {
  std::vector<Vec2> points;
  for (const Vec2 p : library()[index_of(piece.shape) % library().size()].outline.curves.front()) {
    points.push_back(piece.canvas_from_shape.apply(p));
  }
  return bounding_box(points);
}

/// The piece's data as the master knows them.
auto known(const WindowPiece& piece) {
  const Similarity& s = piece.canvas_from_shape;
  return std::tuple(piece.shape, piece.drawing, s.a, s.b, s.tx, s.ty, piece.poses.min_scale_px,
                    piece.poses.max_scale_px);
}

std::ptrdiff_t times_in(const std::vector<WindowPiece>& pieces, const WindowPiece& piece) {
  return std::count_if(pieces.begin(), pieces.end(), [&](const WindowPiece& p) { return known(p) == known(piece); });
}

bool holds(const Box& outer, const Box& inner, float slack_px = 0.5f) {
  return inner.low.x > outer.low.x - slack_px && inner.low.y > outer.low.y - slack_px &&
         inner.high.x < outer.high.x + slack_px && inner.high.y < outer.high.y + slack_px;
}

/// The number of windows that move the placement or an image of it.
std::size_t times_moving(const Placement& p, const std::vector<ReplacementWindow>& windows, const Period& period) {
  std::size_t times = 0;
  for (const ReplacementWindow& w : windows) {
    times += std::size_t(std::count_if(w.moving.begin(), w.moving.end(), [&](const WindowPiece& m) {
      return m.shape == p.shape &&
             norm(period.nearest(m.canvas_from_shape.translation(), p.canvas_from_shape.translation()) -
                  p.canvas_from_shape.translation()) < 0.01f;
    }));
  }
  return times;
}

TEST(Replacing, WhatMovesInNoWindowStaysWhateverTheAnswers) {
  constexpr std::size_t kGiven = 30;
  Batches batches(large_canvas());
  test::AskedReplacer replacer([](const ReplacementWindow&) { return ReplacementOutcome{}; });  // removes all pieces
  const std::vector<Placement> left = batches.batch(replacer, kGiven);
  std::vector<Placement> expected;
  for (std::size_t i = 0; i < batches.placements.size(); ++i) {
    const std::size_t times = times_moving(batches.placements[i], replacer.windows(), {});
    EXPECT_LE(times, i < kGiven ? 0u : 1u) << i;
    if (times == 0) expected.push_back(batches.placements[i]);
  }
  EXPECT_EQ(left, expected);
  EXPECT_GT(left.size(), kGiven) << "some lie across the edges of windows";
  EXPECT_LT(left.size(), batches.placements.size() / 2 + kGiven);
}

TEST(Replacing, OldPiecesKeepTheirScoreAndNewOnesHaveNone) {
  Batches batches(make_rectangle_canvas(300, 220));
  const Similarity where{70, 3, 100, 90};
  test::AskedReplacer replacer([&](const ReplacementWindow& window) {
    ReplacementOutcome outcome = test::as_it_was(window);
    outcome.pieces.erase(outcome.pieces.begin());
    for (ReplacedPiece& p : outcome.pieces) p.canvas_from_shape.tx += 2;
    outcome.pieces.push_back({ShapeId{7}, where, ReplacedPiece::kNew});
    return outcome;
  });
  const std::vector<Placement> result = batches.batch(replacer);
  ASSERT_EQ(replacer.windows().size(), 1u);
  ASSERT_EQ(replacer.windows()[0].moving.size(), batches.placements.size()) << "the canvas' own edge is no cut";
  ASSERT_EQ(result.size(), batches.placements.size());
  for (std::size_t i = 0; i + 1 < result.size(); ++i) {
    Placement expected = batches.placements[i + 1];
    expected.canvas_from_shape.tx += 2;
    EXPECT_EQ(result[i], expected);
  }
  EXPECT_EQ(result.back(), (Placement{ShapeId{7}, where, 0, 0}));
}

TEST(Replacing, WindowsDoNotTouchAndHoldWhatMovesInThem) {
  for (const Canvas& canvas : {large_canvas(), make_seamless_canvas(800, 700, true, true)}) {
    Batches batches(canvas);
    test::AskedReplacer replacer;
    batches.batch(replacer);
    const std::vector<ReplacementWindow>& windows = replacer.windows();
    ASSERT_EQ(windows.size(), 4u);
    for (const ReplacementWindow& a : windows) {
      EXPECT_GE(std::min(a.box.width(), a.box.height()), 169) << "three middle sizes, or half of three of the largest";
      for (const WindowPiece& piece : a.moving) EXPECT_TRUE(holds(a.box, box_of(piece)));
      for (const ReplacementWindow& b : windows) {
        for (const Vec2 offset : canvas.period.offsets()) {
          if (&a == &b && offset == Vec2{}) continue;
          const Box image{b.box.low + offset, b.box.high + offset};
          EXPECT_FALSE(within_reach(a.box, image, -0.01f));
        }
      }
    }
  }
}

/// Every window knows all pieces that reach into it.
TEST(Replacing, WindowsKnowWhoStandsAtTheirEdges) {
  for (const Canvas& canvas : {large_canvas(), make_seamless_canvas(800, 700, true, true)}) {
    Batches batches(canvas);
    test::AskedReplacer replacer;
    batches.batch(replacer, 20);
    std::size_t at_edges = 0;
    for (const ReplacementWindow& w : replacer.windows()) {
      for (std::size_t i = 0; i < batches.placements.size(); ++i) {
        const Placement& p = batches.placements[i];
        for (const Vec2 offset : canvas.period.offsets()) {
          const WindowPiece piece{
              p.shape, ShapeId(index_of(p.shape) & ~1u), moved(p.canvas_from_shape, offset), {40, 80, {}}};
          const bool reaches_in = within_reach(w.box, box_of(piece), -1);
          const bool near = within_reach(w.box, box_of(piece), 0.6f * 56.6f);
          const auto moving = times_in(w.moving, piece);
          const auto still = times_in(w.still, piece);
          EXPECT_LE(moving + still, near ? 1 : 0);
          EXPECT_GE(moving + still, reaches_in ? 1 : 0);
          EXPECT_LE(moving, i < 20 ? 0 : 1) << "given ones";
          at_edges += std::size_t(still);
        }
      }
    }
    EXPECT_GT(at_edges, 40u);
  }
}

TEST(Replacing, CutsLieElsewhereInEachBatch) {
  Batches batches(large_canvas());
  test::AskedReplacer replacer;
  std::set<float> cuts;
  for (std::uint64_t done = 0; done < 6; ++done) {
    batches.batch(replacer, 0, {done, 100'000});
    for (const ReplacementWindow& w : replacer.windows()) cuts.insert(w.box.high.x);
  }
  EXPECT_EQ(cuts.size(), 7u) << "six, and the end";
}

TEST(Replacing, TheSameQuestionIsAskedAgain) {
  test::AskedReplacer replacer;
  Batches first(large_canvas());
  first.batch(replacer, 0, {700, 100'000});
  Batches second(large_canvas());
  second.batch(replacer, 0, {700, 100'000});
  ASSERT_EQ(replacer.batches[0].size(), replacer.batches[1].size());
  std::set<std::uint64_t> random;
  for (std::size_t i = 0; i < replacer.batches[0].size(); ++i) {
    const ReplacementWindow& a = replacer.batches[0][i];
    const ReplacementWindow& b = replacer.batches[1][i];
    const auto same = [](const WindowPiece& p, const WindowPiece& q) { return known(p) == known(q); };
    EXPECT_TRUE(std::ranges::equal(a.moving, b.moving, same));
    EXPECT_TRUE(std::ranges::equal(a.still, b.still, same));
    EXPECT_EQ(a.trials, b.trials);
    EXPECT_EQ(a.random, b.random);
    EXPECT_EQ(a.edge.distance.value.data(), b.edge.distance.value.data());
    random.insert(a.random);
  }
  EXPECT_EQ(random.size(), replacer.batches[0].size()) << "each window has its own";
}

/// Each question holds few windows. Their number does not change the result.
TEST(Replacing, AFewWindowsAreAskedAboutAtATime) {
  Batches batches(make_rectangle_canvas(1900, 1500));
  const auto moves = [](const ReplacementWindow& window) {
    ReplacementOutcome outcome = test::as_it_was(window);
    for (ReplacedPiece& p : outcome.pieces) p.canvas_from_shape.tx += float(window.random % 100) / 100;
    return outcome;
  };
  test::AskedReplacer broad(moves);
  const std::vector<Placement> expected = batches.batch(broad);
  ASSERT_EQ(broad.batches.size(), 1u);
  ASSERT_GT(broad.windows().size(), 16u);
  for (const int breadth : {1, 2}) {
    test::AskedReplacer narrow(moves, breadth);
    EXPECT_EQ(batches.batch(narrow), expected);
    std::size_t windows = 0;
    for (const auto& question : narrow.batches) {
      EXPECT_LE(question.size(), std::size_t(8 * breadth));
      EXPECT_FALSE(question.empty());
      windows += question.size();
    }
    EXPECT_EQ(windows, broad.windows().size());
    EXPECT_LE(narrow.batches.size(), windows / std::size_t(8 * breadth) + 1);
  }
}

std::uint64_t trials_of(const std::vector<ReplacementWindow>& windows) {
  std::uint64_t trials = 0;
  for (const ReplacementWindow& w : windows) trials += w.trials;
  return trials;
}

TEST(Replacing, APhaseHasAsManyTrialsAsItIsToAndCoolsDown) {
  for (const std::uint64_t all : {1ull, 3ull, 1000ull, 1001ull}) {
    Batches batches(large_canvas());
    test::AskedReplacer replacer;
    Replacing replacing = batches.replacing(replacer);
    ReplacementProgress progress{0, all};
    float temperature_px2 = 0.03f * 40 * 80;
    for (int batch = 0; progress.done < all; ++batch) {
      ASSERT_LT(batch, 100);
      const std::uint64_t before = progress.done;
      replacing.batch(batches.placements, 0, progress);
      const std::uint64_t trials = trials_of(replacer.windows());
      EXPECT_LE(trials, all - before);
      EXPECT_TRUE(progress.done == before + trials || (trials == 0 && progress.done == all));
      for (const ReplacementWindow& w : replacer.windows()) {
        EXPECT_NEAR(w.first_temperature_px2, temperature_px2, 0.01) << "where the last batch ended";
        EXPECT_LE(w.last_temperature_px2, w.first_temperature_px2);
        EXPECT_NEAR(w.last_temperature_px2, 96 * (1 - double(before + trials) / double(all)), 0.01);
      }
      if (!replacer.windows().empty()) temperature_px2 = replacer.windows()[0].last_temperature_px2;
    }
    EXPECT_EQ(progress.done, all);
    EXPECT_EQ(progress.all, all);
  }
}

TEST(Replacing, AWholeBatchHasTwoTrialsForEachPiece) {
  Batches batches(large_canvas());
  test::AskedReplacer replacer;
  batches.batch(replacer);
  for (const ReplacementWindow& w : replacer.windows()) EXPECT_EQ(w.trials, 2 * w.moving.size());
}

TEST(Replacing, EndsWhereNothingMayMove) {
  Batches batches(make_rectangle_canvas(300, 220));
  test::AskedReplacer replacer;
  ReplacementProgress progress{10, 500};
  EXPECT_EQ(batches.replacing(replacer).batch(batches.placements, batches.placements.size(), progress),
            batches.placements);
  EXPECT_EQ(progress.done, 500u);
  EXPECT_TRUE(replacer.batches.empty());
}

/// An exception in a batch leaves the progress unchanged, so the batch is repeated.
TEST(Replacing, ABatchThatIsGivenUpCountsNothing) {
  struct GivenUp {};
  Batches batches(make_rectangle_canvas(300, 220));
  test::AskedReplacer replacer([](const ReplacementWindow&) -> ReplacementOutcome { throw GivenUp{}; });
  ReplacementProgress progress{10, 500};
  EXPECT_THROW(batches.replacing(replacer).batch(batches.placements, 0, progress), GivenUp);
  EXPECT_EQ(progress.done, 10u);
}

/// This rank checks for a stop while it cuts windows and before each question. If the check throws, nothing counts.
TEST(Replacing, LooksBeforeAndBetweenQuestions) {
  struct GivenUp {};
  Batches batches(make_rectangle_canvas(1900, 1500));
  test::AskedReplacer all(test::as_it_was, 1);
  std::size_t looks = 0;
  ReplacementProgress progress{10, 100'000};
  batches.replacing(all).batch(batches.placements, 0, progress, [&] { ++looks; });
  ASSERT_GT(all.batches.size(), 2u);
  std::set<std::size_t> questions;
  for (std::size_t stop = 1; stop <= looks; ++stop) {
    test::AskedReplacer replacer(test::as_it_was, 1);
    ReplacementProgress given_up{10, 100'000};
    std::size_t left = stop;
    const auto look = [&] {
      if (--left == 0) throw GivenUp{};
    };
    EXPECT_THROW(batches.replacing(replacer).batch(batches.placements, 0, given_up, look), GivenUp) << stop;
    EXPECT_EQ(given_up.done, 10u);
    questions.insert(replacer.batches.size());
  }
  EXPECT_EQ(questions.size(), all.batches.size()) << "after any number of questions, but the last";
}

TEST(Replacing, APieceAcrossTheSeamMovesAndIsWrapped) {
  const Canvas canvas = make_seamless_canvas(300, 220, true, true);
  Batches batches(canvas);
  std::size_t across = 0;
  test::AskedReplacer replacer([&](const ReplacementWindow& window) {
    ReplacementOutcome outcome = test::as_it_was(window);
    for (ReplacedPiece& p : outcome.pieces) {
      const Box box = box_of({p.shape, p.shape, p.canvas_from_shape, {}});
      across += box.low.x < 300 && box.high.x > 300;
      p.canvas_from_shape.tx += 1;
    }
    return outcome;
  });
  batches.placements[0].canvas_from_shape.tx = 1;
  for (std::uint64_t done = 0; done < 4; ++done) {
    const std::vector<Placement> result = batches.batch(replacer, 0, {done, 100'000});
    EXPECT_EQ(result.size(), batches.placements.size());
    for (const Placement& p : result) EXPECT_EQ(canvas.period.wrapped(p.canvas_from_shape), p.canvas_from_shape);
    ASSERT_EQ(replacer.windows().size(), 1u) << "one period";
    EXPECT_NEAR(replacer.windows()[0].box.width(), 300, 0.01);
    EXPECT_NEAR(replacer.windows()[0].box.height(), 220, 0.01);
  }
  EXPECT_GT(across, 0u);
}

/// Real trials on a repeating canvas lose no coverage, and their pieces do not overlap.
TEST(Replacing, TrialsOnASeamlessCanvasCoverMore) {
  const Canvas canvas = make_seamless_canvas(300, 220, true, true);
  Batches batches(canvas);
  const Quality before = whole_collage::quality_of(canvas, batches.placements, library());
  test::AskedReplacer replacer(test::real_trials(library()));
  Replacing replacing = batches.replacing(replacer);
  ReplacementProgress progress{0, 120};
  while (progress.done < progress.all) batches.placements = replacing.batch(batches.placements, 0, progress);
  const Quality after = whole_collage::quality_of(canvas, batches.placements, library());
  EXPECT_GT(after.coverage - after.overlap, before.coverage - before.overlap + 0.05);
  EXPECT_LT(after.overlap, 0.04);
}

}  // namespace test_replacing
}  // namespace tessera::master
