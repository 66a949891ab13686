// Photographs and maps of labels, decoded.
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "artwork/drawers/drawers.h"
#include "artwork/images/photo.h"
#include "core/base/error.h"
#include "support/artwork_samples.h"

namespace tessera {
namespace test_photo {

using test::Bytes;
using test::encoded;

/// Blue on the left, green on the right, 60 x 40.
cv::Mat blue_and_green() {
  cv::Mat picture(40, 60, CV_8UC3, cv::Scalar(200, 40, 40));
  picture.colRange(30, 60) = cv::Scalar(40, 200, 40);
  return picture;
}

/// The JPEG with EXIF data that say how the camera was held.
Bytes with_orientation(Bytes jpeg, std::uint8_t orientation) {
  const Bytes exif = {0xff, 0xe1, 0, 34,   'E', 'x', 'i', 'f', 0, 0, 'M', 'M',         0, 42, 0, 0, 0, 8,
                      0,    1,    1, 0x12, 0,   3,   0,   0,   0, 1, 0,   orientation, 0, 0,  0, 0, 0, 0};
  jpeg.insert(jpeg.begin() + 2, exif.begin(), exif.end());
  return jpeg;
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

TEST(Photo, IsTurnedAsItsExifDataSay) {
  const cv::Mat turned = photo_picture(with_orientation(encoded(blue_and_green(), ".jpg"), 6), "photo");
  ASSERT_EQ(turned.size(), cv::Size(40, 60));
  EXPECT_TRUE(is_near(turned.at<cv::Vec4b>(10, 20), kBlue));
  EXPECT_TRUE(is_near(turned.at<cv::Vec4b>(50, 20), kGreen));
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
