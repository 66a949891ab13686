// The distance transform against brute force.
#include "core/geometry/distance_transform.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace tessera {
namespace test_distance_transform {

Grid<std::uint8_t> any_set(int width, int height, int inverse_density) {
  Grid<std::uint8_t> set(width, height);
  for (std::uint8_t& v : set.data()) v = *rc::gen::inRange(0, inverse_density) == 0;
  return set;
}

float brute_force(const Grid<std::uint8_t>& set, int x, int y) {
  float nearest = std::numeric_limits<float>::infinity();
  for (int j = 0; j < set.height(); ++j) {
    for (int i = 0; i < set.width(); ++i) {
      if (set(i, j)) nearest = std::min(nearest, float((x - i) * (x - i) + (y - j) * (y - j)));
    }
  }
  return nearest;
}

TEST(DistanceTransform, EqualsBruteForce) {
  EXPECT_TRUE(rc::check([] {
    const auto set = any_set(*rc::gen::inRange(1, 22), *rc::gen::inRange(1, 22), *rc::gen::element(2, 10, 60));
    const Grid<float> squared = squared_distance_to(set);
    for (int y = 0; y < set.height(); ++y) {
      for (int x = 0; x < set.width(); ++x) RC_ASSERT(squared(x, y) == brute_force(set, x, y));
    }
  }));
}

TEST(DistanceTransform, EmptySetIsInfinitelyFar) {
  const Grid<float> squared = squared_distance_to(Grid<std::uint8_t>(5, 3));
  for (const float v : squared.data()) EXPECT_EQ(v, std::numeric_limits<float>::infinity());
}

TEST(DistanceTransform, GridWithoutNodes) { EXPECT_TRUE(squared_distance_to(Grid<std::uint8_t>(0, 0)).data().empty()); }

TEST(DistanceTransform, LargestGridDoesNotOverflow) {
  Grid<std::uint8_t> set(16384, 2);
  set(0, 0) = 1;
  const Grid<float> squared = squared_distance_to(set);
  EXPECT_EQ(squared(16383, 0), 16383.f * 16383.f);
  EXPECT_EQ(squared(16383, 1), float(16383. * 16383. + 1));
}

}  // namespace test_distance_transform
}  // namespace tessera
