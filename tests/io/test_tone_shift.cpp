// colour.shift: how far tones go, and that the pictures show it.
#include "io/result/tone_shift.h"

#include <gtest/gtest.h>

#include "core/colour/ciede2000.h"
#include "io/artwork/colour_conversion.h"
#include "io/result/svg_output.h"
#include "sample_collage.h"
#include "support/colours.h"

namespace tessera::io {
namespace {

/// The shapes' mean colour is a grey of lightness 60: #919191.
constexpr double kGrey = 145;

/// Two pieces.
struct Covering : test::SampleCollage {
  explicit Covering(std::vector<std::string> covered) { report.covered = std::move(covered); }
};

TEST(ToneShift, GoesAllTheWayWhereItMay) {
  const Covering collage({"#999d95", ""});
  const auto shifts = tone_shifts(collage.report, 8);
  ASSERT_EQ(shifts.size(), 2u);
  EXPECT_EQ(shifts[0], (ToneShift{8, 12, 4}));
  EXPECT_EQ(shifts[1], ToneShift{}) << "nothing is wished there";
}

TEST(ToneShift, GoesNoFurtherThanItMay) {
  const Covering collage({"#2040ff", "#000000"});
  for (const double most : {6., 12., 30.}) {
    const ToneShift s = tone_shifts(collage.report, most)[0];
    const float moved = ciede2000(lab_of(cv::Vec3d(kGrey, kGrey, kGrey)),
                                  lab_of(cv::Vec3d(kGrey + s.blue, kGrey + s.green, kGrey + s.red)));
    EXPECT_LE(moved, most);
    EXPECT_GT(moved, most - 3) << "in steps of 4 of 255";
    EXPECT_LE(s.red, s.green);
    EXPECT_LT(s.green, s.blue);
  }
}

TEST(ToneShift, StartsFromTheColourThatIsDrawn) {
  Covering collage({"#ff0000", "#808080"});
  collage.report.colours = {"#ff0000", "#808080"};
  const auto shifts = tone_shifts(collage.report, 20);
  EXPECT_EQ(shifts[0], ToneShift{}) << "a silhouette in the colour of what it covers";
  EXPECT_EQ(shifts[1], ToneShift{});
}

TEST(ToneShift, OfNothingIsNone) {
  EXPECT_TRUE(tone_shifts(Covering({"#2040ff", "#000000"}).report, 0).empty());
  EXPECT_TRUE(tone_shifts(Covering({}).report, 8).empty());
}

TEST(ToneShift, KnowsWhatPiecesCover) {
  test::SampleCollage collage;  // at x = 50 and 140
  PlacedShapes shapes;
  for (const ShapeId id : {ShapeId{7}, ShapeId{3}}) {
    Shape shape = collage.report.shape(id);
    shape.colour_grid = test::two_toned_grid({50, 0, 0}, {50, 0, 0});
    shapes.add(id, shape);
  }
  collage.report.shapes = shapes;
  const auto target =
      test::picture(200, 100, [](Vec2 p) { return p.x < 95 ? test::opaque(lab_of(cv::Vec3d(0, 0, 255))) : Texel{}; });
  const std::vector<std::string> covered = covered_colours(collage.report, *target);
  ASSERT_EQ(covered.size(), 2u);
  EXPECT_TRUE(covered[0] == "#ff0000" || covered[0] == "#fe0000" || covered[0] == "#ff0100") << covered[0];
  EXPECT_EQ(covered[1], "");
}

}  // namespace
}  // namespace tessera::io
