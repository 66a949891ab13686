// Pieces of simple shapes for tests of relaxation and clearing.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/field/canvas.h"
#include "core/field/free_field.h"
#include "core/relax/relaxation.h"
#include "core/settings/settings.h"
#include "support/synthetic_shapes.h"

namespace tessera::relaxed_pieces {

inline const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{
      test::make_test_shape("disc", test::disc_outline()), test::make_test_shape("bean", test::bean_outline()),
      test::make_test_shape("star", test::star_outline(5)), test::make_test_shape("ring", test::ring_outline(0.6f)),
      test::make_test_shape("blob", test::blob_outline(3))};
  return all;
}

inline const std::vector<ContactShape>& contact_shapes() {
  static const std::vector<ContactShape> all = [] {
    std::vector<ContactShape> made;
    for (const Shape& shape : shapes()) made.push_back(make_contact_shape(shape));
    return made;
  }();
  return all;
}

inline constexpr std::size_t kDisc = 0;
inline const float kDiscRadius = 1 / std::sqrt(std::numbers::pi_v<float>);  // radius of the disc of area 1

inline const auto do_not_look = [] {};

inline Similarity pose(float scale_px, float angle_rad, Vec2 centre) {
  return {scale_px * std::cos(angle_rad), scale_px * std::sin(angle_rad), centre.x, centre.y};
}

inline RelaxedPiece piece(std::size_t shape, const Similarity& where, const PoseRange& poses = {10, 60, {}}) {
  return {&contact_shapes()[shape], where, poses};
}

inline std::vector<std::size_t> all_of(const std::vector<RelaxedPiece>& pieces) {
  std::vector<std::size_t> all(pieces.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  return all;
}

inline float any_number(int low, int high) { return 0.01f * float(*rc::gen::inRange(100 * low, 100 * high)); }

/// One piece in each of 14 of the 16 cells of a canvas of this width. They overlap each other and the edge.
inline std::vector<RelaxedPiece> any_pieces(float canvas_px) {
  std::vector<RelaxedPiece> pieces;
  for (int k = 0; k < 14; ++k) {
    const float scale = any_number(20, 45);
    const float angle = any_number(0, 6);
    const Vec2 cell{float(k % 4) + any_number(0, 1), float(k / 4) + any_number(0, 1)};
    pieces.push_back(
        piece(*rc::gen::inRange<std::size_t>(0, shapes().size()), pose(scale, angle, cell * (canvas_px / 4))));
  }
  return pieces;
}

inline constexpr int kCanvas_px = 150;

inline FreeField rectangle(int size_px = kCanvas_px) {
  return {make_rectangle_canvas(size_px, size_px), PieceSettings{}};
}

inline constexpr RelaxationSchedule kShort{25, 0.5f, 5, 3, 0.3f};

}  // namespace tessera::relaxed_pieces
