// The grid of bits, against a look at every node.
#include "core/geometry/bit_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>

#include "core/geometry/distance_transform.h"

namespace tessera {
namespace test_bit_grid {

/// Widths on both sides of one and of two words.
int any_width() { return *rc::gen::element(1, 5, 63, 64, 65, 100, 128, 130); }

TEST(BitGrid, ARunIsItsNodes) {
  EXPECT_TRUE(rc::check([] {
    BitGrid set(any_width(), 2);
    const int x0 = *rc::gen::inRange(0, set.width() + 1);
    const int x1 = *rc::gen::inRange(0, set.width() + 1);
    set.set_run(1, x0, x1);
    for (int x = 0; x < set.width(); ++x) {
      RC_ASSERT(!set.test(x, 0));
      RC_ASSERT(set.test(x, 1) == (x >= x0 && x < x1));
    }
  }));
}

TEST(BitGrid, AWindowIsItsNodes) {
  for (const Window& window : {Window{0, 0, 1, 1}, {62, 1, 66, 3}, {3, 2, 130, 4}, {64, 0, 128, 4}, {5, 1, 5, 2}}) {
    BitGrid set(130, 4);
    set.set(window);
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 130; ++x) {
        EXPECT_EQ(set.test(x, y), window.contains(x, y));
        EXPECT_EQ(set.any({x, y, x + 1, y + 1}), window.contains(x, y));
      }
    }
    EXPECT_EQ(set.any({0, 0, 130, 4}), !window.empty());
  }
}

TEST(BitGrid, NodesAboveAThresholdInAWindow) {
  Grid<float> field(150, 4);
  for (std::size_t i = 0; i < field.data().size(); ++i) field.data()[i] = float(i * 7 % 11);
  const Window window{3, 1, 140, 4};
  const BitGrid above = nodes_above(field, window, 5);
  ASSERT_EQ(above.width(), window.width());
  ASSERT_EQ(above.height(), window.height());
  for (int y = 0; y < above.height(); ++y) {
    for (int x = 0; x < above.width(); ++x) EXPECT_EQ(above.test(x, y), field(3 + x, 1 + y) > 5);
  }
}

TEST(BitGrid, DilationIsAThresholdOfTheDistance) {
  EXPECT_TRUE(rc::check([] {
    const int width = any_width();
    const int height = *rc::gen::inRange(1, 30);
    const int inverse_density = *rc::gen::element(2, 20, 300);
    Grid<std::uint8_t> nodes(width, height);
    BitGrid set(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        nodes(x, y) = *rc::gen::inRange(0, inverse_density) == 0;
        if (nodes(x, y)) set.set_run(y, x, x + 1);
      }
    }
    const float squared_radius = 0.1f * float(*rc::gen::inRange(0, 1200));
    const BitGrid dilated = dilated_by_disc(set, squared_radius);
    const Grid<float> squared = squared_distance_to(nodes);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) RC_ASSERT(dilated.test(x, y) == (squared(x, y) <= squared_radius));
    }
  }));
}

TEST(BitGrid, WithoutNodes) { EXPECT_EQ(dilated_by_disc(BitGrid(0, 0), 9).words(), 0); }

}  // namespace test_bit_grid
}  // namespace tessera
