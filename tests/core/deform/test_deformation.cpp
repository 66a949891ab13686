// Deformation of pieces until they meet: how far they move, and what stays.
#include "core/deform/deformation.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/deform/boundary_map.h"
#include "core/deform/identity.h"
#include "core/deform/unfolded_fit.h"
#include "core/deform/warp_fit.h"
#include "core/quality/quality.h"
#include "support/rank_breadth.h"
#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_deformation {

using test::make_test_shape;

constexpr int kCanvas_px = 200;
constexpr float kMostLost_px = 0.003f;  // of a gap that must stay: one unit of the last decimal on cards

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = {
      make_test_shape("disc", test::disc_outline()), make_test_shape("bean", test::bean_outline()),
      make_test_shape("ring", test::ring_outline()), make_test_shape("star", test::star_outline(6)),
      make_test_shape("blob", test::blob_outline(7))};
  return all;
}

/// A mouth that is open to the right.
Outline mouth_outline() {
  return {{test::resampled({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 1.5f}, {4, 1.5f}, {4, 2.5f}, {0, 2.5f}}, 512)}};
}

Similarity pose(float scale_px, float rotation_rad, Vec2 at_px) {
  return {scale_px * std::cos(rotation_rad), scale_px * std::sin(rotation_rad), at_px.x, at_px.y};
}

DeformSettings capped() {
  DeformSettings settings;
  settings.kind = DeformKind::capped;
  return settings;
}

std::vector<DeformedPiece> deformed(const std::vector<DeformablePiece>& pieces, const DeformSettings& settings,
                                    float gap_px = 0) {
  return deformed_pieces(make_rectangle_canvas(kCanvas_px, kCanvas_px), pieces, settings, {}, gap_px);
}

std::vector<Outline> on_canvas(const std::vector<DeformablePiece>& pieces, const std::vector<DeformedPiece>& after) {
  std::vector<Outline> outlines;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    outlines.push_back(after[i].outline);
    for (auto& curve : outlines.back().curves) {
      for (Vec2& p : curve) p = pieces[i].canvas_from_shape.apply(p);
    }
  }
  return outlines;
}

Quality judged(const std::vector<Outline>& outlines) {
  std::vector<JudgedPiece> pieces;
  for (const Outline& outline : outlines) pieces.push_back({outline, "", {}, 1});
  return measure_quality(make_rectangle_canvas(kCanvas_px, kCanvas_px), pieces);
}

std::vector<Outline> undeformed(const std::vector<DeformablePiece>& pieces) {
  std::vector<DeformedPiece> same(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) same[i].outline = pieces[i].shape->outline;
  return on_canvas(pieces, same);
}

float right_end(const Outline& outline) {
  float most = -INFINITY;
  for (const Vec2 p : outline.curves[0]) most = std::max(most, p.x);
  return most;
}

float left_end(const Outline& outline) {
  float least = INFINITY;
  for (const Vec2 p : outline.curves[0]) least = std::min(least, p.x);
  return least;
}

/// Two squares side by side, with `gap_px` between them.
std::vector<DeformablePiece> two_squares(const Shape& square, float gap_px) {
  const float scale_px = 60;
  return {{&square, pose(scale_px, 0, {60, 100})}, {&square, pose(scale_px, 0, {60 + scale_px + gap_px, 100})}};
}

Shape square_shape() {
  return make_test_shape("square", {{test::resampled(test::rectangle_outline(1, 1).curves[0], 512)}});
}

TEST(Deformation, NeighboursMeetInTheMiddleOfAGap) {
  const Shape square = square_shape();
  const auto pieces = two_squares(square, 4);
  const auto after = on_canvas(pieces, deformed(pieces, capped()));
  const float middle = 60 + 30 + 2;
  for (const float y : {90.f, 100.f, 110.f}) {
    for (const auto& [outline, at] : {std::pair{after[0], middle - 0.5f}, {after[1], middle + 0.5f}})
      EXPECT_TRUE(contains(outline.curves[0], {at, y})) << y;
  }
}

TEST(Deformation, WhatOverlapsGoesBack) {
  const Shape square = square_shape();
  const auto pieces = two_squares(square, -3);
  const double before = judged(undeformed(pieces)).overlap;
  const auto after = on_canvas(pieces, deformed(pieces, capped()));
  EXPECT_LT(judged(after).overlap, 0.1 * before);
  EXPECT_LE(right_end(after[0]), left_end(after[1]) + 0.5f);
}

TEST(Deformation, AGapIsLeftWhereOneIsWished) {
  const Shape square = square_shape();
  const auto pieces = two_squares(square, 5);
  const auto after = on_canvas(pieces, deformed(pieces, capped(), 2));
  float nearest = INFINITY;
  const BoundaryMap map(after, {});
  for (const Vec2 p : after[0].curves[0]) nearest = std::min(nearest, map.distance_to_others_px(p, 0, 10));
  EXPECT_GE(nearest, 2 - 0.02f);
  EXPECT_LE(nearest, 2.5);
}

TEST(Deformation, AWishedGapIsKeptInAnyPileThatHadIt) {
  EXPECT_TRUE(rc::check([] {
    std::vector<DeformablePiece> pieces;
    for (int k = 0; k < 9; ++k) {  // at most 40 px wide, on a lattice of 44
      const Shape& shape = shapes()[*rc::gen::inRange<std::size_t>(0, shapes().size())];
      const float scale_px = (*rc::gen::inRange(15, 20)) / shape.radius;
      pieces.push_back({&shape, pose(scale_px, float(*rc::gen::inRange(0, 6)),
                                     {30 + 44.f * float(k % 3), 30 + 44.f * float(k / 3)})});
    }
    DeformSettings settings = capped();
    if (*rc::gen::arbitrary<bool>()) settings.kind = DeformKind::voronoi;
    const float gap_px = float(*rc::gen::element(1, 3));
    const auto after = on_canvas(pieces, deformed(pieces, settings, gap_px));
    const BoundaryMap map(after, {});
    for (std::uint32_t i = 0; i < after.size(); ++i) {
      for (const Vec2 p : after[i].curves[0])
        RC_ASSERT(map.distance_to_others_px(p, i, gap_px) >= gap_px - kMostLost_px);
    }
  }));
}

/// The smallest distance between a point of one piece and another piece.
float smallest_gap_px(const std::vector<Outline>& outlines, float reach_px) {
  const BoundaryMap map(outlines, {});
  float least = reach_px;
  for (std::uint32_t i = 0; i < outlines.size(); ++i) {
    for (const auto& curve : outlines[i].curves) {
      for (const Vec2 p : curve) least = std::min(least, map.distance_to_others_px(p, i, reach_px));
    }
  }
  return least;
}

Canvas halves() {  // two regions that meet at x = 100
  Canvas canvas = make_rectangle_canvas(kCanvas_px, kCanvas_px);
  for (const bool right : {false, true}) {
    Grid<float> half(2 * kCanvas_px, 2 * kCanvas_px, 0.f);
    for (int y = 0; y < 2 * kCanvas_px; ++y) {
      for (int x = 0; x < kCanvas_px; ++x) half(x + (right ? kCanvas_px : 0), y) = 1;
    }
    canvas.regions.push_back({make_mask_canvas(half).distance, 1. * kCanvas_px * kCanvas_px / 2});
  }
  return canvas;
}

/// Nine pieces around a lattice. Each is as large as the gap to the earlier ones allows.
std::vector<DeformablePiece> pile(std::mt19937& random, float gap_px) {
  const auto any_of = [&](std::uint32_t count) { return random() % count; };
  std::vector<DeformablePiece> pieces;
  for (int k = 0; k < 9; ++k) {
    const Shape& shape = shapes()[any_of(std::uint32_t(shapes().size()))];
    const Vec2 at_px = {40 + 60.f * float(k % 3) + float(any_of(12)), 40 + 60.f * float(k / 3) + float(any_of(12))};
    const float rotation_rad = 0.1f * float(any_of(63));
    for (float scale_px = 72; scale_px > 12; scale_px *= 0.92f) {
      pieces.push_back({&shape, pose(scale_px, rotation_rad, at_px), any_of(8) == 0});
      if (smallest_gap_px(undeformed(pieces), gap_px) >= gap_px) break;
      pieces.pop_back();
    }
  }
  return pieces;
}

TEST(Deformation, NoPileLosesAWishedGapByPiecesThatGoBack) {
  static const Canvas whole = make_rectangle_canvas(kCanvas_px, kCanvas_px), parted = halves();
  EXPECT_TRUE(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const float gap_px = random() % 2 == 0 ? 1 : 3;
    const std::vector<DeformablePiece> pieces = pile(random, gap_px);
    DeformSettings settings = capped();
    if (random() % 2 == 0) settings.kind = DeformKind::voronoi;
    const Canvas& canvas = random() % 2 == 0 ? whole : parted;
    const auto after = deformed_pieces(canvas, pieces, settings, {}, gap_px);
    RC_ASSERT(smallest_gap_px(on_canvas(pieces, after), gap_px) >= gap_px - kMostLost_px);
    RC_ASSERT(
        std::any_of(after.begin(), after.end(), [](const DeformedPiece& piece) { return piece.farthest_px > 0; }));
  }));
}

TEST(Deformation, PiecesKeepToTheirRegion) {
  const Shape square = square_shape();
  const Canvas canvas = halves();
  const std::vector<DeformablePiece> pieces = {{&square, pose(60, 0, {100 - 30 - 1, 100})},
                                               {&square, pose(60, 0, {100 + 30 + 6, 100})}};
  for (const DeformKind kind : {DeformKind::capped, DeformKind::voronoi}) {
    DeformSettings settings;
    settings.kind = kind;
    const auto after = on_canvas(pieces, deformed_pieces(canvas, pieces, settings, {}, 0));
    EXPECT_LE(right_end(after[0]), 100.4);
    EXPECT_GE(left_end(after[1]), 99.6);
    EXPECT_GE(right_end(after[0]), 99.5);
  }
}

TEST(Deformation, WhatHasNoExtentOrIsVeryLongEndsAll) {
  Shape line = square_shape();
  for (Vec2& p : line.outline.curves[0]) p = {p.x * 500, 0};
  const std::vector<DeformablePiece> pieces = {{&line, pose(10, 0, {100, 100})}};
  for (const DeformKind kind : {DeformKind::capped, DeformKind::voronoi}) {
    DeformSettings settings;
    settings.kind = kind;
    EXPECT_LT(deformed(pieces, settings)[0].warp.displacement.data().size(), std::size_t(200'000));
  }
}

TEST(Deformation, APieceThatStaysIsMetByItsNeighbour) {
  const Shape square = square_shape();
  auto pieces = two_squares(square, 3);
  pieces[0].stays = true;
  DeformSettings settings = capped();
  settings.most_pad = settings.most_area = 1;  // its other sides have the room to use these limits up
  const auto results = deformed(pieces, settings);
  EXPECT_EQ(results[0].farthest_px, 0);
  EXPECT_EQ(results[0].outline, square.outline);
  EXPECT_NEAR(left_end(on_canvas(pieces, results)[1]), 60 + 30, 0.4);
}

TEST(Deformation, AMouthStaysOpenUnlessCellsAreToBeFull) {
  const Shape mouth = make_test_shape("mouth", mouth_outline());
  const std::vector<DeformablePiece> pieces = {{&mouth, pose(60, 0, {100, 100})}};
  const auto lips = [&](const DeformSettings& settings) {  // px that the inside of the mouth moved
    const DeformedPiece after = deformed(pieces, settings)[0];
    float most = 0;
    const auto& before = mouth.outline.curves[0];
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Vec2 p = before[i];
      const bool inside_lip = std::abs(p.x) < 0.2f && std::abs(p.y) < 0.15f;
      if (inside_lip) most = std::max(most, std::abs(after.outline.curves[0][i].y - p.y) * 60);
    }
    return most;
  };
  EXPECT_LT(lips(capped()), 0.5);
  DeformSettings full;
  full.kind = DeformKind::voronoi;
  EXPECT_GT(lips(full), 1.5);
}

TEST(Deformation, TheCanvasEdgeIsReachedAndNotPassed) {
  const Shape square = square_shape();
  const std::vector<DeformablePiece> pieces = {{&square, pose(60, 0, {32, 100})}};
  const Outline after = on_canvas(pieces, deformed(pieces, capped()))[0];
  EXPECT_NEAR(left_end(after), 0, 0.4);
}

TEST(Deformation, KeepsItsPromisesInAnyPile) {
  EXPECT_TRUE(rc::check([] {
    std::vector<DeformablePiece> pieces;
    const int count = *rc::gen::inRange(1, 7);
    for (int i = 0; i < count; ++i) {
      const Shape& shape = shapes()[*rc::gen::inRange<std::size_t>(0, shapes().size())];
      const Vec2 at{float(*rc::gen::inRange(20, 180)), float(*rc::gen::inRange(20, 180))};
      pieces.push_back({&shape, pose(float(*rc::gen::inRange(15, 70)), float(*rc::gen::inRange(0, 6)), at)});
    }
    DeformSettings settings = capped();
    settings.most_area = float(*rc::gen::element(0.02, 0.2));
    settings.most_pad = float(*rc::gen::element(0.03, 0.2));
    if (*rc::gen::weightedElement<int>({{3, 0}, {1, 1}})) settings.kind = DeformKind::voronoi;
    const auto after = deformed(pieces, settings);
    const test::RankBreadth others(int(pieces.size()) + 1);
    const auto again = deformed(pieces, settings);
    const BoundaryMap before_map(undeformed(pieces), {});
    const BoundaryMap map(on_canvas(pieces, after), {});
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      RC_ASSERT(after[i].outline == again[i].outline);
      RC_ASSERT(after[i].outline == warped_outline(pieces[i].shape->outline, after[i].warp));
      RC_ASSERT(after[i].least_jacobian >= kLeastJacobian);
      RC_ASSERT(after[i].least_jacobian == after[i].warp.least_jacobian());
      if (!before_map.crosses_itself(std::uint32_t(i))) RC_ASSERT(!map.crosses_itself(std::uint32_t(i)));
      if (settings.kind != DeformKind::capped) continue;
      const float scale_px = pieces[i].canvas_from_shape.scale();
      RC_ASSERT(std::abs(after[i].area_ratio - 1) <= settings.most_area * 1.0001f);
      RC_ASSERT(after[i].pad_distance <= settings.most_pad);
      RC_ASSERT(after[i].farthest_px <= 1.0001f * std::min(settings.most_px, settings.most_part * scale_px));
    }
  }));
}

TEST(WarpFit, AMoveOfAllPointsIsAMoveOfTheWhole) {
  for (const Shape& shape : shapes()) {
    std::size_t points = 0;
    for (const auto& curve : shape.outline.curves) points += curve.size();
    const Vec2 by{0.02f, -0.01f};
    const Warp warp = WarpFit(shape, {}).fitted(std::vector<Vec2>(points, by));
    for (const Vec2 p : {shape.outline.curves[0][5], shape.outline.curves[0][300]}) {
      EXPECT_NEAR(warp.apply(p).x, p.x + by.x, 1e-4) << shape.name;
      EXPECT_NEAR(warp.apply(p).y, p.y + by.y, 1e-4) << shape.name;
    }
    EXPECT_NEAR(warp.least_jacobian(), 1, 1e-2) << shape.name;
  }
}

TEST(UnfoldedFit, FoldsNothingWhateverIsWished) {
  EXPECT_TRUE(rc::check([] {
    const Shape& shape = shapes()[*rc::gen::inRange<std::size_t>(0, shapes().size())];
    std::vector<Vec2> wishes;
    for (const auto& curve : shape.outline.curves) {
      for (std::size_t i = 0; i < curve.size(); ++i)
        wishes.push_back({float(*rc::gen::inRange(-100, 101)) / 200.f, float(*rc::gen::inRange(-100, 101)) / 200.f});
    }
    RC_ASSERT(UnfoldedFit(shape, 50).warp(wishes).least_jacobian() >= kLeastJacobian);
  }));
}

TEST(ShapeIdentity, IsKeptByWhatPadsDoNotSeeAndLostByWhatTheyDo) {
  const Shape star = make_test_shape("star", test::star_outline(6));
  const ShapeIdentity identity(star, 80, {});
  Warp warp{
      .origin = {-2, -2}, .step = 0.05f, .displacement = Grid<Vec2>(81, 81), .active = Grid<std::uint8_t>(80, 80, 1)};
  EXPECT_EQ(identity.pad_distance(warp), 0);
  for (int j = 0; j < 81; ++j) {
    for (int i = 0; i < 81; ++i) warp.displacement(i, j) = warp.node(i, j) * 0.1f;  // enlarged by a tenth
  }
  const float larger = identity.pad_distance(warp);
  EXPECT_LT(larger, 0.02);
  for (int j = 0; j < 81; ++j) {
    for (int i = 0; i < 81; ++i) warp.displacement(i, j) = {warp.node(i, j).x * 0.8f, 0};  // stretched
  }
  EXPECT_GT(identity.pad_distance(warp), 3 * larger + 0.03);
}

}  // namespace test_deformation
}  // namespace tessera
