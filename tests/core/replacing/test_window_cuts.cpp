// The division of a canvas into windows.
#include "core/replacing/window_cuts.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tessera {
namespace test_window_cuts {

struct Question {
  Box canvas;
  Period period;
  float least_px = 0;
  float part_x = 0;
  float part_y = 0;

  std::vector<Box> windows() const { return cut_into_windows(canvas, period, least_px, part_x, part_y); }
};

Question any_question() {
  const int width = *rc::gen::inRange(20, 3000);
  const int height = *rc::gen::inRange(20, 3000);
  Question q;
  q.period = {*rc::gen::element(0, width), *rc::gen::element(0, height)};
  const Vec2 low{q.period.x_px > 0 ? 0 : -64.f, q.period.y_px > 0 ? 0 : -64.f};
  q.canvas = {low, Vec2{float(width), float(height)} - low};
  q.least_px = float(*rc::gen::inRange(10, 900));
  q.part_x = 0.01f * float(*rc::gen::inRange(0, 100));
  q.part_y = 0.01f * float(*rc::gen::inRange(0, 100));
  return q;
}

/// The number of windows that hold the point or images of it.
int windows_over(Vec2 p, const Question& q, const std::vector<Box>& windows) {
  int count = 0;
  for (const Box& w : windows) {
    for (const Vec2 offset : q.period.offsets()) {
      const Vec2 at = p + offset;
      count += at.x > w.low.x && at.x < w.high.x && at.y > w.low.y && at.y < w.high.y;
    }
  }
  return count;
}

bool near_a_cut(Vec2 p, const Question& q, const std::vector<Box>& windows) {
  constexpr float kRounding_px = 0.01f;
  return std::any_of(windows.begin(), windows.end(), [&](const Box& w) {
    const auto near = [](float at, float cut, int period) {
      const float way = at - cut;
      return std::abs(period > 0 ? std::remainder(way, float(period)) : way) < kRounding_px;
    };
    return near(p.x, w.low.x, q.period.x_px) || near(p.x, w.high.x, q.period.x_px) ||
           near(p.y, w.low.y, q.period.y_px) || near(p.y, w.high.y, q.period.y_px);
  });
}

TEST(WindowCuts, EveryPointLiesInOneWindow) {
  EXPECT_TRUE(rc::check([] {
    const Question q = any_question();
    const std::vector<Box> windows = q.windows();
    for (int k = 0; k < 50; ++k) {
      const Vec2 p = q.canvas.low + Vec2{0.001f * float(*rc::gen::inRange(1, 1000)) * q.canvas.width(),
                                         0.001f * float(*rc::gen::inRange(1, 1000)) * q.canvas.height()};
      if (near_a_cut(p, q, windows)) continue;
      RC_ASSERT(windows_over(p, q, windows) == 1);
    }
  }));
}

TEST(WindowCuts, NoneIsNarrowUnlessTheCanvasIs) {
  EXPECT_TRUE(rc::check([] {
    const Question q = any_question();
    constexpr float kRounding = 0.9999f;
    for (const Box& w : q.windows()) {
      RC_ASSERT(w.width() >= kRounding * std::min(0.5f * q.least_px, q.canvas.width()));
      RC_ASSERT(w.height() >= kRounding * std::min(0.5f * q.least_px, q.canvas.height()));
    }
  }));
}

/// Otherwise trials would cost more than their number says.
TEST(WindowCuts, NoneIsMuchLargerThanItHasToBe) {
  EXPECT_TRUE(rc::check([] {
    const Question q = any_question();
    for (const Box& w : q.windows()) {
      RC_ASSERT(w.width() < 3.001f * q.least_px);
      RC_ASSERT(w.height() < 3.001f * q.least_px);
    }
  }));
}

/// Windows end at an edge of the canvas in every batch. All other cuts move from batch to batch.
TEST(WindowCuts, CutsLieElsewhereWithOtherParts) {
  for (const Period& period : {Period{}, Period{1000, 800}}) {
    const Box canvas{{0, 0}, {1000, 800}};
    std::set<float> x, y;
    for (const float part : {0.f, 0.25f, 0.5f, 0.75f}) {
      for (const Box& w : cut_into_windows(canvas, period, 400, part, part)) {
        x.insert(w.low.x);
        y.insert(w.low.y);
      }
    }
    // There are two windows each way. Along a repeating axis both cuts move, along another only the middle one.
    EXPECT_EQ(x.size(), period.repeats() ? 8u : 5u);
    EXPECT_EQ(y.size(), period.repeats() ? 8u : 5u);
  }
}

TEST(WindowCuts, EachAxisGoesByItsOwnPart) {
  const std::vector<Box> windows = cut_into_windows({{0, 0}, {1000, 1000}}, {}, 500, 0.25f, 0.75f);
  ASSERT_EQ(windows.size(), 4u);
  EXPECT_EQ(windows[0].high, (Vec2{375, 625}));
  EXPECT_EQ(windows[1].low, (Vec2{375, 0})) << "row by row";
}

}  // namespace test_window_cuts
}  // namespace tessera
