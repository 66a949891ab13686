// Visual measures of a collage: balance of sizes, copies of a shape, gaps between pieces. They are tested on scenes made by hand, and
// against brute force.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/base/processor_time.h"
#include "core/collage/placed_outlines.h"
#include "core/quality/nearest_copies.h"
#include "core/quality/piece_gaps.h"
#include "core/quality/quality.h"
#include "core/quality/size_balance.h"
#include "support/polygon_distance.h"
#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_picture_measures {

JudgedPiece laid(const Outline& unit_outline, float scale_px, Vec2 centre_px, const std::string& shape,
                 float rotation_rad = 0) {
  const Similarity t{scale_px * std::cos(rotation_rad), scale_px * std::sin(rotation_rad), centre_px.x, centre_px.y};
  return {placed_outline(unit_outline, t), shape, centre_px, scale_px};
}

/// A square of side 1 around the origin.
Outline unit_square() { return {{{{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}}}}; }

JudgedPiece square(float side_px, Vec2 centre_px, const std::string& shape = "square", float rotation_rad = 0) {
  return laid(unit_square(), side_px, centre_px, shape, rotation_rad);
}

std::vector<JudgedPiece> of_sizes(const std::vector<float>& sides_px) {
  std::vector<JudgedPiece> pieces;
  for (const float side_px : sides_px) pieces.push_back(square(side_px, {0, 0}));
  return pieces;
}

/// Repeats each size until its pieces have an area of `px2` together.
std::vector<float> of_equal_area(const std::vector<float>& sides_px, float px2) {
  std::vector<float> all;
  for (const float side_px : sides_px) all.insert(all.end(), std::size_t(px2 / (side_px * side_px)), side_px);
  return all;
}

TEST(SizeBalance, EqualAreasInAllPartsAreEven) {
  // The range is 1 to 32 px: its parts end at 2, 4, 8 and 16 px.
  const auto balance = size_balance(of_sizes(of_equal_area({1.5f, 3, 6, 12, 24}, 576)), {1, 32});
  ASSERT_TRUE(balance);
  EXPECT_NEAR(balance->evenness, 1, 1e-9);
  EXPECT_NEAR(balance->dwarfs, 0.2, 1e-9) << "below 1.78 px";
}

TEST(SizeBalance, OneSizeAloneInAWideRangeIsUneven) {
  const auto balance = size_balance(of_sizes({30, 30, 30}), {20, 160});
  EXPECT_NEAR(balance->evenness, 0, 1e-12);
  EXPECT_EQ(balance->dwarfs, 0);
}

TEST(SizeBalance, TwoPartsOfFive) {
  const auto balance = size_balance(of_sizes(of_equal_area({1, 16}, 256)), {1, 32});
  EXPECT_NEAR(balance->evenness, std::log(2.) / std::log(5.), 1e-9);
  EXPECT_NEAR(balance->dwarfs, 0.5, 1e-9);
}

TEST(SizeBalance, DwarfsAreTheLowestSixth) {
  EXPECT_NEAR(dwarfs_below_px({20, 160}), 28.28, 0.01);
  EXPECT_NEAR(size_balance(of_sizes({28, 29}), {20, 160})->dwarfs, 28 * 28. / (28 * 28 + 29 * 29), 1e-6);
}

TEST(SizeBalance, SizesBeyondTheRangeCountAtItsEnds) {
  const auto balance = size_balance(of_sizes({5, 5, 10, 400, 160}), {10, 160});
  EXPECT_NEAR(balance->evenness, size_balance(of_sizes({10, 10 * std::sqrt(0.5f), 160, 400}), {10, 160})->evenness,
              1e-6);
}

TEST(SizeBalance, IsNotInventedWhereThereIsOneSize) {
  EXPECT_FALSE(size_balance(of_sizes({30, 30.2f}), {30, 30.2}));
  EXPECT_TRUE(size_balance(of_sizes({30, 30.5f}), {30, 30.5}));
  EXPECT_FALSE(size_balance({}, {20, 160}));
  EXPECT_FALSE(size_balance(of_sizes({30, 40}), {1e-310, 100})) << "too far apart to divide";
  EXPECT_FALSE(size_balance(of_sizes({30, 40}), {20, NAN}));
  EXPECT_FALSE(size_balance({}, size_range_of({})));
}

RC_GTEST_PROP(SizeBalance, LiesFromNothingToOneAndKnowsNoUnit, ()) {
  const auto sides = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 500)));
  std::vector<float> sides_px, doubled_px;
  for (const int side : sides) {
    sides_px.push_back(float(side));
    doubled_px.push_back(2 * float(side));
  }
  const auto pieces = of_sizes(sides_px), doubled = of_sizes(doubled_px);
  const auto balance = size_balance(pieces, size_range_of(pieces));
  const auto same = size_balance(doubled, size_range_of(doubled));
  RC_ASSERT(balance.has_value() == same.has_value());
  if (!balance) return;
  RC_ASSERT(balance->evenness >= 0 && balance->evenness <= 1 + 1e-9);
  RC_ASSERT(balance->dwarfs >= 0 && balance->dwarfs < 1);
  RC_ASSERT(std::abs(balance->evenness - same->evenness) < 1e-9);
}

TEST(NearestCopies, AreTheMedianOverThePieces) {
  // The nearest copies of the three a are 10, 10 and 90 px away; b has no copy.
  const std::vector<JudgedPiece> pieces = {square(5, {0, 0}, "a"), square(5, {10, 0}, "a"), square(5, {100, 0}, "a"),
                                           square(5, {50, 0}, "b")};
  EXPECT_EQ(median_copy_distance_px(pieces, {}), (10 + 90) / 2.);
}

TEST(NearestCopies, AreNoneWhereMostShapesStandOnce) {
  EXPECT_FALSE(median_copy_distance_px({}, {}));
  EXPECT_FALSE(median_copy_distance_px({square(5, {0, 0}, "a"), square(5, {9, 0}, "b")}, {}));
  const std::vector<JudgedPiece> half = {square(5, {0, 0}, "a"), square(5, {9, 0}, "a"), square(5, {0, 9}, "b"),
                                         square(5, {9, 9}, "c")};
  EXPECT_FALSE(median_copy_distance_px(half, {}));
}

TEST(NearestCopies, PiecesWithoutANameSayNothing) {
  EXPECT_FALSE(median_copy_distance_px({square(5, {0, 0}, ""), square(5, {9, 0}, "")}, {}));
  EXPECT_EQ(median_copy_distance_px({square(5, {0, 0}, "a"), square(5, {9, 0}, "a"), square(5, {1, 0}, "")}, {}), 9);
}

TEST(NearestCopies, AreSeenAcrossASeam) {
  const std::vector<JudgedPiece> pieces = {square(5, {2, 50}, "a"), square(5, {98, 50}, "a")};
  EXPECT_EQ(median_copy_distance_px(pieces, {}), 96);
  EXPECT_EQ(median_copy_distance_px(pieces, {100, 0}), 4);
  EXPECT_EQ(median_copy_distance_px(pieces, {0, 100}), 96);
  EXPECT_FALSE(median_copy_distance_px({square(5, {50, 50}, "a")}, {60, 60})) << "its own image is no copy";
}

/// Random pieces of four shapes on 100 x 100 px.
std::vector<JudgedPiece> random_centres() {
  std::vector<JudgedPiece> pieces;
  for (int i = *rc::gen::inRange(2, 30); i > 0; --i) {
    const Vec2 at{float(*rc::gen::inRange(0, 1000)) / 10, float(*rc::gen::inRange(0, 1000)) / 10};
    pieces.push_back(square(5, at, std::string(1, char('a' + *rc::gen::inRange(0, 4)))));
  }
  return pieces;
}

RC_GTEST_PROP(NearestCopies, AgreeWithBruteForce, ()) {
  const std::vector<JudgedPiece> pieces = random_centres();
  const Period period{*rc::gen::element(0, 100), *rc::gen::element(0, 100)};
  std::vector<double> distances;
  for (const JudgedPiece& piece : pieces) {
    double nearest = INFINITY;
    for (const JudgedPiece& other : pieces) {
      if (&other == &piece || other.shape != piece.shape) continue;
      const Vec2 d = period.nearest(other.centre_px, piece.centre_px) - piece.centre_px;
      nearest = std::min(nearest, double(norm(d)));
    }
    distances.push_back(nearest);
  }
  std::sort(distances.begin(), distances.end());
  const std::size_t n = distances.size();
  const double median = (distances[(n - 1) / 2] + distances[n / 2]) / 2;
  const auto found = median_copy_distance_px(pieces, period);
  RC_ASSERT(found.has_value() == std::isfinite(median));
  if (found) RC_ASSERT(std::abs(*found - median) < 1e-3);
}

TEST(PieceGaps, AreDistancesBetweenPolygons) {
  // Corner to side: the turned square's corner is half a diagonal from its centre.
  const float corner_px = 20 / std::sqrt(2.f);
  const std::vector<JudgedPiece> pieces = {
      square(20, {50, 50}), square(20, {50 + 10 + corner_px + 3, 50}, "", 0.785398f), square(20, {50, 200})};
  const PieceGaps gaps = piece_gaps(pieces, {}, 2);
  EXPECT_NEAR(gaps.smallest_px.value(), 3, 1e-3);
  EXPECT_EQ(gaps.alone, 1);
  EXPECT_NEAR(piece_gaps(pieces, {}, 4).alone, 1 / 3., 1e-9);
}

TEST(PieceGaps, AreNothingWhereOneLiesInTheOther) {
  EXPECT_EQ(piece_gaps({square(40, {50, 50}), square(40, {89, 50})}, {}, 2).smallest_px, 0) << "they cross";
  EXPECT_EQ(piece_gaps({square(40, {50, 50}), square(10, {50, 50})}, {}, 2).smallest_px, 0)
      << "the second in the first";
  EXPECT_EQ(piece_gaps({square(10, {50, 50}), square(40, {50, 50})}, {}, 2).smallest_px, 0)
      << "the first in the second";
  const JudgedPiece ring = laid(test::ring_outline(), 40, {50, 50}, "ring");  // its hole has a radius of 20 px
  EXPECT_NEAR(piece_gaps({ring, laid(test::disc_outline(), 15, {50, 50}, "disc")}, {}, 2).smallest_px.value(), 5, 0.01)
      << "in the hole";
}

TEST(PieceGaps, NeedTwoPieces) {
  EXPECT_FALSE(piece_gaps({}, {}, 2).smallest_px);
  EXPECT_EQ(piece_gaps({}, {}, 2).alone, 0);
  EXPECT_FALSE(piece_gaps({square(40, {50, 50})}, {}, 2).smallest_px);
  EXPECT_EQ(piece_gaps({square(40, {50, 50})}, {}, 2).alone, 1);
}

TEST(PieceGaps, DoNotDependOnWhichImageWasLaid) {
  // The second piece is moved by whole periods from its place in GoOnAcrossASeam.
  for (const float periods : {-2.f, -1.f, 1.f, 2.f}) {
    const std::vector<JudgedPiece> pieces = {square(20, {10, 50}), square(20, {85 + 100 * periods, 50})};
    EXPECT_NEAR(piece_gaps(pieces, {100, 0}, 2).smallest_px.value(), 5, 1e-3) << periods;
    EXPECT_EQ(piece_gaps(pieces, {100, 0}, 6).alone, 0) << periods;
  }
}

TEST(PieceGaps, GoOnAcrossASeam) {
  const std::vector<JudgedPiece> pieces = {square(20, {10, 50}), square(20, {85, 50})};
  EXPECT_NEAR(piece_gaps(pieces, {}, 2).smallest_px.value(), 55, 1e-3);
  EXPECT_NEAR(piece_gaps(pieces, {100, 0}, 2).smallest_px.value(), 5, 1e-3);
  EXPECT_NEAR(piece_gaps({square(20, {50, 50})}, {30, 100}, 2).smallest_px.value(), 10, 1e-3) << "its own image";
}

/// Blobs, some of which overlap, some with a separate part. Their centres lie from -0.5 to 1.5 times 260 px.
std::vector<JudgedPiece> random_blobs() {
  std::vector<JudgedPiece> pieces;
  for (int i = *rc::gen::inRange(2, 8); i > 0; --i) {
    Outline blob = test::blob_outline(*rc::gen::arbitrary<std::uint32_t>());
    blob.curves[0] = test::resampled(blob.curves[0], 60);
    if (*rc::gen::arbitrary<bool>()) {
      blob.curves.push_back(blob.curves[0]);
      for (Vec2& p : blob.curves[1]) p = p + Vec2{4, 0};
    }
    const Vec2 at{float(*rc::gen::inRange(-1300, 3900)) / 10, float(*rc::gen::inRange(-1300, 3900)) / 10};
    pieces.push_back(laid(blob, float(*rc::gen::inRange(3, 20)), at, "blob"));
  }
  return pieces;
}

Outline moved(Outline outline, Vec2 by) {
  for (auto& curve : outline.curves) {
    for (Vec2& p : curve) p = p + by;
  }
  return outline;
}

/// The gap is 0 also if only a part of one outline lies in the other.
double gap_by_brute_force(const Outline& a, const Outline& b) {
  for (const auto& curve : a.curves) {
    if (test::lies_in(b, curve[0])) return 0;
  }
  for (const auto& curve : b.curves) {
    if (test::lies_in(a, curve[0])) return 0;
  }
  return test::boundary_distance(a, b);
}

RC_GTEST_PROP(PieceGaps, AgreeWithBruteForce, ()) {
  const std::vector<JudgedPiece> pieces = random_blobs();
  const Period period{*rc::gen::element(0, 260), *rc::gen::element(0, 260)};
  const float reach_px = *rc::gen::element(2.f, 15.f);
  double smallest = INFINITY;
  std::vector<bool> alone(pieces.size(), true);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = 0; j < pieces.size(); ++j) {
      const Vec2 nearest = period.nearest(pieces[j].centre_px, pieces[i].centre_px) - pieces[j].centre_px;
      for (const Vec2 image : period.offsets()) {
        if (i == j && image == Vec2{}) continue;
        const Vec2 offset = nearest + image;
        const double px = gap_by_brute_force(pieces[i].outline_px, moved(pieces[j].outline_px, offset));
        smallest = std::min(smallest, px);
        if (px < reach_px) alone[i] = false;
      }
    }
  }
  const PieceGaps gaps = piece_gaps(pieces, period, reach_px);
  RC_ASSERT(std::abs(gaps.smallest_px.value() - smallest) < 1e-3);
  RC_ASSERT(std::abs(gaps.alone - double(std::count(alone.begin(), alone.end(), true)) / double(pieces.size())) < 1e-9);
}

/// A grid of `count` stars of 512 points.
std::vector<JudgedPiece> field_of_stars(int count, float apart_px) {
  const int columns = int(std::sqrt(double(count)));
  Outline star = test::star_outline(9, 0.7f);
  star.curves[0] = test::resampled(star.curves[0], 512);
  std::vector<JudgedPiece> pieces;
  for (int i = 0; i < count; ++i) {
    const Vec2 at{(float(i % columns) + 0.5f) * apart_px, (float(i / columns) + 0.5f) * apart_px};
    pieces.push_back(laid(star, 25, at, std::to_string(i % 100), 0.1f * float(i)));
  }
  return pieces;
}

TEST(PieceGaps, OfTwentyThousandPiecesTakeSeconds) {
  for (const float apart_px : {49.f, 53.f}) {  // with overlaps, then without
    const std::vector<JudgedPiece> pieces = field_of_stars(20000, apart_px);
    const double start_s = processor_time_s();
    const PieceGaps gaps = piece_gaps(pieces, {}, 2);
    const double taken_s = processor_time_s() - start_s;
    EXPECT_EQ(gaps.smallest_px == 0., apart_px == 49.f);
    EXPECT_LT(taken_s, 30);  // a loose bound, because sanitizers are slow
  }
}

TEST(Quality, SaysWhatAnEyeSees) {
  const Canvas canvas = make_rectangle_canvas(300, 400);
  const std::vector<JudgedPiece> pieces = {square(40, {60, 100}, "a"), square(40, {101, 100}, "a"),
                                           square(80, {200, 300}, "a")};
  const Quality own = measure_quality(canvas, pieces);
  EXPECT_EQ(own.size_range_px.min_px, 40);
  EXPECT_EQ(own.size_range_px.max_px, 80);
  EXPECT_NEAR(own.balance.value().dwarfs, 2 / 6., 1e-9);
  EXPECT_NEAR(own.copies_px.value(), 41, 1e-3);
  EXPECT_NEAR(own.copies_apart.value(), 41 / 500., 1e-5);
  EXPECT_NEAR(own.between_px.value(), 1, 1e-3);
  EXPECT_NEAR(own.alone, 1 / 3., 1e-9);
  const Quality asked = measure_quality(canvas, pieces, SizeRange{20, 160});
  EXPECT_EQ(asked.size_range_px.max_px, 160);
  EXPECT_EQ(asked.balance.value().dwarfs, 0);
}

TEST(Quality, PartsOfAPieceOutsideOfTheCanvasAreOutside) {
  JudgedPiece two = square(20, {50, 50});
  two.outline_px.curves.push_back(square(20, {130, 50}).outline_px.curves[0]);
  EXPECT_NEAR(measure_quality(make_rectangle_canvas(100, 100), {two}).outside, 0.04, 1e-6);
}

}  // namespace test_picture_measures
}  // namespace tessera
