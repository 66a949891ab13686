// Pictures without transparency: their background is cut out, and nothing else becomes transparent.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "artwork/artwork_render.h"
#include "artwork/images/mask.h"
#include "support/artwork_samples.h"
#include "support/drawn_collage.h"
#include "support/sample_collage.h"

namespace tessera {
namespace test_picture_ground {

using test::Bytes;
using test::encoded;

const cv::Scalar kWhite = cv::Scalar::all(255), kGrey = cv::Scalar::all(128), kRust(32, 64, 192);

cv::Mat plain(const cv::Scalar& colour) { return {300, 300, CV_8UC3, colour}; }

void disc(cv::Mat& picture, int radius_px, const cv::Scalar& colour) {
  cv::circle(picture, {150, 150}, radius_px, colour, cv::FILLED, cv::LINE_AA);
}

/// A grey disc around one of rust, on white.
cv::Mat two_discs() {
  cv::Mat picture = plain(kWhite);
  disc(picture, 120, kGrey);
  disc(picture, 50, kRust);
  return picture;
}

cv::Mat alpha_of(const cv::Mat& bgra) {
  cv::Mat alpha;
  cv::extractChannel(bgra, alpha, 3);
  return alpha;
}

/// The least alpha within `radius_px` around the middle.
int least_alpha(const cv::Mat& bgra, int radius_px) {
  cv::Mat inside = cv::Mat::zeros(bgra.size(), CV_8U);
  cv::circle(inside, {150, 150}, radius_px, cv::Scalar(255), cv::FILLED);
  double least = 0;
  cv::minMaxLoc(alpha_of(bgra), &least, nullptr, nullptr, nullptr, inside);
  return int(least);
}

TEST(PictureGround, WhatIsNearerToTheGroundInColourIsNoLessOpaque) {
  for (const char* extension : {".png", ".jpg", ".bmp"}) {
    const cv::Mat cut = render_artwork(encoded(two_discs(), extension), "discs", 300);
    EXPECT_EQ(least_alpha(cut, 117), 255) << extension;
    const cv::Vec4b grey = cut.at<cv::Vec4b>(150, 60);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(grey[c], 128, 3) << extension;
    EXPECT_EQ(cut.at<cv::Vec4b>(10, 10)[3], 0) << extension;
    EXPECT_NEAR(cv::sum(alpha_of(cut))[0] / 255, CV_PI * 120 * 120, 0.01 * CV_PI * 120 * 120) << extension;
  }
}

/// Draws the picture as a piece of a collage.
TEST(PictureGround, ThePieceHidesTheCanvas) {
  test::SampleCollage sample;
  sample.report.output.background = "#0000ff";
  const Bytes jpeg = encoded(two_discs(), ".jpg");
  test::embed_artwork(sample.report.shapes[0], std::string(jpeg.begin(), jpeg.end()), 300, 300, 213);
  const cv::Mat picture = test::drawn_picture(sample.report);
  std::size_t grey = 0, mixed = 0;
  for (const cv::Vec3b& p : cv::Mat_<cv::Vec3b>(picture)) {
    grey += cv::norm(cv::Vec3i(p) - cv::Vec3i::all(128), cv::NORM_INF) <= 4;
    mixed += cv::norm(cv::Vec3i(p) - cv::Vec3i(0x80, 0x62, 0x62), cv::NORM_INF) <= 8;
  }
  EXPECT_GT(grey, 1000u);
  EXPECT_LT(mixed, grey / 50) << "the canvas shows through";
}

TEST(PictureGround, WhatIsEnclosedIsOpaqueWhateverItsColour) {
  cv::Mat face = plain(kWhite);
  disc(face, 120, cv::Scalar::all(0));
  disc(face, 110, kWhite);
  disc(face, 30, kRust);
  for (const char* extension : {".png", ".jpg"}) {
    const cv::Mat cut = render_artwork(encoded(face, extension), "face", 300);
    EXPECT_EQ(least_alpha(cut, 117), 255) << extension;
    EXPECT_GE(cut.at<cv::Vec4b>(150, 60)[0], 250) << extension;
  }
}

TEST(PictureGround, PaleThingsStandOutFromTheGround) {
  for (const int shade : {225, 200, 160}) {
    cv::Mat picture = plain(kWhite);
    disc(picture, 120, cv::Scalar(255, shade, shade));
    disc(picture, 40, cv::Scalar::all(0));
    const cv::Mat cut = render_artwork(encoded(picture, ".png"), "pale", 300);
    EXPECT_EQ(least_alpha(cut, 117), 255) << shade;
    EXPECT_EQ(cut.at<cv::Vec4b>(10, 10)[3], 0) << shade;
  }
}

/// The holes of a mask stay holes: a ring as a canvas, a letter.
TEST(PictureGround, MasksOfTwoColoursKeepTheirHoles) {
  for (const auto& [shape, ground] :
       {std::pair(cv::Scalar::all(0), kWhite), {kWhite, cv::Scalar::all(0)}, {kRust, kGrey}}) {
    cv::Mat ring = plain(ground);
    disc(ring, 120, shape);
    disc(ring, 50, ground);
    for (const char* extension : {".png", ".jpg"}) {
      const cv::Mat cut = render_artwork(encoded(ring, extension), "ring", 300);
      EXPECT_LE(cut.at<cv::Vec4b>(150, 150)[3], 12) << extension;
      EXPECT_GE(cut.at<cv::Vec4b>(150, 65)[3], 243) << extension;
    }
  }
}

/// Alpha is 0 or 255 everywhere except in that band.
TEST(PictureGround, OnlyABandBesideTheGroundIsInBetween) {
  const cv::Mat alpha = alpha_of(render_artwork(encoded(two_discs(), ".jpg"), "discs", 300));
  int between = 0;
  for (int y = 0; y < alpha.rows; ++y) {
    for (int x = 0; x < alpha.cols; ++x) {
      const int a = alpha.at<std::uint8_t>(y, x);
      if (a == 0 || a == 255) continue;
      ++between;
      EXPECT_NEAR(std::hypot(x - 150, y - 150), 120, 3.5) << x << " " << y;
    }
  }
  EXPECT_GT(between, 300) << "the edge is antialiased";
}

/// Laid over its ground, the picture looks as before.
TEST(PictureGround, OverItsOwnGroundThePictureStaysWhatItWas) {
  const cv::Mat picture = two_discs();
  const cv::Mat cut = cut_from_background(picture);
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const cv::Vec4b& p = cut.at<cv::Vec4b>(y, x);
      if (p[3] == 0) continue;
      for (int c = 0; c < 3; ++c) {
        const double seen = (p[c] * p[3] + 255. * (255 - p[3])) / 255;
        EXPECT_NEAR(seen, picture.at<cv::Vec3b>(y, x)[c], 2) << x << " " << y;
      }
    }
  }
}

TEST(PictureGround, MayBeKept) {
  const cv::Mat kept = render_artwork(encoded(two_discs(), ".png"), "discs", 300, Background::kept);
  EXPECT_EQ(kept.at<cv::Vec4b>(10, 10), cv::Vec4b(255, 255, 255, 255));
  EXPECT_EQ(kept.at<cv::Vec4b>(150, 150), cv::Vec4b(32, 64, 192, 255));
}

}  // namespace test_picture_ground
}  // namespace tessera
