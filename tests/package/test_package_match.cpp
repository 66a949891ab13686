// Matches of the public library: poses in any unit, parts, symmetries; and bad input.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "sample_outlines.h"

namespace tessera {
namespace test_package_match {

using matching::Match;
using matching::match;
using matching::Outline;
using test::error_of;

TEST(PackageMatch, FindsThePoseInAnyUnits) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Outline b = test::random_outline(seed);
    const double scale = std::pow(10, 2 * int(seed) - 9);
    const matching::Similarity a_from_b = test::similarity(scale, 0.6 * seed - 3, 1e4 * scale, -2e3 * scale);
    const std::vector<Match> found = match(test::mapped(b, a_from_b), b);
    ASSERT_EQ(found.size(), 1u) << seed;
    EXPECT_GT(found[0].score, 0.97) << seed;
    EXPECT_NEAR(found[0].a_from_b.scale() / scale, 1, 0.01) << seed;
    for (const matching::Point p : {matching::Point{1, 0}, {0, 1}, {-1, -1}}) {
      const matching::Point at = found[0].a_from_b.apply(p);
      const matching::Point expected = a_from_b.apply(p);
      EXPECT_LT(std::hypot(at.x - expected.x, at.y - expected.y), 0.02 * scale) << seed;
    }
  }
}

TEST(PackageMatch, RunsAreArclengthsOfTheGivenCurves) {
  const Outline whole = test::random_outline(7);
  const double length = length_of(whole);
  Outline part = whole;  // the first 60 % of it, three times as large
  part.curves[0].closed = false;
  part.curves[0].points.resize(240);
  part = test::mapped(part, test::similarity(3, 1, 5, 6));
  const std::vector<Match> found = match(whole, part);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].a_from_b.scale(), 1.0 / 3, 0.01);
  EXPECT_GT(found[0].part_of_b, 0.9);
  EXPECT_NEAR(found[0].part_of_a, 0.6, 0.06);
  ASSERT_EQ(found[0].runs.size(), 1u);
  EXPECT_NEAR(found[0].runs[0].of_a.to - found[0].runs[0].of_a.from, 0.6 * length, 0.06 * length);
  EXPECT_NEAR(found[0].runs[0].of_b.to - found[0].runs[0].of_b.from, 3 * 0.6 * length, 3 * 0.06 * length);
  EXPECT_FALSE(found[0].runs[0].reversed);
}

TEST(PackageMatch, SymmetriesAreMatchesThatDiffer) {
  Outline star;
  for (int i = 0; i < 10; ++i) {
    const double angle = 2 * M_PI * i / 10;
    if (star.curves.empty()) star.curves.emplace_back();
    star.curves[0].points.push_back({(i % 2 ? 40 : 100) * std::cos(angle), (i % 2 ? 40 : 100) * std::sin(angle)});
  }
  EXPECT_EQ(match(star, star, 5).size(), 5u);
  EXPECT_TRUE(match(star, star, 0).empty());
}

TEST(PackageMatch, BadInputSaysWhichOutline) {
  const Outline good = test::circle(1);
  const Outline empty;
  Outline wrong = good;
  wrong.curves[0].points[5].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of([&] { match(empty, good); }), "A: an outline without curves; allowed: 1 or more");
  EXPECT_EQ(error_of([&] { match(good, wrong); }),
            "B: curve 0: point 5: found the coordinate nan, allowed: -1e15 to 1e15");
}

/// Its points differ in double precision, but are equal in the core's numbers.
TEST(PackageMatch, ACurveThatIsOnePointBesideALargeOneIsRefused) {
  matching::Outline outline = matching::make_outline({{{0, 0}, {1024, 0}, {1024, 1024}, {0, 1024}}});
  matching::Curve speck{{}, true};
  for (int i = 0; i < 100; ++i) speck.points.push_back({1000, 1000 + 0.000012 * (i % 2)});
  outline.curves.push_back(speck);
  EXPECT_EQ(error_of([&] { match(outline, outline); }).substr(0, 12), "A: curve 1: ");
}

TEST(PackageMatch, StraightLinesMatchByTheirEnds) {
  const Outline line{{{{{0, 0}, {100, 0}}, false}}};
  const Outline other{{{{{5, 5}, {5, 55}}, false}}};
  const std::vector<Match> found = match(line, other, 4);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].a_from_b.scale(), 2, 0.01);
}

/// Time and memory stay bounded for any curves, smooth or pure noise.
TEST(PackageMatch, AMillionPoints) {
  const Outline small = test::random_outline(3);
  const Outline smooth = test::random_outline(3, 1'000'000);
  const std::vector<Match> found = match(smooth, small);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].score, 0.97);
  std::mt19937 bits(5);
  Outline noise;
  noise.curves.emplace_back();
  for (int i = 0; i < 1'000'000; ++i) noise.curves[0].points.push_back({double(bits()), double(bits())});
  match(noise, small);
  noise.smoothing = 1e-6;  // much narrower than the distances of its points
  EXPECT_NO_THROW(match(small, noise));
}

TEST(PackageMatch, AThousandCurves) {
  Outline many;
  for (int k = 0; k < 1000; ++k) {
    const Outline one =
        test::mapped(test::random_outline(std::uint32_t(k), 40), {1, 0, 4.0 * (k % 32), 4.0 * (k / 32)});
    many.curves.push_back(one.curves[0]);
  }
  EXPECT_TRUE(match(many, test::random_outline(17, 40)).empty());  // each curve is too small a part of all
}

TEST(PackageMatch, TinySmoothingEnds) {
  Outline outline = test::random_outline(3);
  outline.smoothing = 1e-300;
  EXPECT_EQ(match(outline, outline).size(), 1u);
}

}  // namespace test_package_match
}  // namespace tessera
