// The picture that the pieces show: as the background of a result's pictures, and laid over the pieces.
#include "render/shown_picture.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "job/canvas/overlays.h"
#include "result/folder/result_file.h"
#include "support/artwork_samples.h"
#include "support/images.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"
#include "support/svg_samples.h"

namespace tessera {
namespace test_shown_picture {

using namespace test;

const cv::Vec4b kRust(32, 64, 160, 255), kSky(224, 160, 96, 255), kBlack(0, 0, 0, 255), kClear(10, 20, 30, 0);

cv::Vec3b opaque(const cv::Vec4b& bgra) { return {bgra[0], bgra[1], bgra[2]}; }

/// A picture with one colour on the left half and another on the right half.
cv::Mat halves(const cv::Vec4b& left, const cv::Vec4b& right, cv::Size size = {200, 100}) {
  cv::Mat bgra(size, CV_8UC4, cv::Scalar(left));
  bgra(cv::Rect(size.width / 2, 0, size.width - size.width / 2, size.height)) = cv::Scalar(right);
  return bgra;
}

double difference(const cv::Vec3b& a, const cv::Vec3b& b) { return cv::norm(a, b, cv::NORM_INF); }

/// A result that shows a picture, on a canvas of 200 x 100 px, drawn at 1 px per canvas px.
struct WithPicture : SampleCollage {
  explicit WithPicture(const cv::Mat& bgra) {
    report.output.width_px = 200;
    const std::vector<std::uint8_t> png = shown_picture_png(bgra);
    folder.write(kShownPictureName, {png.begin(), png.end()});
  }
  ScratchFolder folder;
};

/// The same result without pieces.
struct OnPicture : WithPicture {
  explicit OnPicture(const cv::Mat& bgra = halves(kRust, kSky)) : WithPicture(bgra) {
    report.placements.clear();
    report.output.background = kImageBackground;
    report.output.background_light = 1;
  }
  cv::Mat drawn_at(int width_px) {
    report.output.width_px = width_px;
    report.ground = image_background(folder.path(""), report.output, canvas);
    return drawn_picture(report);
  }
};

TEST(ImageBackground, IsThePictureAsBrightAsAsked) {
  OnPicture collage;
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 20), opaque(kRust)), 1);
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(99, 199), opaque(kSky)), 1);
  collage.report.output.background_light = 0.5;
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 20), opaque(kRust) / 2), 1);
}

TEST(ImageBackground, IsLighterThanWhatIsDark) {
  OnPicture collage(halves(kBlack, kSky));
  collage.report.output.background_light = 0.8;
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 20), cv::Vec3b(26, 26, 26)), 1);
  collage.report.output.background_light = 1;
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 20), cv::Vec3b(0, 0, 0)), 1);
  collage.report.output.background_light = 0;
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 20), cv::Vec3b(0, 0, 0)), 1);
}

TEST(ImageBackground, IsWhiteWhereThePictureIsTransparent) {
  OnPicture collage(halves(kRust, kClear));
  EXPECT_LE(difference(collage.drawn_at(200).at<cv::Vec3b>(50, 150), {255, 255, 255}), 1);
}

/// Stripes finer than 2 px of the canvas are averaged.
TEST(ImageBackground, IsSoft) {
  cv::Mat stripes(400, 800, CV_8UC4, cv::Scalar::all(255));
  for (int x = 0; x < stripes.cols; x += 4) stripes.colRange(x, x + 2) = cv::Scalar(kBlack);
  OnPicture collage(stripes);
  EXPECT_LE(difference(collage.drawn_at(800).at<cv::Vec3b>(200, 400), cv::Vec3b::all(128)), 2);
  EXPECT_EQ(collage.report.ground.svg_size, cv::Size2d(100, 50));
}

/// Enlarging mixes neighbouring pixels, but must not mix the left edge with the right one.
TEST(ImageBackground, DoesNotGoOnAtTheOtherEdge) {
  OnPicture collage;
  const cv::Mat picture = collage.drawn_at(800);
  EXPECT_LE(difference(picture.at<cv::Vec3b>(200, 0), opaque(kRust)), 1);
  EXPECT_LE(difference(picture.at<cv::Vec3b>(200, 799), opaque(kSky)), 1);
}

TEST(ImageBackground, IsTheSameInTheSvg) {
  OnPicture collage;
  const cv::Mat picture = collage.drawn_at(400);
  const std::string svg = drawn_svg(collage.report);
  EXPECT_LT(mean_difference(picture, drawn(svg, 400)), 1);
  EXPECT_EQ(svg.find("\"image\""), std::string::npos) << "no colour of that name";
}

TEST(ImageBackground, NeedsThePictureOfTheResult) {
  OnPicture collage;
  std::filesystem::remove(collage.folder.path(kShownPictureName));
  const auto message = [&] { return message_of([&] { collage.drawn_at(200); }); };
  EXPECT_NE(message().find("output.background: found \"image\", but "), std::string::npos) << message();
  EXPECT_NE(message().find("shown.png is missing; needed: the result of a job with colour.image"), std::string::npos);
  collage.folder.write(kShownPictureName, "no picture");
  EXPECT_NE(message().find("shown.png: not a PNG file"), std::string::npos) << message();
  const std::vector<std::uint8_t> png = test::encoded(cv::Mat(1, 1361, CV_8U, cv::Scalar(0)), ".png");
  collage.folder.write(kShownPictureName, {png.begin(), png.end()});
  EXPECT_NE(message().find("shown.png: found 1361 x 1 px, allowed: at most 1360 px each way"), std::string::npos)
      << message();
}

TEST(ImageBackground, OtherBackgroundsAreColours) {
  EXPECT_EQ(flat_background({.background = "#102030"}), "#102030");
  EXPECT_EQ(flat_background({.background = kNoColour}), kNoColour);
  EXPECT_EQ(flat_background({.background = kImageBackground}), "#ffffff");
}

/// A result with two pieces below its picture.
struct UnderPicture : WithPicture {
  explicit UnderPicture(double opacity, const cv::Mat& bgra = halves(kRust, kSky)) : WithPicture(bgra) {
    report.overlay_opacity = opacity;
  }
  cv::Mat drawn() {
    report.overlay = image_overlay(folder.path(""), report.overlay_opacity, canvas);
    return drawn_picture(report);
  }
};

/// BGR of `below`, mixed with the overlay of this opacity.
cv::Mat blended(const cv::Mat& below, const cv::Mat& bgra, double opacity) {
  cv::Mat bgr, mixed;
  cv::cvtColor(bgra, bgr, cv::COLOR_BGRA2BGR);
  cv::addWeighted(below, 1 - opacity, bgr, opacity, 0, mixed);
  return mixed;
}

TEST(ImageOverlay, LiesOverPiecesAndBackground) {
  const cv::Mat plain = UnderPicture(0).drawn();
  for (const double opacity : {0.1, 0.25, 0.5}) {
    UnderPicture collage(opacity);
    const cv::Mat picture = collage.drawn();
    EXPECT_LE(cv::norm(picture, blended(plain, halves(kRust, kSky), opacity), cv::NORM_INF), 2) << opacity;
    EXPECT_LT(mean_difference(picture, test::drawn(drawn_svg(collage.report), 200)), 1) << opacity;
  }
}

TEST(ImageOverlay, IsNotThereByDefault) {
  UnderPicture collage(ColourSpec{}.overlay);
  std::filesystem::remove(collage.folder.path(kShownPictureName));
  const cv::Mat picture = collage.drawn();
  EXPECT_EQ(drawn_svg(collage.report).find("overlay"), std::string::npos);
  collage.report.overlay = {};
  EXPECT_EQ(cv::norm(picture, drawn_picture(collage.report), cv::NORM_INF), 0);
}

/// The colour that a piece should show does not depend on the overlay.
TEST(ImageOverlay, KeepsWhatHasThePicturesColour) {
  for (const double opacity : {0.1, 0.25, 0.5}) {
    UnderPicture collage(opacity, halves(kRust, kRust));
    collage.report.placements.clear();
    collage.report.output.background = "#a04020";
    EXPECT_LE(cv::norm(collage.drawn(), cv::Mat(100, 200, CV_8UC3, cv::Scalar(opaque(kRust))), cv::NORM_INF), 1);
  }
}

TEST(ImageOverlay, ShowsThePicturesOwnPixels) {
  cv::Mat stripes(400, 800, CV_8UC4, cv::Scalar::all(255));
  for (int x = 0; x < stripes.cols; x += 4) stripes.colRange(x, x + 2) = cv::Scalar(kBlack);
  UnderPicture collage(0.5, stripes);
  collage.report.placements.clear();
  collage.report.output.width_px = 800;
  collage.report.output.background = "#808080";
  const cv::Mat picture = collage.drawn();
  EXPECT_NEAR(picture.at<cv::Vec3b>(200, 400)[1], 64, 1);
  EXPECT_NEAR(picture.at<cv::Vec3b>(200, 403)[1], 191, 1);
}

TEST(ImageOverlay, IsClearWhereThePictureIsTransparent) {
  const cv::Mat plain = UnderPicture(0).drawn(), picture = UnderPicture(0.5, halves(kRust, kClear)).drawn();
  EXPECT_EQ(cv::norm(picture.colRange(101, 200), plain.colRange(101, 200), cv::NORM_INF), 0);
  EXPECT_GT(cv::norm(picture.colRange(0, 99), plain.colRange(0, 99), cv::NORM_INF), 20);
}

TEST(ImageOverlay, EndsAtTheCanvasEdge) {
  UnderPicture collage(0.5);
  collage.report.canvas_edge.curves = {{{50, 0}, {150, 0}, {150, 100}, {50, 100}}};  // crosses both pieces
  const cv::Mat picture = collage.drawn();
  collage.report.overlay = {};
  const cv::Mat plain = drawn_picture(collage.report);
  for (const auto& outside : {cv::Range(0, 50), cv::Range(150, 200)}) {
    EXPECT_EQ(cv::norm(picture.colRange(outside), plain.colRange(outside), cv::NORM_INF), 0);
  }
  const auto inside = cv::Range(50, 150);
  const cv::Mat mixed = blended(plain, halves(kRust, kSky), 0.5);
  EXPECT_LE(cv::norm(picture.colRange(inside), mixed.colRange(inside), cv::NORM_INF), 2);
  collage.drawn();
  EXPECT_LT(mean_difference(picture, test::drawn(drawn_svg(collage.report), 200)), 1);
}

TEST(ImageOverlay, WithoutABackgroundShowsThroughGaps) {
  UnderPicture collage(0.25);
  collage.report.output.background = kNoColour;
  const cv::Mat picture = collage.drawn();
  ASSERT_EQ(picture.type(), CV_8UC4);
  const cv::Vec4b gap = picture.at<cv::Vec4b>(5, 5);
  EXPECT_EQ(gap[3], 64);
  EXPECT_LE(difference(opaque(gap), opaque(kRust)), 2);
  EXPECT_EQ(picture.at<cv::Vec4b>(50, 50)[3], 255) << "a piece stays opaque";
}

TEST(ImageOverlay, LiesOverBackgroundsOfRegions) {
  UnderPicture collage(0.5);
  collage.report.placements.clear();
  collage.report.canvas_edge.curves = {{{0, 0}, {200, 0}, {200, 100}, {0, 100}}};
  collage.report.canvas_edge.grounds = {{{{{-4, -4}, {204, -4}, {204, 104}, {-4, 104}}}, "#205080"}};
  const cv::Vec3b region(0x80, 0x50, 0x20);
  EXPECT_LE(difference(collage.drawn().at<cv::Vec3b>(50, 20), region / 2 + opaque(kRust) / 2), 1);
}

TEST(ImageOverlay, DoesNotDependOnTheBands) {
  UnderPicture collage(0.25);
  collage.report.output.width_px = 800;
  const cv::Mat picture = collage.drawn();
  EXPECT_EQ(cv::norm(DrawnCollage(collage.report).picture({.band_rows = 64}), picture, cv::NORM_INF), 0);
}

TEST(ImageOverlay, NeedsThePictureOfTheResult) {
  UnderPicture collage(0.25);
  std::filesystem::remove(collage.folder.path(kShownPictureName));
  const std::string message = message_of([&] { collage.drawn(); });
  EXPECT_NE(message.find("colour.overlay: found 0.25, but "), std::string::npos) << message;
  EXPECT_NE(message.find("shown.png is missing; needed: the result of a job with colour.image"), std::string::npos);
}

}  // namespace test_shown_picture
}  // namespace tessera
