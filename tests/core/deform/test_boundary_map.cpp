// Distances, rays and crossings, against a look at every side.
#include "core/deform/boundary_map.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_boundary_map {

constexpr float kReach_px = 25;

Outline placed(const Outline& outline, float scale_px, Vec2 at_px) {
  Outline moved = outline;
  for (auto& curve : moved.curves) {
    curve = test::resampled(curve, 96);
    for (Vec2& p : curve) p = p * scale_px + at_px;
  }
  return moved;
}

std::vector<Outline> any_pieces() {
  std::vector<Outline> pieces;
  const int count = *rc::gen::inRange(2, 6);
  for (int i = 0; i < count; ++i) {
    const float scale_px = float(*rc::gen::inRange(5, 40));
    const Vec2 at_px{float(*rc::gen::inRange(0, 100)), float(*rc::gen::inRange(0, 100))};
    pieces.push_back(
        placed(*rc::gen::arbitrary<bool>() ? test::ring_outline() : test::star_outline(5), scale_px, at_px));
  }
  return pieces;
}

Vec2 any_point() {
  return {float(*rc::gen::inRange(-2000, 12000)) / 100.f, float(*rc::gen::inRange(-2000, 12000)) / 100.f};
}

bool covers(const Outline& outline, Vec2 p) {
  bool inside = false;
  for (const auto& curve : outline.curves) inside ^= contains(curve, p);
  return inside;
}

float nearest_px(const Outline& outline, Vec2 p) {
  float best = INFINITY;
  for (const auto& curve : outline.curves) {
    for (std::size_t i = 0; i < curve.size(); ++i)
      best = std::min(best, norm(p - nearest_point({curve[i], curve[(i + 1) % curve.size()]}, p)));
  }
  return best;
}

TEST(BoundaryMap, KnowsTheNearestOtherBoundaryAndItsSide) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Outline> pieces = any_pieces();
    const BoundaryMap map(pieces, {});
    const Vec2 p = any_point();
    float best = kReach_px;
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      if (nearest_px(pieces[i], p) < best) nearest = i;
      best = std::min(best, nearest_px(pieces[i], p));
    }
    const float found = map.distance_to_others_px(p, 0, kReach_px);
    RC_ASSERT(std::abs(std::abs(found) - best) < 1e-3f);
    RC_PRE(best > 1e-2f);  // a point on the boundary is on both sides
    RC_TAG(nearest == 0 ? "far" : found < 0 ? "inside" : "outside");
    if (nearest > 0) RC_ASSERT((found < 0) == covers(pieces[nearest], p));
  }));
}

TEST(BoundaryMap, ARayMeetsWhatIsNearestOnIt) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Outline> pieces = any_pieces();
    const BoundaryMap map(pieces, {});
    const Vec2 from = any_point();
    const float angle = float(*rc::gen::inRange(0, 628)) / 100.f;
    const Vec2 direction{std::cos(angle), std::sin(angle)};
    const auto first = [&](const Outline& outline) {  // finds the first hit by small steps
      const bool before = covers(outline, from);
      for (float at = 0; at < kReach_px; at += 0.01f) {
        if (covers(outline, from + direction * at) != before) return at;
      }
      return kReach_px;
    };
    float other = kReach_px;
    for (std::size_t i = 1; i < pieces.size(); ++i) other = std::min(other, first(pieces[i]));
    const RayHits hits = map.hits(from, direction, kReach_px, 0);
    RC_ASSERT(hits.other_px <= other + 0.02f);  // the steps may pass over a tip
    RC_ASSERT(hits.own_px <= std::max(first(pieces[0]), 0.2f) + 0.02f);
    for (const float at : {hits.own_px, hits.other_px}) {
      if (at >= kReach_px) continue;
      float off = INFINITY;
      for (const Outline& piece : pieces) off = std::min(off, nearest_px(piece, from + direction * at));
      RC_ASSERT(off < 0.01f);
    }
  }));
}

TEST(BoundaryMap, AcrossASeamAPieceMeetsItsOwnImage) {
  const std::vector<Outline> one = {placed(test::disc_outline(), 10, {5, 50})};
  EXPECT_EQ(BoundaryMap(one, {}).distance_to_others_px({-5, 50}, 0, kReach_px), kReach_px);
  const BoundaryMap tube(one, {30, 0});
  EXPECT_NEAR(tube.distance_to_others_px({-5, 50}, 0, kReach_px), 10, 0.1);  // its image at -25 ends at -15
}

TEST(BoundaryMap, SeesWhatCrossesItself) {
  const Outline eight = {{{{0, 0}, {20, 20}, {20, 0}, {0, 20}}}};
  const BoundaryMap map({eight, placed(test::star_outline(7), 10, {50, 50})}, {});
  EXPECT_TRUE(map.crosses_itself(0));
  EXPECT_FALSE(map.crosses_itself(1));
}

TEST(BoundaryMap, WithoutPiecesNothingIsNear) {
  const BoundaryMap map({}, {});
  EXPECT_EQ(map.distance_to_others_px({1, 2}, 0, 5), 5);
  EXPECT_EQ(map.hits({1, 2}, {1, 0}, 5, 0).other_px, 5);
}

}  // namespace test_boundary_map
}  // namespace tessera
