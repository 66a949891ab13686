// The points of an outline at which contacts are tested.
#include "core/relax/boundary_samples.h"

#include <gtest/gtest.h>

#include "core/relaxed_pieces.h"
#include "support/polygon_distance.h"

namespace tessera {
namespace test_boundary_samples {

using namespace relaxed_pieces;

TEST(BoundarySamples, LengthsAddUpAndStepsAreBounded) {
  for (const Shape& shape : shapes()) {
    const BoundarySamples samples = sample_boundary(shape.outline, 0.05f, 0.006f);
    float length = 0;
    for (const BoundarySample& s : samples.samples) {
      length += s.length;
      EXPECT_LT(test::boundary_distance({{{s.position}}}, shape.outline), 1e-5) << shape.name;
    }
    EXPECT_NEAR(length, shape.perimeter, 1e-3 * shape.perimeter) << shape.name;
    EXPECT_LE(samples.longest_step, 0.05f) << shape.name;
    ASSERT_EQ(samples.curve_ends.size(), shape.outline.curves.size());
    EXPECT_EQ(samples.curve_ends.back(), samples.samples.size());
  }
}

}  // namespace test_boundary_samples
}  // namespace tessera
