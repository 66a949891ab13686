// The map that deforms a piece's drawing: weights, continuity, folds, other frames.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/deform/warp.h"

namespace tessera {
namespace test_warp {

constexpr int kColumns = 7, kRows = 5;

float any_float(float low, float high) {
  return low + (high - low) * float(*rc::gen::inRange(0, 1 << 20)) / float(1 << 20);
}

Vec2 any_point(float low, float high) {
  const float x = any_float(low, high);
  return {x, any_float(low, high)};
}

Warp still_warp(bool falling) {
  return {.origin = {-3, 2},
          .step = 1.5f,
          .displacement = {kColumns, kRows},
          .active = {kColumns - 1, kRows - 1, 1},
          .falling = falling};
}

Warp any_warp() {
  Warp warp = still_warp(*rc::gen::arbitrary<bool>());
  warp.origin = any_point(-5, 5);
  warp.step = any_float(0.5f, 3);
  for (Vec2& d : warp.displacement.data()) d = any_point(-1, 1);
  return warp;
}

/// Displaces each node so that p becomes m p + shift, where m has the two columns.
Warp affine_warp(bool falling, Vec2 column_x, Vec2 column_y, Vec2 shift) {
  Warp warp = still_warp(falling);
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const Vec2 p = warp.node(i, j);
      warp.displacement(i, j) = column_x * p.x + column_y * p.y + shift - p;
    }
  }
  return warp;
}

Vec2 point_within(const Warp& warp) {
  const float u = any_float(0, kColumns - 1), v = any_float(0, kRows - 1);
  return warp.origin + Vec2{u, v} * warp.step;
}

void expect_near(Vec2 a, Vec2 b, float tolerance) { RC_ASSERT(norm(a - b) <= tolerance); }

RC_GTEST_PROP(Warp, WeightsArePartsOfOneAndNameThePoint, ()) {
  const Warp warp = any_warp();
  const Vec2 p = point_within(warp);
  const WarpWeights at = warp.weights_at(p);
  float sum = 0;
  Vec2 mean;
  for (int k = 0; k < 3; ++k) {
    RC_ASSERT(at.weight[k] >= -1e-5f);
    RC_ASSERT(at.x[k] >= 0 && at.x[k] < kColumns && at.y[k] >= 0 && at.y[k] < kRows);
    sum += at.weight[k];
    mean = mean + warp.node(at.x[k], at.y[k]) * at.weight[k];
  }
  RC_ASSERT(std::abs(sum - 1) < 1e-5f);
  expect_near(mean, p, 1e-4f);
}

RC_GTEST_PROP(Warp, ReproducesWhatIsAffine, ()) {
  const Vec2 x = any_point(-2, 2), y = any_point(-2, 2), shift = any_point(-9, 9);
  const Warp warp = affine_warp(*rc::gen::arbitrary<bool>(), x, y, shift);
  const Vec2 p = point_within(warp);
  expect_near(warp.apply(p), x * p.x + y * p.y + shift, 1e-4f);
}

RC_GTEST_PROP(Warp, IsContinuous, ()) {
  const Warp warp = any_warp();
  const Vec2 p = any_point(-30, 30);
  const float tiny = 1e-3f;
  // Displacements of neighbouring nodes differ by at most 2 in x and in y.
  const float most = tiny * (1 + 4 * std::sqrt(2.f) / warp.step) + 1e-5f;
  expect_near(warp.apply(p + Vec2{tiny, 0}), warp.apply(p), most);
  expect_near(warp.apply(p + Vec2{0, tiny}), warp.apply(p), most);
}

/// Checks points on both diagonals, on sides and at nodes, from all triangles that meet there.
TEST(Warp, AgreesWhereTrianglesMeet) {
  for (const bool falling : {true, false}) {
    Warp warp = still_warp(falling);
    for (int j = 0; j < kRows; ++j) {
      for (int i = 0; i < kColumns; ++i) warp.displacement(i, j) = {float(i * i % 5), float(j * i % 3)};
    }
    const Vec2 a = warp.warped_node(2, falling ? 1 : 2), b = warp.warped_node(3, falling ? 2 : 1);
    const Vec2 middle = warp.node(2, 1) + Vec2{0.5f, 0.5f} * warp.step;
    for (const Vec2 side : {Vec2{1e-5f, 0}, Vec2{-1e-5f, 0}, Vec2{0, 1e-5f}, Vec2{0, -1e-5f}}) {
      EXPECT_LT(norm(warp.apply(middle + side) - (a + b) * 0.5f), 1e-3f);
      EXPECT_LT(norm(warp.apply(warp.node(2, 2) + side) - warp.warped_node(2, 2)), 1e-3f);
    }
  }
}

RC_GTEST_PROP(Warp, BeyondTheGridMovesAsItsNearestPoint, ()) {
  const Warp warp = any_warp();
  const Vec2 p = any_point(-50, 50);
  const Vec2 low = warp.node(0, 0), high = warp.node(kColumns - 1, kRows - 1);
  const Vec2 nearest{std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)};
  expect_near(warp.apply(p) - p, warp.apply(nearest) - nearest, 1e-4f);
}

TEST(Warp, WithoutDisplacementIsTheIdentity) {
  for (const bool falling : {true, false}) {
    const Warp warp = still_warp(falling);
    for (float x = -5; x < 9; x += 0.37f) {
      for (float y = -1; y < 10; y += 0.41f) EXPECT_EQ(warp.apply({x, y}), (Vec2{x, y}));
    }
    EXPECT_FLOAT_EQ(warp.least_jacobian(), 1);
  }
}

RC_GTEST_PROP(Warp, LeastJacobianOfAnAffineMapIsItsDeterminant, ()) {
  const Vec2 x = any_point(-2, 2), y = any_point(-2, 2);
  const float determinant = cross(x, y);
  const Warp warp = affine_warp(*rc::gen::arbitrary<bool>(), x, y, any_point(-9, 9));
  RC_ASSERT(std::abs(warp.least_jacobian() - std::min(1.f, determinant)) < 2e-4f);
}

TEST(Warp, LeastJacobianIsNegativeOfAFoldInAnActiveCell) {
  for (const bool falling : {true, false}) {
    Warp warp = still_warp(falling);
    warp.displacement(3, 2) = {2 * warp.step, 0};  // beyond its neighbour
    EXPECT_LT(warp.least_jacobian(), 0);
    for (int j = 1; j < 3; ++j) {
      for (int i = 2; i < 4; ++i) warp.active(i, j) = 0;
    }
    EXPECT_FLOAT_EQ(warp.least_jacobian(), 1);
  }
}

RC_GTEST_PROP(Warp, InAnotherFrameIsTheSameMap, ()) {
  Warp warp = any_warp();
  for (std::uint8_t& active : warp.active.data()) active = *rc::gen::inRange<int>(0, 2);
  const bool mirrored = *rc::gen::arbitrary<bool>();
  const float scale = any_float(0.2f, 5);
  const Vec2 offset = any_point(-20, 20);
  const auto moved = [&](Vec2 p) { return Vec2{mirrored ? -p.x : p.x, p.y} * scale + offset; };
  const Warp other = in_frame(warp, scale, offset, mirrored);
  const Vec2 p = any_point(-15, 15);
  expect_near(other.apply(moved(p)), moved(warp.apply(p)), 1e-3f);
  RC_ASSERT(std::abs(other.least_jacobian() - warp.least_jacobian()) < 1e-2f);
}

TEST(Warp, SpreadCoversABoxAndKeepsWhatIsActive) {
  Warp warp{.origin = {1, 1}, .step = 0.5f, .displacement = Grid<Vec2>(5, 5), .active = Grid<std::uint8_t>(4, 4, 0)};
  warp.active(1, 1) = warp.active(2, 1) = 1;
  for (const auto& [x, y] : {std::pair{1, 1}, {2, 1}, {3, 1}, {1, 2}, {2, 2}, {3, 2}})
    warp.displacement(x, y) = {0.25f, -0.5f};
  const Warp wide = spread(warp, {-3, -2}, {9, 8});
  EXPECT_LE(wide.origin.x, -3);
  EXPECT_LE(wide.origin.y, -2);
  EXPECT_GE(wide.node(wide.displacement.width() - 1, 0).x, 9);
  EXPECT_GE(wide.node(0, wide.displacement.height() - 1).y, 8);
  for (const Vec2 p : {Vec2{-3, -2}, Vec2{2, 1.7f}, Vec2{9, 8}, Vec2{1.2f, 3}}) {
    EXPECT_NEAR(wide.apply(p).x, p.x + 0.25f, 1e-5);
    EXPECT_NEAR(wide.apply(p).y, p.y - 0.5f, 1e-5);
  }
  for (const std::uint8_t active : wide.active.data()) EXPECT_EQ(active, 1);
}

}  // namespace test_warp
}  // namespace tessera
