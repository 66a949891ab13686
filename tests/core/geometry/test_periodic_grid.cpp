// Images across the seams of a repeating plane, against a look at every node.
#include "core/geometry/periodic_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

namespace tessera {
namespace test_periodic_grid {

TEST(Period, WithoutOneEverythingStaysWhereItIs) {
  const Period none;
  const Vec2 p{-1234.5678f, 0.1f};
  EXPECT_EQ(none.wrapped(p), p);
  EXPECT_EQ(none.nearest(p, {500, 500}), p);
  EXPECT_EQ(none.offsets(), std::vector<Vec2>{Vec2{}});
  EXPECT_FALSE(none.repeats());
}

TEST(Period, BringsPointsIntoTheFirstPeriod) {
  const Period period{100, 0};
  EXPECT_EQ(period.wrapped(Vec2{-10, -10}), (Vec2{90, -10}));
  EXPECT_EQ(period.wrapped(Vec2{100, 7}), (Vec2{0, 7}));
  EXPECT_EQ(period.wrapped(Vec2{250.5f, 7}), (Vec2{50.5f, 7}));
  EXPECT_LT(period.wrapped(Vec2{-1e-9f, 0}).x, 100.f) << "what is rounded to the period is its beginning";
  EXPECT_EQ(period.wrapped(Similarity{2, 3, -10, 5}), (Similarity{2, 3, 90, 5}));
}

TEST(Period, FindsTheNearestImage) {
  const Period both{100, 60};
  EXPECT_EQ(both.nearest({98, 1}, {2, 59}), (Vec2{-2, 61}));
  EXPECT_EQ(both.nearest({40, 30}, {60, 20}), (Vec2{40, 30}));
  EXPECT_EQ((Period{0, 60}.nearest({98, 1}, {2, 59})), (Vec2{98, 61}));
}

TEST(Period, OffersTheImagesAround) {
  EXPECT_EQ((Period{100, 60}.offsets().size()), 9u);
  EXPECT_EQ((Period{100, 0}.offsets()), (std::vector<Vec2>{{0, 0}, {-100, 0}, {100, 0}}));
  EXPECT_EQ((Period{0, 60}.offsets()), (std::vector<Vec2>{{0, 0}, {0, -60}, {0, 60}}));
}

using Node = std::pair<int, int>;

/// A grid of 7 to 11 nodes each way that repeats in both directions, in one or in none. It holds up to a period of images.
PeriodicGrid any_grid() {
  const bool in_x = *rc::gen::inRange(0, 2) == 1;
  const bool in_y = *rc::gen::inRange(0, 2) == 1;
  const Window own{0, 0, *rc::gen::inRange(7, 12), *rc::gen::inRange(7, 12)};
  const int dx = in_x ? *rc::gen::inRange(0, own.x1 + 1) : 0;
  const int dy = in_y ? *rc::gen::inRange(0, own.y1 + 1) : 0;
  return {{0, 0, own.x1 + 2 * dx, own.y1 + 2 * dy},
          {dx, dy, own.x1 + dx, own.y1 + dy},
          {in_x ? own.x1 : 0, in_y ? own.y1 : 0}};
}

Window any_window() {
  const int x = *rc::gen::inRange(-30, 40);
  const int y = *rc::gen::inRange(-30, 40);
  return {x, y, x + *rc::gen::inRange(1, 20), y + *rc::gen::inRange(1, 20)};
}

template <class F>
void each_node(const Window& w, F f) {
  for (int y = w.y0; y < w.y1; ++y) {
    for (int x = w.x0; x < w.x1; ++x) f(x, y);
  }
}

std::set<Node> in_one_period(const PeriodicGrid& grid, const Window& window) {
  std::set<Node> nodes;
  each_node(window, [&](int x, int y) { nodes.insert({grid.column(x), grid.row(y)}); });
  return nodes;
}

TEST(PeriodicGrid, ImagesAreAllNodesThatStandForTheWindow) {
  EXPECT_TRUE(rc::check([] {
    const PeriodicGrid grid = any_grid();
    const Window window = any_window();
    const std::set<Node> wanted = in_one_period(grid, window);
    std::set<Node> found;
    for (const Window& part : grid.images(window, grid.nodes())) {
      RC_ASSERT(!part.empty());
      each_node(part, [&](int x, int y) { found.insert({x, y}); });
    }
    each_node(grid.nodes(), [&](int x, int y) {
      RC_ASSERT(found.contains({x, y}) == wanted.contains({grid.column(x), grid.row(y)}));
    });
  }));
}

TEST(PeriodicGrid, WindowsOverlapWhereTheirImagesDo) {
  EXPECT_TRUE(rc::check([] {
    const PeriodicGrid grid = any_grid();
    const Window a = any_window();
    const Window b = any_window();
    const std::set<Node> nodes = in_one_period(grid, a);
    bool common = false;
    for (const Node& node : in_one_period(grid, b)) common |= nodes.contains(node);
    RC_ASSERT(grid.overlap(a, b) == common);
  }));
}

TEST(PeriodicGrid, TheUnionHoldsAnImageOfEachAndDoesNotSpanTheGrid) {
  EXPECT_TRUE(rc::check([] {
    const PeriodicGrid grid = any_grid();
    const Window a = any_window();
    const Window b = any_window();
    const Window both = grid.united(a, b);
    RC_ASSERT(both.intersected(a) == a);
    const std::set<Node> held = in_one_period(grid, both);
    for (const Node& node : in_one_period(grid, b)) RC_ASSERT(held.contains(node));
  }));
  const PeriodicGrid grid({0, 0, 140, 50}, {20, 0, 120, 50}, {100, 0});
  EXPECT_EQ(grid.united({22, 5, 30, 9}, {112, 5, 119, 9}), (Window{12, 5, 30, 9}));
}

TEST(PeriodicGrid, SpreadsValuesToAllImages) {
  EXPECT_TRUE(rc::check([] {
    const PeriodicGrid grid = any_grid();
    Grid<int> values(grid.nodes().width(), grid.nodes().height(), -1);
    int next = 0;
    each_node(grid.one_period(), [&](int x, int y) { values(x, y) = next++; });
    const Grid<int> before = values;
    const Window window = any_window();
    grid.spread(values, window, grid.nodes());
    const std::set<Node> spread = in_one_period(grid, window);
    each_node(grid.nodes(), [&](int x, int y) {
      const bool is_image = spread.contains({grid.column(x), grid.row(y)});
      RC_ASSERT(values(x, y) == (is_image ? values(grid.column(x), grid.row(y)) : before(x, y)));
    });
  }));
}

TEST(PeriodicGrid, IsCutOffOnlyWhereItDoesNotRepeat) {
  const PeriodicGrid grid({0, 0, 140, 50}, {20, 0, 120, 50}, {100, 0});
  EXPECT_EQ(grid.clipped({-30, -5, 10, 9}), (Window{-30, 0, 10, 9}));
  EXPECT_EQ(grid.with_next_nodes(), (Window{20, 0, 121, 50}));
}

}  // namespace test_periodic_grid
}  // namespace tessera
