// Random pieces for tests of fields and of the curves traced on them.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <vector>

#include "core/geometry/similarity.h"
#include "support/synthetic_shapes.h"

namespace tessera::test {

/// A bean, a star, a ring and a blob.
inline const std::vector<Shape>& four_shapes() {
  static const std::vector<Shape> all = {
      make_test_shape("bean", bean_outline()), make_test_shape("star", star_outline(5)),
      make_test_shape("ring", ring_outline()), make_test_shape("blob", blob_outline(7))};
  return all;
}

struct Piece {
  int shape;  // index into four_shapes()
  Similarity pose;
};

/// Possible places of a piece, in steps from the canvas' upper left corner.
struct Places {
  float step_px;
  int columns, rows;
};

inline Piece any_piece(int min_scale_px, int max_scale_px, const Places& places) {
  const float scale = float(*rc::gen::inRange(min_scale_px, max_scale_px));
  const float angle = 0.01f * float(*rc::gen::inRange(0, 628));
  return {
      *rc::gen::inRange(0, 4),
      {scale * std::cos(angle), scale * std::sin(angle), places.step_px * float(*rc::gen::inRange(0, places.columns)),
       places.step_px * float(*rc::gen::inRange(0, places.rows))}};
}

}  // namespace tessera::test
