// colour.shift: how far tones go, and that the pictures show it.
#include "io/result/tone_shift.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/colour/ciede2000.h"
#include "io/result/svg_output.h"
#include "sample_collage.h"
#include "support/colours.h"

namespace tessera::io {
namespace {

Lab lab_of(double red, double green, double blue) {
  const cv::Mat pixel(1, 1, CV_32FC3, cv::Scalar(blue / 255, green / 255, red / 255));
  cv::Mat lab;
  cv::cvtColor(pixel, lab, cv::COLOR_BGR2Lab);
  const cv::Vec3f c = lab.at<cv::Vec3f>(0, 0);
  return {c[0], c[1], c[2]};
}

/// The shapes' mean colour is a grey of lightness 60: #919191.
constexpr double kGrey = 145;

TEST(ToneShift, GoesAllTheWayWhereItMay) {
  const test::SampleCollage collage;
  const auto shifts = tone_shifts(collage.report, {"#999d95", ""}, 8);
  ASSERT_EQ(shifts.size(), 2u);
  EXPECT_EQ(shifts[0], (ToneShift{8, 12, 4}));
  EXPECT_EQ(shifts[1], ToneShift{}) << "nothing is wished there";
}

TEST(ToneShift, GoesNoFurtherThanItMay) {
  const test::SampleCollage collage;
  for (const double most : {6., 12., 30.}) {
    const ToneShift s = tone_shifts(collage.report, {"#2040ff", "#000000"}, most)[0];
    const float moved = ciede2000(lab_of(kGrey, kGrey, kGrey), lab_of(kGrey + s.red, kGrey + s.green, kGrey + s.blue));
    EXPECT_NEAR(moved, most, 2) << "in steps of 4 of 255";
    EXPECT_LT(s.red, s.green);
    EXPECT_LT(s.green, s.blue);
  }
}

TEST(ToneShift, OfNothingIsNone) {
  const test::SampleCollage collage;
  EXPECT_TRUE(tone_shifts(collage.report, {"#2040ff", "#000000"}, 0).empty());
  EXPECT_TRUE(tone_shifts(collage.report, {}, 8).empty());
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
      test::picture(200, 100, [](Vec2 p) { return p.x < 95 ? test::opaque(lab_of(255, 0, 0)) : Texel{}; });
  const std::vector<std::string> covered = covered_colours(collage.report, *target);
  ASSERT_EQ(covered.size(), 2u);
  EXPECT_TRUE(covered[0] == "#ff0000" || covered[0] == "#fe0000" || covered[0] == "#ff0100") << covered[0];
  EXPECT_EQ(covered[1], "");
}

}  // namespace
}  // namespace tessera::io
