// Free field and target curve of a repeating canvas: both cross the seam as if it were not there.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "core/field/piece_distance.h"
#include "core/settings/tuning.h"
#include "core/target_layers.h"

namespace tessera {
namespace test_seamless_field {

using test::four_shapes;
using test::Piece;
using test::Target;

// Half a period is a whole number of sample spacings (6 px). So shifted curves have their samples at the same places.
constexpr int kWidth_px = 192;
constexpr int kHeight_px = 168;
const PieceSettings kPieces{.min_scale_px = 14, .max_scale_px = 60};

Piece any_piece() { return test::any_piece(15, 60, {0.25f, 4 * kWidth_px, 4 * kHeight_px}); }

std::vector<Piece> any_pieces(int count) {
  std::vector<Piece> pieces;
  for (int i = 0; i < count; ++i) pieces.push_back(any_piece());
  return pieces;
}

Canvas any_canvas() {
  const int sides = *rc::gen::inRange(1, 4);
  return make_seamless_canvas(kWidth_px, kHeight_px, (sides & 1) != 0, (sides & 2) != 0);
}

TEST(SeamlessField, HasNoEdgeAtItsSeams) {
  const FreeField both(make_seamless_canvas(100, 80, true, true), kPieces);
  for (const float d : both.field().value.data()) EXPECT_GT(d, 1000);
  EXPECT_EQ(both.free_256ths_px2(), 256 * 100 * 80);
  const FreeField free(make_seamless_canvas(100, 80, true, false), kPieces);
  const FieldView field = free.view();
  for (const float x : {-50.f, 0.f, 50.f, 100.f, 150.f}) {
    EXPECT_FLOAT_EQ(field_value(field, {x, 20}), 20);
    EXPECT_FLOAT_EQ(field_value(field, {x, 78}), 2);
    EXPECT_FLOAT_EQ(field_value(field, {x, -3}), -3);
  }
  EXPECT_EQ(free.free_256ths_px2(), 256 * 100 * 80);
}

TEST(SeamlessField, ReachesAsFarAsPiecesDoAndNoMoreThanAPeriod) {
  const PieceSettings large{.min_scale_px = 20, .max_scale_px = 160};
  const PeriodicGrid far = free_field_grid(make_seamless_canvas(1000, 100, true, false), large);
  EXPECT_GE(far.one_period().x0, 320);
  EXPECT_LT(far.one_period().x0, 340);
  EXPECT_EQ(far.one_period().y0, 0);
  EXPECT_LE(free_field_grid(make_seamless_canvas(50, 100, true, true), large).one_period().x0, 50 + kCanvasMargin);
}

/// Each node has the distance to the nearest image of each piece, looked up once per node and image.
TEST(SeamlessField, TakesTheNearestImageEverywhere) {
  EXPECT_TRUE(rc::check([] {
    const Canvas canvas = any_canvas();
    FreeField free(canvas, kPieces);
    const Grid<float> empty = free.field().value;
    const std::vector<Piece> pieces = any_pieces(3);
    for (const Piece& piece : pieces) free.stamp(four_shapes()[piece.shape], piece.pose);
    const PeriodicGrid& grid = free.grid();
    const float band_px = stamp_band_px(kPieces);
    for (int y = 0; y < empty.height(); y += 3) {
      for (int x = 0; x < empty.width(); x += 3) {
        const Vec2 node = free.field().origin + Vec2{float(grid.column(x)), float(grid.row(y))};
        float expected = empty(x, y);
        for (const Piece& piece : pieces) {
          const PieceDistance distance(four_shapes()[piece.shape], piece.pose, 0);
          for (const Vec2 offset : canvas.period.offsets()) expected = std::min(expected, distance.at(node + offset));
        }
        if (expected < band_px) RC_ASSERT(std::abs(free.field().value(x, y) - expected) < 1e-3f);
      }
    }
  }));
}

TEST(SeamlessField, RepeatsItselfToTheBit) {
  EXPECT_TRUE(rc::check([] {
    FreeField free(any_canvas(), kPieces);
    const std::vector<Piece> pieces = any_pieces(4);
    for (const Piece& piece : pieces) free.stamp(four_shapes()[piece.shape], piece.pose);
    free.clear(free.stamp_window(four_shapes()[pieces[0].shape], pieces[0].pose));
    const PeriodicGrid& grid = free.grid();
    const Grid<float>& value = free.field().value;
    for (int y = 0; y < value.height(); ++y) {
      for (int x = 0; x < value.width(); ++x) RC_ASSERT(value(x, y) == value(grid.column(x), grid.row(y)));
    }
  }));
}

TEST(SeamlessField, APieceThatIsTakenOutLeavesNothing) {
  EXPECT_TRUE(rc::check([] {
    FreeField free(any_canvas(), kPieces);
    const Piece stays = any_piece();
    free.stamp(four_shapes()[stays.shape], stays.pose);
    const Grid<float> before = free.field().value;
    const std::int64_t free_before = free.free_256ths_px2();
    const Piece goes = any_piece();
    free.stamp(four_shapes()[goes.shape], goes.pose);
    const Window window = free.stamp_window(four_shapes()[goes.shape], goes.pose);
    free.clear(window);
    const Shape& shape = four_shapes()[stays.shape];
    for (const Window& common : free.grid().images(window, free.stamp_window(shape, stays.pose))) {
      free.stamp(shape, stays.pose, common);
    }
    RC_ASSERT(free.field().value.data() == before.data());
    RC_ASSERT(free.free_256ths_px2() == free_before);
  }));
}

TEST(SeamlessField, IsReachableInAllImagesAlike) {
  FreeField free(make_seamless_canvas(kWidth_px, kHeight_px, true, true), kPieces);
  free.stamp(four_shapes()[3], {60, 0, 5, 5});
  const OpenedField opened(free, kPieces);
  const Vec2 origin = free.field().origin;
  const auto reachable = [&](Vec2 p) { return opened.reachable(int(p.x - origin.x), int(p.y - origin.y)); };
  for (const Vec2 offset : free.grid().period().offsets()) EXPECT_TRUE(reachable(Vec2{96, 84} + offset));
  EXPECT_FALSE(reachable({5, 5}));
  EXPECT_FALSE(reachable({kWidth_px + 5, 5}));
  EXPECT_FALSE(reachable({5, kHeight_px + 5}));
}

/// Strongly smoothed curves depend on the other side of a seam, even if they end at this side.
TEST(SeamlessCurve, UpdatingEqualsTracingAfresh) {
  EXPECT_TRUE(rc::check([] {
    const Canvas canvas = any_canvas();
    const PieceSettings settings{.min_scale_px = *rc::gen::element(14.f, 40.f), .max_scale_px = 60};
    test::expect_updating_equals_tracing_afresh(canvas, settings, any_pieces(5));
  }));
}

TEST(SeamlessCurve, HasItsSamplesInOnePeriod) {
  EXPECT_TRUE(rc::check([] {
    const Canvas canvas = make_seamless_canvas(kWidth_px, kHeight_px, true, true);
    Target target(canvas, kPieces);
    RC_ASSERT(target.curve.sample_count() == 0u);
    target.place(any_piece());
    RC_ASSERT(target.curve.sample_count() > 0u);
    for (const SampleId id : target.curve.samples()) {
      const Vec2 p = target.curve.sample(id).position;
      RC_ASSERT(p.x >= 0 && p.x <= kWidth_px + 1 && p.y >= 0 && p.y <= kHeight_px + 1);
    }
  }));
}

/// The sample half a period further on, both ways; null if there is none.
const TargetSample* shifted_sample(const Target& target, const TargetSample& sample, const Period& period) {
  const int width = target.free.field().value.width();
  GridEdge edge = GridEdge::of(edge_number(sample.id), width);
  const PeriodicGrid& grid = target.free.grid();
  edge.x = grid.column(edge.x + period.x_px / 2);
  edge.y = grid.row(edge.y + period.y_px / 2);
  const SampleId id{edge.number(width)};
  return target.curve.has_sample(id) ? &target.curve.sample(id) : nullptr;
}

bool alike(const ArclengthPyramid& a, const ArclengthPyramid& b) {
  for (int i = 0; i < PadParameters{}.levels; ++i) {
    if (std::abs(a.left[i] - b.left[i]) > 0.05f + 0.01f * a.left[i]) return false;
    if (std::abs(a.right[i] - b.right[i]) > 0.05f + 0.01f * a.right[i]) return false;
  }
  return a.convexity == b.convexity;
}

/// Positions are rounded differently, which sometimes moves the end of a level.
TEST(SeamlessCurve, IsTheSameWhereverTheSeamLies) {
  int samples = 0;
  int found = 0;
  EXPECT_TRUE(rc::check([&] {
    const Canvas canvas = make_seamless_canvas(kWidth_px, kHeight_px, true, true);
    const Period& period = canvas.period;
    Target here(canvas, kPieces);
    Target there(canvas, kPieces);
    for (const Piece& piece : any_pieces(4)) {
      here.place(piece);
      const Vec2 half{0.5f * float(period.x_px), 0.5f * float(period.y_px)};
      there.place({piece.shape, period.wrapped(moved(piece.pose, half))});
    }
    const PeriodicGrid& grid = here.free.grid();
    const Grid<float>& a = here.free.field().value;
    const Grid<float>& b = there.free.field().value;
    for (int y = grid.one_period().y0; y < grid.one_period().y1; ++y) {
      for (int x = grid.one_period().x0; x < grid.one_period().x1; ++x) {
        const float shifted = b(grid.column(x + period.x_px / 2), grid.row(y + period.y_px / 2));
        RC_ASSERT(std::abs(a(x, y) - shifted) < 1e-3f);
      }
    }
    for (const SampleId id : here.curve.samples()) {
      const TargetSample& sample = here.curve.sample(id);
      const TargetSample* shifted = shifted_sample(there, sample, period);
      ++samples;
      found += shifted && alike(sample.pyramid, shifted->pyramid) && norm(sample.tangent - shifted->tangent) < 0.02f;
    }
  }));
  EXPECT_GT(samples, 1000);
  EXPECT_GE(found, samples * 98 / 100) << found << " of " << samples;
}

}  // namespace test_seamless_field
}  // namespace tessera
