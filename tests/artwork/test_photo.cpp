// The decoding of photographs and of label maps.
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "artwork/drawers/drawers.h"
#include "artwork/images/photo.h"
#include "artwork/images/raster_page.h"
#include "artwork/images/whole_picture.h"
#include "core/base/error.h"
#include "support/artwork_samples.h"

namespace tessera {
namespace test_photo {

using test::Bytes;
using test::encoded;

/// A picture of 60 x 40, blue on the left and green on the right.
cv::Mat blue_and_green() {
  cv::Mat picture(40, 60, CV_8UC3, cv::Scalar(200, 40, 40));
  picture.colRange(30, 60) = cv::Scalar(40, 200, 40);
  return picture;
}

bool is_near(const cv::Vec4b& pixel, const cv::Vec4b& expected) {
  for (int c = 0; c < 4; ++c)
    if (std::abs(int(pixel[c]) - int(expected[c])) > 12) return false;
  return true;
}

const cv::Vec4b kBlue(200, 40, 40, 255), kGreen(40, 200, 40, 255);

TEST(Photo, IsReadInEveryFormat) {
  for (const char* extension : {".png", ".jpg", ".tiff", ".webp", ".bmp"}) {
    const cv::Mat picture = photo_picture(encoded(blue_and_green(), extension), "photo");
    ASSERT_EQ(picture.size(), cv::Size(60, 40)) << extension;
    ASSERT_EQ(picture.type(), CV_8UC4) << extension;
    EXPECT_TRUE(is_near(picture.at<cv::Vec4b>(20, 10), kBlue)) << extension;
    EXPECT_TRUE(is_near(picture.at<cv::Vec4b>(20, 50), kGreen)) << extension;
  }
}

constexpr const char* kTurnedFormats[] = {".jpg", ".png", ".webp", ".tiff"};

TEST(Photo, IsTurnedAsItsExifDataSay) {
  for (const char* extension : kTurnedFormats) {
    const cv::Mat turned = photo_picture(test::encoded_with_orientation(blue_and_green(), extension, 6), "photo");
    ASSERT_EQ(turned.size(), cv::Size(40, 60)) << extension;
    EXPECT_TRUE(is_near(turned.at<cv::Vec4b>(10, 20), kBlue)) << extension;
    EXPECT_TRUE(is_near(turned.at<cv::Vec4b>(50, 20), kGreen)) << extension;
  }
}

/// The picture serves as a shape's drawing, a canvas or a zone, and its background is cut out. It shows a disc on the left of a landscape
/// page.
TEST(RasterPage, IsTurnedAsItsExifDataSay) {
  cv::Mat stored(40, 60, CV_8UC3, cv::Scalar::all(255));
  cv::circle(stored, {20, 20}, 12, cv::Scalar(200, 40, 40), cv::FILLED);
  for (const char* extension : kTurnedFormats) {
    const Bytes bytes = test::encoded_with_orientation(stored, extension, 6);
    const auto page = open_raster_page(bytes, "disc", Background::cut_out);
    EXPECT_EQ(page->natural_size(), cv::Size2d(40, 60)) << extension;
    const cv::Mat drawn = page->draw(60, {0, 0, 40, 60});
    EXPECT_EQ(drawn.at<cv::Vec4b>(20, 20)[3], 255) << extension;
    EXPECT_EQ(drawn.at<cv::Vec4b>(45, 20)[3], 0) << extension;
  }
}

TEST(RasterPage, OfAnAnimationOrOfPagesIsTheFirstPicture) {
  cv::Mat first(40, 60, CV_8UC3, cv::Scalar::all(255));
  cv::circle(first, {20, 20}, 12, cv::Scalar(200, 40, 40), cv::FILLED);
  const cv::Mat second(40, 60, CV_8UC3, cv::Scalar(40, 200, 40));
  const auto page = open_raster_page(test::animated_webp({first, second}), "disc", Background::cut_out);
  EXPECT_TRUE(page->loses_pictures());
  EXPECT_EQ(page->draw(60, {0, 0, 60, 40}).at<cv::Vec4b>(20, 20), cv::Vec4b(200, 40, 40, 255));
  EXPECT_FALSE(open_raster_page(test::webp_of(first), "disc", Background::cut_out)->loses_pictures());
  const Bytes pages = test::tiff_of_pages({first, second});
  EXPECT_TRUE(open_raster_page(pages, "disc", Background::cut_out)->loses_pictures());
  EXPECT_FALSE(open_raster_page(test::tiff_of(first), "disc", Background::cut_out)->loses_pictures());
}

TEST(WholePicture, IsTurnedWithItsAlpha) {
  cv::Mat stored;
  cv::cvtColor(blue_and_green(), stored, cv::COLOR_BGR2BGRA);
  stored.colRange(0, 30).setTo(cv::Scalar(200, 40, 40, 100));
  for (const char* extension : {".png", ".webp", ".tiff"}) {
    const cv::Mat turned = whole_picture(test::encoded_with_orientation(stored, extension, 8), "ground", 100);
    ASSERT_EQ(turned.size(), cv::Size(40, 60)) << extension;
    EXPECT_EQ(turned.at<cv::Vec4b>(50, 20)[3], 100) << extension;
    EXPECT_EQ(turned.at<cv::Vec4b>(10, 20)[3], 255) << extension;
  }
}

TEST(Labels, AreTurnedAsTheirPhotoIs) {
  cv::Mat stored(2, 3, CV_8U, cv::Scalar(0));
  stored.at<std::uint8_t>(0, 0) = 7;
  const cv::Mat labels = label_picture(test::encoded_with_orientation(stored, ".png", 6), "labels");
  ASSERT_EQ(labels.size(), cv::Size(2, 3));
  EXPECT_EQ(labels.at<std::int32_t>(0, 1), 7);
}

TEST(Photo, SixteenBitsAChannelBecomeEight) {
  cv::Mat deep;
  blue_and_green().convertTo(deep, CV_16U, 257);
  EXPECT_TRUE(is_near(photo_picture(encoded(deep, ".png"), "photo").at<cv::Vec4b>(20, 10), kBlue));
}

TEST(Photo, IsOpaqueWhateverAlphaItHas) {
  cv::Mat clear;
  cv::cvtColor(blue_and_green(), clear, cv::COLOR_BGR2BGRA);
  clear.colRange(0, 20).setTo(cv::Scalar(200, 40, 40, 0));
  EXPECT_EQ(photo_picture(encoded(clear, ".png"), "photo").at<cv::Vec4b>(20, 10)[3], 255);
}

TEST(Photo, WhatIsNoneIsRefusedWithItsName) {
  for (const Bytes& bytes : {Bytes{}, Bytes{1, 2, 3}, test::svg(test::kDisc)}) {
    try {
      photo_picture(bytes, "wall.jpg");
      FAIL();
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("wall.jpg: ")) << error.what();
    }
  }
}

TEST(Labels, KeepTheirValues) {
  cv::Mat map(40, 60, CV_16U, cv::Scalar(0));
  map.at<std::uint16_t>(5, 7) = 65535;
  map.at<std::uint16_t>(6, 8) = 300;
  Drawers drawers({});
  const cv::Mat labels = drawers.labels(encoded(map, ".png"), "map.png");
  ASSERT_EQ(labels.type(), CV_32SC1);
  ASSERT_EQ(labels.size(), map.size());
  EXPECT_EQ(labels.at<int>(5, 7), 65535);
  EXPECT_EQ(labels.at<int>(6, 8), 300);
  EXPECT_EQ(cv::countNonZero(labels), 2);
}

TEST(Labels, ColoursAreNone) { EXPECT_THROW(label_picture(encoded(blue_and_green(), ".png"), "map.png"), InputError); }

TEST(Photo, IsDecodedByADrawer) {
  Drawers drawers({});
  for (const char* extension : {".png", ".jpg", ".tiff", ".webp", ".bmp"}) {
    const cv::Mat picture = drawers.photo(encoded(blue_and_green(), extension), "photo");
    ASSERT_EQ(picture.size(), cv::Size(60, 40)) << extension;
    EXPECT_TRUE(is_near(picture.at<cv::Vec4b>(20, 50), kGreen)) << extension;
  }
  EXPECT_THROW(drawers.photo(Bytes{1, 2, 3}, "photo.png"), InputError);
}

}  // namespace test_photo
}  // namespace tessera
