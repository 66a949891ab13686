// Random filling makes no overlaps and keeps its range of scales.
#include "bench/baselines/random_filling.h"

#include <gtest/gtest.h>

#include "core/quality/quality.h"
#include "support/synthetic_library.h"

namespace tessera::bench {
namespace test_random_filling {

TEST(RandomFilling, OverlapsNothing) {
  const std::vector<Shape> library = test::synthetic_library(6);
  test::VectorShapes shapes(library);
  const Canvas canvas = make_rectangle_canvas(300, 200);
  CollageSettings settings;
  settings.pieces.min_scale_px = 12;
  settings.pieces.max_scale_px = 70;
  const std::vector<Placement> placements = fill_at_random(canvas, settings, shapes, 6, 0.3);
  ASSERT_GT(placements.size(), 5u);
  for (const Placement& p : placements) {
    EXPECT_GE(p.canvas_from_shape.scale(), 11.99f);
    EXPECT_LE(p.canvas_from_shape.scale(), 70.01f);
  }
  const Quality q =
      measure_quality(canvas, placements, [&](ShapeId id) -> const Shape& { return library[index_of(id)]; });
  EXPECT_LT(q.overlap, 0.012);
  EXPECT_LT(q.outside, 0.003);
  EXPECT_GT(q.coverage, 0.3);
}

}  // namespace test_random_filling
}  // namespace tessera::bench
