// The effect of a piece on the free field, against a computation node by node: the shortcuts leave out no node.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "core/collage/exact_terms.h"
#include "core/collage/placed_outlines.h"
#include "core/field/nodes_near.h"
#include "core/field/piece_distance.h"
#include "core/geometry/distance_transform.h"
#include "core/random_pieces.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace test_piece_on_field {

const Shape& any_shape() { return test::four_shapes()[*rc::gen::inRange<std::size_t>(0, test::four_shapes().size())]; }

Similarity any_pose() {
  const float scale = float(*rc::gen::inRange(15, 90));
  const float angle = 0.01f * float(*rc::gen::inRange(0, 628));
  return {scale * std::cos(angle), scale * std::sin(angle), 0.5f * float(*rc::gen::inRange(0, 400)),
          0.5f * float(*rc::gen::inRange(0, 340))};
}

PieceSettings any_pieces() {
  PieceSettings pieces;
  pieces.min_scale_px = float(*rc::gen::element(14, 20, 45));
  pieces.max_scale_px = 90;
  pieces.padding_px = float(*rc::gen::element(0, 3));
  pieces.overlap_px = *rc::gen::element(0.f, 1.4f, 2.5f);
  return pieces;
}

Grid<float> stamped_node_by_node(const FreeField& free, const Shape& shape, const Similarity& pose,
                                 const PieceSettings& pieces) {
  Grid<float> value = free.field().value;
  const Vec2 origin = free.field().origin;
  const Window window = piece_window(shape.outline, pose, origin, stamp_band_px(pieces)).intersected(value.bounds());
  const PieceDistance piece(shape, pose, kept_distance_px(pieces));
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      value(x, y) = std::min(value(x, y), piece.at(origin + Vec2{float(x), float(y)}));
    }
  }
  return value;
}

/// The window of nodes at which two fields differ.
Window difference(const Grid<float>& a, const Grid<float>& b) {
  Window window;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (a(x, y) != b(x, y)) window = window.united({x, y, x + 1, y + 1});
    }
  }
  return window;
}

TEST(PieceOnField, StampTakesTheNearerEverywhere) {
  EXPECT_TRUE(rc::check([] {
    const PieceSettings pieces = any_pieces();
    FreeField free(make_rectangle_canvas(200, 170), pieces);
    for (int i = 0; i < 4; ++i) {
      const Shape& shape = any_shape();
      const Similarity pose = any_pose();
      const Grid<float> before = free.field().value;
      const Grid<float> expected = stamped_node_by_node(free, shape, pose, pieces);
      const Window changed = free.stamp(shape, pose);
      RC_ASSERT(free.field().value.data() == expected.data());
      RC_ASSERT(changed == difference(before, expected));
    }
  }));
}

ExactAreas areas_node_by_node(const Shape& shape, const Similarity& pose, const FreeField& free,
                              const OpenedField& opened, const PieceSettings& pieces) {
  const CanvasField& field = free.field();
  const float reach_px = reachable_radius_px(pieces);
  const Window window =
      piece_window(shape.outline, pose, field.origin, 2 * reach_px + 3).intersected(field.value.bounds());
  ExactAreas areas;
  if (window.width() <= 4 || window.height() <= 4) return areas;
  const PieceDistance piece(shape, pose, kept_distance_px(pieces));
  const auto to_piece = [&](int x, int y) { return piece.at(field.origin + Vec2{float(x), float(y)}); };
  Grid<std::uint8_t> centres_after(window.width(), window.height());
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const float d = field.value(x, y);
      centres_after(x - window.x0, y - window.y0) = std::min(d, to_piece(x, y)) > reach_px;
      if (to_piece(x, y) < 0 && d < -0.25f) ++areas.overlap_px2;
    }
  }
  const Grid<float> squared = squared_distance_to(centres_after);
  const Window inner = window.grown(-2);
  for (int y = inner.y0; y < inner.y1; ++y) {
    for (int x = inner.x0; x < inner.x1; ++x) {
      if (to_piece(x, y) >= 0 && squared(x - window.x0, y - window.y0) > (reach_px + 1.2f) * (reach_px + 1.2f) &&
          field.value(x, y) > 0 && opened.reachable(x, y)) {
        ++areas.gap_px2;
      }
    }
  }
  return areas;
}

/// The least distance to the canvas' edge, over points of the outline at most 1 px apart.
float least_distance_to_edge_px(const Outline& placed, const FreeField& free) {
  float least = INFINITY;
  for (const std::vector<Vec2>& curve : placed.curves) {
    for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) {
      const int steps = 1 + int(norm(curve[i] - curve[j]));
      for (int k = 0; k < steps; ++k) {
        const Vec2 p = curve[j] + (curve[i] - curve[j]) * (float(k) / float(steps));
        least = std::min(least, free.canvas_sample(p).value);
      }
    }
  }
  return least;
}

TEST(PieceOnField, NoPieceStandsTooNearTheCanvasEdge) {
  Grid<float> disc(400, 340);
  for (int y = 0; y < disc.height(); ++y) {
    for (int x = 0; x < disc.width(); ++x) disc(x, y) = (x - 200) * (x - 200) + (y - 170) * (y - 170) < 160 * 160;
  }
  EXPECT_TRUE(rc::check([&] {
    const PieceSettings pieces = any_pieces();
    const FreeField free(*rc::gen::arbitrary<bool>() ? make_mask_canvas(disc) : make_rectangle_canvas(200, 170),
                         pieces);
    const Shape& shape = any_shape();
    const Similarity pose = any_pose();
    const float least_px = least_distance_to_edge_px(placed_outline(shape.outline, pose), free);
    const bool apart = pieces.padding_px > 0 || pieces.overlap_px == 0;
    const bool too_near = least_px < (apart ? pieces.padding_px + 0.002f : -pieces.overlap_px);
    RC_ASSERT(PlacedOutlines(free, pieces).conflicts(shape, pose).empty() == !too_near);
  }));
}

TEST(PieceOnField, NodesNearerThanALimitAreThoseOfEveryNode) {
  EXPECT_TRUE(rc::check([] {
    const Shape& shape = any_shape();
    const Similarity pose = any_pose();
    const PieceDistance piece(shape, pose, 0);
    const Vec2 origin{-5.5f, -5.5f};
    const Window window = piece_window(shape.outline, pose, origin, float(*rc::gen::inRange(0, 30)));
    const float limit_px = 0.5f * float(*rc::gen::inRange(-10, 40));
    BitGrid asked(window.width(), window.height());
    for (int y = 0; y < asked.height(); y += *rc::gen::inRange(1, 9))
      asked.set_run(y, y % asked.width(), asked.width());
    const BitGrid everywhere = nodes_nearer_than(limit_px, piece, origin, window);
    const BitGrid where_asked = nodes_nearer_than(limit_px, piece, origin, window, asked);
    for (int y = 0; y < window.height(); ++y) {
      for (int x = 0; x < window.width(); ++x) {
        const bool nearer = piece.at(origin + Vec2{float(window.x0 + x), float(window.y0 + y)}) < limit_px;
        RC_ASSERT(everywhere.test(x, y) == nearer);
        if (asked.test(x, y)) RC_ASSERT(where_asked.test(x, y) == nearer);
      }
    }
  }));
}

TEST(PieceOnField, ExactAreasCountEveryNode) {
  EXPECT_TRUE(rc::check([] {
    const PieceSettings pieces = any_pieces();
    FreeField free(make_rectangle_canvas(200, 170), pieces);
    OpenedField opened(free, pieces);
    for (int i = 0; i < 3; ++i) opened.update(free, {free.stamp(any_shape(), any_pose())});
    const Shape& shape = any_shape();
    const Similarity pose = any_pose();
    const ExactAreas areas = exact_areas(shape, pose, free, opened, pieces);
    const ExactAreas expected = areas_node_by_node(shape, pose, free, opened, pieces);
    RC_ASSERT(areas.overlap_px2 == expected.overlap_px2);
    RC_ASSERT(areas.gap_px2 == expected.gap_px2);
  }));
}

}  // namespace test_piece_on_field
}  // namespace tessera
