// Quality measures of squares, discs and rings with known values.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/base/processor_time.h"
#include "core/geometry/rasterise.h"
#include "core/quality/quality.h"
#include "core/quality/variety.h"
#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_quality {

using test::make_test_shape;

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = {make_test_shape("square", test::rectangle_outline(1, 1)),
                                         make_test_shape("disc", test::disc_outline()),
                                         make_test_shape("ring", test::ring_outline())};
  return all;
}

enum : std::uint32_t { kSquare, kDisc, kRing };

Placement at(std::uint32_t shape, float scale, Vec2 centre, float rotation_rad = 0) {
  return {ShapeId{shape}, {scale * std::cos(rotation_rad), scale * std::sin(rotation_rad), centre.x, centre.y}, 0, 0};
}

Quality measure(const Canvas& canvas, const std::vector<Placement>& placements) {
  return measure_quality(canvas, placements, [](ShapeId id) -> const Shape& { return shapes()[index_of(id)]; });
}

TEST(Quality, EmptyCanvasIsAllGap) {
  const Quality q = measure(make_rectangle_canvas(100, 60), {});
  EXPECT_EQ(q.coverage, 0);
  EXPECT_EQ(q.pieces, 0u);
  EXPECT_EQ(q.shared_boundary, 0);
  EXPECT_NEAR(q.largest_gap_px, 30, 0.5);
}

TEST(Quality, OneSquareInTheMiddle) {
  const Quality q = measure(make_rectangle_canvas(100, 100), {at(kSquare, 40, {50, 50})});
  EXPECT_NEAR(q.coverage, 0.16, 1e-3);
  EXPECT_EQ(q.overlap, 0);
  EXPECT_EQ(q.outside, 0);
  EXPECT_EQ(q.shared_boundary, 0);
  EXPECT_EQ(q.pieces, 1u);
  // The largest disc touches the square's corner (30, 30) and two sides: r sqrt 2 + r = 30 sqrt 2.
  EXPECT_NEAR(q.largest_gap_px, 30 * std::sqrt(2.) / (1 + std::sqrt(2.)), 0.4);
}

TEST(Quality, ACanvasThatIsCoveredHasNoGap) {
  EXPECT_EQ(measure(make_rectangle_canvas(20, 20), {at(kSquare, 40, {10, 10})}).largest_gap_px, 0);
}

TEST(Quality, OverlapCountsEveryPieceBeyondTheFirst) {
  const Quality q = measure(make_rectangle_canvas(100, 100),
                            {at(kSquare, 40, {50, 50}), at(kSquare, 40, {70, 50}), at(kSquare, 20, {60, 50})});
  EXPECT_NEAR(q.coverage, 0.24, 1e-3);
  EXPECT_NEAR(q.overlap, 0.08 + 0.04, 1e-3);
}

TEST(Quality, OverlapCountsAnyNumberOfLayers) {
  for (const std::size_t layers : {255u, 256u, 257u, 600u}) {
    // Half of each piece lies outside the canvas, where layers do not count.
    const Quality q =
        measure(make_rectangle_canvas(100, 100), std::vector<Placement>(layers, at(kSquare, 20, {0, 50})));
    EXPECT_NEAR(q.coverage, 0.02, 1e-9);
    EXPECT_NEAR(q.overlap, 0.02 * double(layers - 1), 1e-9);
    EXPECT_NEAR(q.outside, 0.02, 1e-9);
  }
}

TEST(Quality, OutsideOfTheCanvasIsNotCoverage) {
  const Quality q = measure(make_rectangle_canvas(100, 100), {at(kSquare, 40, {100, 50})});
  EXPECT_NEAR(q.coverage, 0.08, 1e-3);
  EXPECT_NEAR(q.outside, 0.08, 1e-3);
  EXPECT_EQ(q.overlap, 0);
}

TEST(Quality, NothingIsOutsideAcrossASeam) {
  const Quality corner = measure(make_seamless_canvas(100, 100, true, true), {at(kSquare, 40, {99, 2})});
  EXPECT_NEAR(corner.coverage, 0.16, 1e-3);
  EXPECT_EQ(corner.outside, 0);
  EXPECT_EQ(corner.overlap, 0);
  const Quality side = measure(make_seamless_canvas(100, 100, true, false), {at(kSquare, 40, {100, 0})});
  EXPECT_NEAR(side.coverage, 0.08, 1e-3);
  EXPECT_NEAR(side.outside, 0.08, 1e-3);
}

TEST(Quality, PiecesOverlapAcrossASeam) {
  const Quality q =
      measure(make_seamless_canvas(100, 100, true, false), {at(kSquare, 40, {5, 50}), at(kSquare, 40, {85, 50})});
  EXPECT_NEAR(q.coverage, 0.24, 1e-3);
  EXPECT_NEAR(q.overlap, 0.08, 1e-3);
}

/// The pieces are 1 px apart: each shares one of its four sides and a little of the adjacent ones.
TEST(Quality, BoundariesAreSharedAcrossASeam) {
  const std::vector<Placement> apart_by_one{at(kSquare, 40, {2, 100}), at(kSquare, 40, {161, 100})};
  EXPECT_NEAR(measure(make_seamless_canvas(200, 200, true, false), apart_by_one).shared_boundary, 43 / 160., 0.02);
  EXPECT_EQ(measure(make_seamless_canvas(220, 200, true, false), apart_by_one).shared_boundary, 0);
}

/// The gaps between a square and its images. With two seams a disc around the corner of the period touches four corners. With one seam it
/// lies between two sides.
TEST(Quality, AGapGoesOnAcrossASeam) {
  const std::vector<Placement> square{at(kSquare, 40, {50, 50})};
  EXPECT_NEAR(measure(make_seamless_canvas(100, 100, true, true), square).largest_gap_px, 30 * std::sqrt(2.), 0.5);
  EXPECT_NEAR(measure(make_seamless_canvas(100, 100, true, false), square).largest_gap_px, 30, 0.5);
}

TEST(Quality, HolesOfACanvasAreOutside) {
  Grid<float> mask(200, 200, 1.f);
  for (int y = 80; y < 120; ++y) std::fill(mask.row(y) + 80, mask.row(y) + 120, 0.f);
  const Canvas canvas = make_mask_canvas(mask);
  const Quality q = measure(canvas, {at(kSquare, 40, {50, 50})});
  EXPECT_NEAR(q.coverage, 1200 / 9600., 2e-3);
  EXPECT_NEAR(q.outside, 400 / 9600., 2e-3);
}

TEST(Quality, HolesOfAPieceStayFree) {
  const Quality q = measure(make_rectangle_canvas(200, 200), {at(kRing, 100, {100, 100}), at(kDisc, 30, {100, 100})});
  EXPECT_NEAR(q.coverage, (10000 + 900) / 40000., 1e-3);
  EXPECT_EQ(q.overlap, 0);
}

TEST(Quality, SharedBoundaryOfNeighboursAndEdge) {
  const Canvas canvas = make_rectangle_canvas(200, 200);
  // Two squares of 40 px, 1 px apart: each shares one of four sides and 2 px of the adjacent ones (reach 2, gap 1).
  const double side_and_ends = 40 + 2 * std::sqrt(3.);
  const Quality near = measure(canvas, {at(kSquare, 40, {60, 100}), at(kSquare, 40, {101, 100})});
  EXPECT_GT(near.shared_boundary, 40 / 160.);
  EXPECT_LT(near.shared_boundary, side_and_ends / 160. + 0.01);
  EXPECT_EQ(measure(canvas, {at(kSquare, 40, {60, 100}), at(kSquare, 40, {103, 100})}).shared_boundary, 0);
  // 1 px from the edge of the canvas: one side, and 1 px at the ends of the adjacent ones.
  EXPECT_NEAR(measure(canvas, {at(kSquare, 40, {21, 100})}).shared_boundary, 42 / 160., 0.01);
}

TEST(Quality, ADiscFillsItsRing) {
  const float hole_scale = 0.5f * std::sqrt(3.14159265f) * 100 / std::sqrt(3.14159265f * 0.75f);
  const Quality q =
      measure(make_rectangle_canvas(200, 200), {at(kRing, 100, {100, 100}), at(kDisc, hole_scale - 1, {100, 100})});
  // The ring's hole and the disc share 2 of the 4 radii of boundary (1 + 0.5 + 0.5).
  EXPECT_NEAR(q.shared_boundary, 0.5, 0.02);
}

TEST(Quality, ScaleQuantilesAndDistinctShapes) {
  std::vector<Placement> placements;
  for (int i = 0; i <= 10; ++i) placements.push_back(at(i % 2 ? kDisc : kSquare, float(10 + i), {50, 50}));
  const Quality q = measure(make_rectangle_canvas(100, 100), placements);
  EXPECT_EQ(q.distinct_shapes, 2u);
  ASSERT_TRUE(q.effective_shapes);
  EXPECT_NEAR(*q.effective_shapes, 2, 0.02) << "half of the area each, nearly";
  EXPECT_DOUBLE_EQ(q.scale_px_quantiles[0], 10);
  EXPECT_NEAR(q.scale_px_quantiles[1], 11, 1e-6);
  EXPECT_NEAR(q.scale_px_quantiles[2], 15, 1e-6);
  EXPECT_NEAR(q.scale_px_quantiles[3], 19, 1e-6);
  EXPECT_NEAR(q.scale_px_quantiles[4], 20, 1e-6);
}

JudgedPiece judged(const std::string& shape, double scale_px) {
  return {test::rectangle_outline(1, 1), shape, {0, 0}, scale_px};
}

TEST(EffectiveShapes, AreAsManyAsHaveEqualSharesOfTheArea) {
  EXPECT_FALSE(effective_shapes({}));
  EXPECT_FALSE(effective_shapes({judged("", 10)}));
  EXPECT_DOUBLE_EQ(*effective_shapes({judged("a", 10), judged("a", 40)}), 1);
  EXPECT_NEAR(*effective_shapes({judged("a", 10), judged("b", 10), judged("c", 10)}), 3, 1e-12);
  EXPECT_NEAR(*effective_shapes({judged("a", 10), judged("b", std::sqrt(50)), judged("b", std::sqrt(50))}), 2, 1e-12)
      << "two small copies are one large piece";
  EXPECT_LT(*effective_shapes({judged("a", 100), judged("b", 1), judged("c", 1)}), 1.01) << "to the eye one";
  EXPECT_NEAR(*effective_shapes({judged("a", 10), judged("b", 10), judged("", 1000)}), 2, 1e-12);
}

TEST(Quality, ThreeHundredPiecesTakeLessThanASecond) {
  std::vector<Placement> placements;
  for (int i = 0; i < 300; ++i)
    placements.push_back(at(i % 3, 50, {float(29 + 55 * (i % 18)), float(29 + 55 * (i / 18))}));
  const double start_s = processor_time_s();
  const Quality q = measure(make_rectangle_canvas(1000, 1000), placements);
  const double taken_s = processor_time_s() - start_s;
  EXPECT_GT(q.coverage, 0.7);
  EXPECT_LT(taken_s, 4);  // a loose bound, because sanitizers are slow
}

TEST(Rasterise, UnitCellsOfARectangle) {
  const Outline r = test::rectangle_outline(3, 2);
  EXPECT_EQ(bounding_window(r, {}), (Window{0, 0, 3, 2}));
  EXPECT_EQ(fill_spans(r, {}, {0, 0, 10, 10}), (std::vector<Span>{{0, 0, 3}, {1, 0, 3}}));
  EXPECT_EQ(fill_spans(r, {}, {1, 1, 2, 10}), (std::vector<Span>{{1, 1, 2}}));
  EXPECT_EQ(fill_spans(Outline{}, {}, {0, 0, 9, 9}), std::vector<Span>{});
}

TEST(Rasterise, FarAwayAndHugeOutlinesAreClipped) {
  EXPECT_TRUE(fill_spans(test::disc_outline(), {1, 0, 1e20f, -1e20f}, {0, 0, 9, 9}).empty());
  EXPECT_EQ(fill_spans(test::rectangle_outline(1, 1), {1e12f, 0, -5e11f, -5e11f}, {0, 0, 9, 9}).size(), 9u);
}

RC_GTEST_PROP(Rasterise, AreaAgreesWithTheShoelaceFormula, ()) {
  const Outline blob = test::blob_outline(*rc::gen::arbitrary<std::uint32_t>());
  const float angle = float(*rc::gen::inRange(0, 628)) * 0.01f;
  const float scale = float(*rc::gen::inRange(20, 200));
  const float shift = float(*rc::gen::inRange(-1000, 1000)) * 0.013f;
  const Similarity t{scale * std::cos(angle), scale * std::sin(angle), shift, -shift};
  std::size_t cells = 0;
  for (const Span& span : fill_spans(blob, t, bounding_window(blob, t))) cells += std::size_t(span.x1 - span.x0);
  const double area = test::shoelace_area(blob) * scale * scale;
  // Each boundary cell has a random error of at most half a cell, which adds up to far less than the boundary's length.
  RC_ASSERT(std::abs(double(cells) - area) < 0.3 * scale * test::curve_length(blob.curves[0]) + 4);
}

RC_GTEST_PROP(Rasterise, HalvesOfACutShapeNeitherOverlapNorLeaveCells, ()) {
  const Outline blob = test::blob_outline(*rc::gen::arbitrary<std::uint32_t>());
  const std::vector<Vec2>& curve = blob.curves[0];
  const std::size_t middle = *rc::gen::inRange<std::size_t>(10, curve.size() - 10);
  const Outline first{{{curve.begin(), curve.begin() + middle + 1}}};
  Outline second{{{curve.begin() + middle, curve.end()}}};
  second.curves[0].push_back(curve[0]);
  const Similarity t{37.3f, 21.9f, 3.1f, 0.4f};
  const Window window = bounding_window(blob, t).grown(2);
  const auto whole = rasterise(blob, t, window);
  const auto a = rasterise(first, t, window);
  const auto b = rasterise(second, t, window);
  // The chord lies anywhere. With the even-odd rule the two halves still combine to the whole.
  for (std::size_t i = 0; i < whole.data().size(); ++i) RC_ASSERT(whole.data()[i] == (a.data()[i] ^ b.data()[i]));
}

}  // namespace test_quality
}  // namespace tessera
