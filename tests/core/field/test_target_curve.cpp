// A curve that is updated placement by placement equals one traced afresh, to the bit.
#include "core/field/target_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "core/field/linked_contour.h"
#include "core/settings/tuning.h"
#include "core/target_layers.h"

namespace tessera {
namespace test_target_curve {

using test::Target;

const PieceSettings kPieces{.min_scale_px = 14, .max_scale_px = 90};

/// A canvas with a slit. The slit's loop is too short for samples until the piece `joining` connects it to another loop.
Canvas slit_canvas(const PieceSettings& pieces, Similarity& joining) {
  const int length = int(kShortestLoop * pieces.min_scale_px / 2) - *rc::gen::inRange(3, 25);
  const int x0 = *rc::gen::inRange(240, 260);
  Grid<float> coverage(2 * 500, 2 * 400, 1.f);
  for (int y = 400; y < 404; ++y) std::fill(coverage.row(y) + 2 * x0, coverage.row(y) + 2 * (x0 + length), 0.f);
  joining = {pieces.min_scale_px, 0, float(x0 - *rc::gen::inRange(30, 75)), 200};
  return make_mask_canvas(coverage);
}

/// Fills the window with -1, 0 and 1. The value 0 does not count as above 0.
void scatter(Grid<float>& field, const Window& window) {
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) field(x, y) = float(*rc::gen::inRange(-1, 2));
  }
}

TEST(LinkedContour, HasAVertexOnEveryEdgeThatIsCrossed) {
  EXPECT_TRUE(rc::check([] {
    Grid<float> field(*rc::gen::inRange(60, 140), *rc::gen::inRange(6, 12), -1.f);
    LinkedContour contour(2);
    const Window inner = field.bounds().grown(-1);
    for (int step = 0; step < 3; ++step) {
      const int x = *rc::gen::inRange(1, inner.x1);
      const Window window = step == 0 ? inner : Window{x, 2, x + *rc::gen::inRange(1, 70), 5}.intersected(inner);
      scatter(field, window);
      contour.retrace(field, PeriodicGrid(field.bounds()), {}, {step == 0 ? field.bounds() : window});
      for (int y = 0; y + 1 < field.height(); ++y) {
        for (int i = 0; i + 1 < field.width(); ++i) {
          const bool here = field(i, y) > 0;
          RC_ASSERT((contour.find({i, y, false}) != LinkedContour::kNone) == (here != (field(i + 1, y) > 0)));
          RC_ASSERT((contour.find({i, y, true}) != LinkedContour::kNone) == (here != (field(i, y + 1) > 0)));
        }
      }
    }
  }));
}

TEST(TargetCurve, UpdatingEqualsTracingAfresh) {
  EXPECT_TRUE(rc::check([] {
    std::vector<test::Piece> pieces;
    for (int i = 0; i < 5; ++i) pieces.push_back(test::any_piece(20, 90, {1, 200, 170}));
    test::expect_updating_equals_tracing_afresh(make_rectangle_canvas(200, 170), kPieces, pieces);
  }));
}

/// Updating walks along a side for only 16 x 8 px.
TEST(TargetCurve, UpdatingEqualsTracingAfreshWhereSidesAreLong) {
  EXPECT_TRUE(rc::check([] {
    std::vector<test::Piece> pieces;
    for (int i = 0; i < 5; ++i) pieces.push_back(test::any_piece(5, 30, {1, 600, 60}));
    const PieceSettings small{.min_scale_px = 4, .max_scale_px = 8};
    test::expect_updating_equals_tracing_afresh(make_rectangle_canvas(600, 60), small, pieces);
  }));
}

TEST(TargetCurve, ASampleOnALongSideDoesNotSeeItsEnd) {
  const PieceSettings small{.min_scale_px = 4, .max_scale_px = 8};
  Target target(make_rectangle_canvas(900, 60), small);
  const TargetCurve::Change change = target.place({0, {20, 0, 60, 10}});
  const float seen_px = 80 + kLongestSide * small.max_scale_px + 40;
  EXPECT_GT(change.renewed.size(), 0u);
  for (const SampleId id : change.renewed) EXPECT_LT(target.curve.sample(id).position.x, seen_px);
  float longest_px = 0;
  for (const SampleId id : target.curve.samples())
    longest_px = std::max(longest_px, target.curve.sample(id).pyramid.left[0]);
  EXPECT_GT(longest_px, kLongestSide * small.max_scale_px) << "all that was walked";
  EXPECT_LT(longest_px, kLongestSide * small.max_scale_px + 5);
}

TEST(TargetCurve, ALoopThatIsJoinedGetsItsSamples) {
  EXPECT_TRUE(rc::check([] {
    const PieceSettings pieces{.min_scale_px = 100, .max_scale_px = 160};
    Similarity joining;
    Target updated(slit_canvas(pieces, joining), pieces);
    updated.place({*rc::gen::inRange(0, 4), joining});
    TargetCurve afresh(pieces, PadParameters{});
    afresh.retrace(updated.opened, updated.free.field().origin, {updated.free.grid().nodes()});
    RC_ASSERT(updated.curve.samples() == afresh.samples());
  }));
}

TEST(TargetCurve, ReportsOnlyWhatTheChangeReaches) {
  Target target(make_rectangle_canvas(600, 200), kPieces);
  const std::size_t before = target.curve.sample_count();
  const TargetCurve::Change change = target.place({0, {40, 0, 80, 100}});
  // Samples of straight sides see as far as the next corners, but a good part of the canvas' edge does not see the piece.
  EXPECT_GT(change.renewed.size(), 0u);
  EXPECT_LT(change.renewed.size(), before);
  EXPECT_LT(change.removed.size(), before / 4);
}

TEST(TargetCurve, HasTheFreeRegionOnItsLeft) {
  Target target(make_rectangle_canvas(200, 160), kPieces);
  target.place({1, {60, 0, 100, 80}});
  const FieldView field = target.free.view();
  for (const SampleId id : target.curve.samples()) {
    const TargetSample& s = target.curve.sample(id);
    const Vec2 left{-s.tangent.y, s.tangent.x};
    EXPECT_GT(field_value(field, s.position + left * 2.f), field_value(field, s.position - left * 2.f));
  }
}

TEST(TargetCurve, AFullCanvasHasNoSamples) {
  Target target(make_rectangle_canvas(60, 60), kPieces);
  target.place({0, {80, 0, 30, 30}});
  target.place({3, {80, 0, 30, 30}});
  EXPECT_EQ(target.curve.sample_count(), 0u);
}

}  // namespace test_target_curve
}  // namespace tessera
