// The picture: where artworks lie, how their edges look, what stands in for lost ones.
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "artwork_samples.h"
#include "io/result/png_output.h"
#include "sample_collage.h"

namespace tessera::io {
namespace {

using test::SampleCollage;

constexpr char kSvgHead[] = R"(<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" viewBox="0 0 100 100">)";

/// A page of 100 x 100 whose left half is red and right half blue, in a square of 80.
const std::string kTwoHalves =
    std::string(kSvgHead) +
    R"(<rect x="10" y="10" width="40" height="80" fill="red"/><rect x="50" y="10" width="40" height="80" fill="blue"/></svg>)";

cv::Vec3b at(const cv::Mat& picture, int x, int y) { return picture.at<cv::Vec3b>(y, x); }

const cv::Vec3b kRed(0, 0, 255);
const cv::Vec3b kBlue(255, 0, 0);
const cv::Vec3b kBackground(0xc0, 0xe0, 0xff);

/// One square of 40 canvas px about (100, 50) of the 200 x 100 canvas; the picture is twice as large.
struct OneSquare : SampleCollage {
  explicit OneSquare(float rotation_rad) {
    report.shapes[0] = test::make_test_shape("square", test::rectangle_outline(1, 1));
    test::embed_artwork(report.shapes[0], kTwoHalves, 100, 100, 80);
    report.placements.clear();
    place(7, 40, {100, 50}, rotation_rad);
  }
};

TEST(Png, ArtworkLiesWhereItIsPlaced) {
  const OneSquare sample(0);
  const cv::Mat picture = draw_collage(sample.report, false);
  EXPECT_EQ(picture.size(), cv::Size(400, 200));
  EXPECT_EQ(at(picture, 161, 100), kRed);
  EXPECT_EQ(at(picture, 198, 61), kRed);
  EXPECT_EQ(at(picture, 201, 138), kBlue);
  EXPECT_EQ(at(picture, 238, 100), kBlue);
  EXPECT_EQ(at(picture, 158, 100), kBackground);
  EXPECT_EQ(at(picture, 241, 100), kBackground);
  EXPECT_EQ(at(picture, 200, 58), kBackground);
}

TEST(Png, OfARunWithWorkLeftIsNotLarge) {
  OneSquare sample(0);
  sample.job.output.width_px = 5000;
  EXPECT_EQ(draw_collage(sample.report, true).size(), cv::Size(2000, 1000));
  EXPECT_EQ(draw_collage(sample.report, false).size(), cv::Size(5000, 2500));
}

TEST(Png, RotationTurnsFromXToY) {
  const OneSquare sample(std::numbers::pi_v<float> / 2);
  const cv::Mat picture = draw_collage(sample.report, false);
  EXPECT_EQ(at(picture, 200, 65), kRed);  // what was on the left is above
  EXPECT_EQ(at(picture, 200, 135), kBlue);
}

TEST(Png, EdgesAreSmoothAndNoWiderThanAPixelOrTwo) {
  const OneSquare sample(0.3f);
  const cv::Mat picture = draw_collage(sample.report, false);
  int mixed = 0;
  for (int x = 0; x < picture.cols; ++x) {
    const cv::Vec3b c = at(picture, x, 100);
    mixed += c != kRed && c != kBlue && c != kBackground;
  }
  EXPECT_GE(mixed, 2);
  EXPECT_LE(mixed, 8);  // two outer edges and the one between the halves
}

TEST(Png, SmallPiecesAreAveragedNotSampled) {
  // Stripes of a page's hundredth, drawn at 20 px: an even grey, no pattern.
  std::string stripes = kSvgHead;
  for (int x = 0; x < 100; x += 2) {
    stripes += "<rect x=\"" + std::to_string(x) + "\" width=\"1\" height=\"100\" fill=\"black\"/>";
    stripes += "<rect x=\"" + std::to_string(x + 1) + "\" width=\"1\" height=\"100\" fill=\"white\"/>";
  }
  SampleCollage sample;
  test::embed_artwork(sample.report.shapes[0], stripes + "</svg>", 100, 100, 100);
  sample.report.placements.clear();
  sample.place(7, 80, {60, 50}, 0.7f);  // makes the artwork be drawn large
  sample.place(7, 10, {160, 50}, 0.4f);
  const cv::Mat picture = draw_collage(sample.report, false);
  cv::Scalar mean, deviation;
  cv::meanStdDev(picture(cv::Rect(315, 95, 10, 10)), mean, deviation);
  EXPECT_NEAR(mean[0], 128, 6);
  EXPECT_LT(deviation[0], 20);  // a box filter leaves a few percent of the stripes; sampling would leave 80 and more
}

TEST(Png, OutsideOfTheRegionIsWhiteWithASmoothEdge) {
  SampleCollage sample;
  Grid<float> mask(400, 200, 0.f);
  for (int y = 0; y < 200; ++y) std::fill(mask.row(y) + 100, mask.row(y) + 301, 1.f);
  sample.canvas = make_mask_canvas(mask);
  sample.report.placements.clear();
  const cv::Mat picture = draw_collage(sample.report, false);
  EXPECT_EQ(at(picture, 50, 100), cv::Vec3b(255, 255, 255));
  EXPECT_EQ(at(picture, 200, 100), kBackground);
  EXPECT_EQ(at(picture, 103, 100), kBackground);
  EXPECT_EQ(at(picture, 304, 100), cv::Vec3b(255, 255, 255));
}

TEST(Png, WithoutAnyArtworkTheOutlineIsFilled) {
  const SampleCollage sample;
  const cv::Mat picture = draw_collage(sample.report, false);
  const cv::Vec3b disc = at(picture, 100, 100);
  EXPECT_NEAR(disc[0], 145, 3);  // L* = 60 without colour
  EXPECT_EQ(disc[0], disc[2]);
  EXPECT_EQ(at(picture, 280, 100), kBackground);  // the hole of the ring
  EXPECT_NE(at(picture, 280, 45), kBackground);
}

TEST(Png, LostOrDamagedOriginalsGiveWayToTheThumbnail) {
  for (const std::string& original : {std::string(), std::string("<svg nonsense")}) {
    OneSquare sample(0);
    Artwork& artwork = sample.report.shapes[0].artwork;
    artwork.original.assign(original.begin(), original.end());
    artwork.path = "/nowhere/lost.svg";
    artwork.thumbnail_png = test::encoded(cv::Mat(192, 192, CV_8UC4, cv::Scalar(0, 255, 0, 255)), ".png");
    EXPECT_EQ(at(draw_collage(sample.report, false), 200, 100), cv::Vec3b(0, 255, 0));
  }
}

TEST(Png, QuickDrawsThumbnailsOnly) {
  OneSquare sample(0);
  sample.report.shapes[0].artwork.thumbnail_png =
      test::encoded(cv::Mat(192, 192, CV_8UC4, cv::Scalar(0, 255, 0, 255)), ".png");
  EXPECT_EQ(at(draw_collage(sample.report, true), 200, 100), cv::Vec3b(0, 255, 0));
  EXPECT_EQ(at(draw_collage(sample.report, false), 190, 100), kRed);
}

TEST(Png, LaterPiecesLieOnEarlierOnesAndPiecesMayCrossTheEdge) {
  OneSquare sample(0);
  sample.place(7, 40, {110, 50}, std::numbers::pi_v<float>);
  sample.place(7, 40, {0, 0}, 0);
  sample.place(7, 40, {900, 900}, 0);
  const cv::Mat picture = draw_collage(sample.report, false);
  EXPECT_EQ(at(picture, 210, 100), kBlue);  // turned by half
  EXPECT_EQ(at(picture, 230, 100), kRed);
  EXPECT_EQ(at(picture, 20, 20), kBlue);
}

TEST(Png, TheFileDecodesToThePicture) {
  const OneSquare sample(0.2f);
  const cv::Mat decoded = cv::imdecode(collage_png(sample.report, false), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(cv::norm(decoded, draw_collage(sample.report, false), cv::NORM_INF), 0);
}

}  // namespace
}  // namespace tessera::io
