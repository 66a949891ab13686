// The picture that the pieces show, as a result keeps it and as the background of its pictures.
#include "io/result/shown_picture.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "artwork_samples.h"
#include "io/artwork/colour_conversion.h"
#include "scratch_folder.h"
#include "support/input_error.h"
#include "svg_samples.h"

namespace tessera::io {
namespace {

using namespace test;

const cv::Vec3b kRust(32, 64, 160), kSky(224, 160, 96);

Texel texel_of(const cv::Vec3b& bgr) {
  const Lab lab = lab_of(cv::Vec3d(bgr));
  return {lab.lightness, lab.a, lab.b, 1};
}

/// The left half in one colour, the right half in another; a texel for 2 px of the canvas.
ColourTarget halves(const Texel& left, const Texel& right, cv::Size canvas_px) {
  Grid<Texel> texels((canvas_px.width + 1) / 2, (canvas_px.height + 1) / 2, left);
  for (int y = 0; y < texels.height(); ++y) {
    for (int x = texels.width() / 2; x < texels.width(); ++x) texels(x, y) = right;
  }
  return ColourTarget(texels, 2);
}

cv::Mat kept(const ColourTarget& target, const Canvas& canvas) {
  return cv::imdecode(shown_picture_png(target, canvas), cv::IMREAD_COLOR);
}

double difference(const cv::Vec3b& a, const cv::Vec3b& b) { return cv::norm(a, b, cv::NORM_INF); }

TEST(ShownPicture, CoversTheCanvasInItsColours) {
  const cv::Mat picture = kept(halves(texel_of(kRust), texel_of(kSky), {200, 100}), make_rectangle_canvas(200, 100));
  ASSERT_EQ(picture.size(), cv::Size(200, 100));
  for (const int x : {0, 50, 96}) EXPECT_LE(difference(picture.at<cv::Vec3b>(99, x), kRust), 1) << x;
  for (const int x : {103, 150, 199}) EXPECT_LE(difference(picture.at<cv::Vec3b>(0, x), kSky), 1) << x;
}

TEST(ShownPicture, IsWhiteWhereItIsTransparent) {
  const cv::Mat picture = kept(halves(texel_of(kRust), {}, {200, 100}), make_rectangle_canvas(200, 100));
  EXPECT_LE(difference(picture.at<cv::Vec3b>(50, 150), {255, 255, 255}), 1);
}

TEST(ShownPicture, OfALargeCanvasIsSmall) {
  const cv::Mat picture =
      kept(halves(texel_of(kRust), texel_of(kSky), {3000, 1000}), make_rectangle_canvas(3000, 1000));
  ASSERT_EQ(picture.size(), cv::Size(1024, 341));
  EXPECT_LE(difference(picture.at<cv::Vec3b>(340, 1023), kSky), 1);
}

/// A result without pieces on a canvas of 200 x 100 px whose background is a picture.
struct OnPicture : SampleCollage {
  OnPicture() {
    report.placements.clear();
    job.output.background = kImageBackground;
    job.output.background_light = 1;
  }
  void keep(const ColourTarget& target) {
    const std::vector<std::uint8_t> png = shown_picture_png(target, canvas);
    folder.write(kShownPictureName, {png.begin(), png.end()});
  }
  cv::Mat drawn_at(int width_px) {
    job.output.width_px = width_px;
    report.ground = image_background(folder.path(""), job.output, canvas);
    return drawn_picture(report);
  }
  ScratchFolder folder;
};

TEST(ImageBackground, IsThePictureAsBrightAsAsked) {
  OnPicture collage;
  collage.keep(halves(texel_of(kRust), texel_of(kSky), {200, 100}));
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 20), kRust), 1);
  collage.job.output.background_light = 0.5;
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 20), kRust / 2), 1);
}

TEST(ImageBackground, IsLighterThanWhatIsDark) {
  OnPicture collage;
  collage.keep(halves({0, 0, 0, 1}, texel_of(kSky), {200, 100}));
  collage.job.output.background_light = 0.8;
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 20), cv::Vec3b(26, 26, 26)), 1);
  collage.job.output.background_light = 1;
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 20), cv::Vec3b(0, 0, 0)), 1);
  collage.job.output.background_light = 0;
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 20), cv::Vec3b(0, 0, 0)), 1);
}

/// Shown larger, neighbours are mixed, but the left edge is not mixed with the right one.
TEST(ImageBackground, DoesNotGoOnAtTheOtherEdge) {
  OnPicture collage;
  collage.keep(halves(texel_of(kRust), texel_of(kSky), {200, 100}));
  const cv::Mat picture = collage.drawn_at(800);
  EXPECT_LE(difference(picture.at<cv::Vec3b>(200, 0), kRust), 1);
  EXPECT_LE(difference(picture.at<cv::Vec3b>(200, 799), kSky), 1);
}

TEST(ImageBackground, IsTheSameInTheSvg) {
  OnPicture collage;
  collage.keep(halves(texel_of(kRust), texel_of(kSky), {200, 100}));
  const cv::Mat picture = collage.drawn_at(400);
  const std::string svg = drawn_svg(collage.report);
  EXPECT_LT(mean_difference(picture, drawn(svg, 400)), 1);
  EXPECT_EQ(svg.find("\"image\""), std::string::npos) << "no colour of that name";
}

TEST(ImageBackground, NeedsThePictureOfTheResult) {
  OnPicture collage;
  const auto message = [&] { return message_of([&] { collage.drawn_at(200); }); };
  EXPECT_NE(message().find("output.background: found \"image\", but "), std::string::npos) << message();
  EXPECT_NE(message().find("shown.png is missing; needed: the result of a job with colour.image"), std::string::npos);
  collage.folder.write(kShownPictureName, "no picture");
  EXPECT_NE(message().find("shown.png: not a PNG file"), std::string::npos) << message();
}

TEST(ImageBackground, OtherBackgroundsAreColours) {
  EXPECT_EQ(flat_background({.background = "#102030"}), "#102030");
  EXPECT_EQ(flat_background({.background = kNoColour}), kNoColour);
  EXPECT_EQ(flat_background({.background = kImageBackground}), "#ffffff");
}

}  // namespace
}  // namespace tessera::io
