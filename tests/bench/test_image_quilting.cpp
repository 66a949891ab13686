// Image quilting: cuts of known errors, and quilts of photos whose pixels tell where they come from.
#include "image_quilting.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace tessera::bench {
namespace test_image_quilting {

/// A photo whose pixels hold their own place, and noise: (x, y, noise), up to 256 px a side.
cv::Mat photo_of_places(cv::Size size) {
  cv::RNG random(5);
  cv::Mat photo(size, CV_8UC3);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x)
      photo.at<cv::Vec3b>(y, x) = {std::uint8_t(x), std::uint8_t(y), std::uint8_t(random.uniform(0, 256))};
  }
  return photo;
}

/// Horizontal stripes that repeat after `period_px`, with noise.
cv::Mat stripes(int period_px) {
  cv::RNG random(6);
  cv::Mat photo(160, 160, CV_8UC3);
  for (int y = 0; y < photo.rows; ++y) {
    for (int x = 0; x < photo.cols; ++x)
      photo.at<cv::Vec3b>(y, x) =
          cv::Vec3b::all(std::uint8_t((y % period_px < period_px / 2 ? 200 : 40) + random.uniform(0, 20)));
  }
  return photo;
}

bool is_bright(const cv::Mat& picture, int y, int x) { return picture.at<cv::Vec3b>(y, x)[0] >= 120; }

TEST(ImageQuilting, ThePathTakesTheLeastSumOfErrors) {
  const cv::Mat errors = (cv::Mat_<float>(4, 4) << 1, 9, 9, 0,  //
                          9, 1, 9, 9,                           //
                          9, 9, 1, 9,                           //
                          9, 1, 9, 9);
  EXPECT_EQ(least_error_path(errors), (std::vector<int>{0, 1, 2, 1})) << "the 0 cannot be reached without a 9";
  EXPECT_EQ(least_error_path(cv::Mat_<float>(3, 1, 5.F)), (std::vector<int>{0, 0, 0}));
}

TEST(ImageQuilting, EachPixelIsOneOfThePhoto) {
  const cv::Mat photo = photo_of_places({120, 100});
  const cv::Mat quilt = quilted(photo, {251, 203}, {30, 1});
  ASSERT_EQ(quilt.size(), cv::Size(251, 203));
  quilt.forEach<cv::Vec3b>([&](const cv::Vec3b& pixel, const int* at) {
    ASSERT_LT(pixel[0], photo.cols);
    ASSERT_LT(pixel[1], photo.rows);
    ASSERT_EQ(pixel, photo.at<cv::Vec3b>(pixel[1], pixel[0])) << "at " << at[1] << ", " << at[0];
  });
}

TEST(ImageQuilting, TheMiddleOfABlockIsOnePieceOfThePhoto) {
  const int block_px = 30, overlap_px = 5, step_px = block_px - overlap_px;
  const cv::Mat quilt = quilted(photo_of_places({120, 100}), {230, 205}, {block_px, 1});
  for (int y = 0; y + block_px <= quilt.rows; y += step_px) {
    for (int x = 0; x + block_px <= quilt.cols; x += step_px) {
      const cv::Vec3b first = quilt.at<cv::Vec3b>(y + overlap_px, x + overlap_px);
      const cv::Vec3b last = quilt.at<cv::Vec3b>(y + step_px - 1, x + step_px - 1);
      ASSERT_EQ(last[0] - first[0], step_px - 1 - overlap_px) << x << ", " << y;
      ASSERT_EQ(last[1] - first[1], step_px - 1 - overlap_px) << x << ", " << y;
    }
  }
}

TEST(ImageQuilting, ACutDividesAnOverlapInTwoParts) {
  const int block_px = 30, overlap_px = 5, step_px = block_px - overlap_px;
  const cv::Mat quilt = quilted(photo_of_places({120, 100}), {355, 205}, {block_px, 1});
  const auto shift = [&](int y, int x) {
    const cv::Vec3b pixel = quilt.at<cv::Vec3b>(y, x);
    return cv::Point(pixel[0] - x, pixel[1] - y);
  };
  int cuts = 0;
  for (int left = step_px; left + block_px <= quilt.cols; left += step_px) {
    for (int y = 0; y < step_px; ++y) {
      int changes = 0;
      for (int x = left; x <= left + overlap_px; ++x) changes += shift(y, x) != shift(y, x - 1);
      const bool is_cut = shift(y, left - 1) != shift(y, left + overlap_px);
      ASSERT_EQ(changes, is_cut) << left << ", " << y;
      cuts += is_cut;
    }
  }
  EXPECT_GE(cuts, 2 * step_px) << "the photo is narrower than a third of the quilt";
}

TEST(ImageQuilting, StripesKeepTheirPeriod) {
  // An overlap of 10 px is wider than a stripe of 8 px, so that it shows where stripes end.
  const int period_px = 16;
  const cv::Mat quilt = quilted(stripes(period_px), {300, 300}, {60, 3});
  int wrong = 0;
  for (int y = 0; y < quilt.rows; ++y) {
    for (int x = 0; x < quilt.cols; ++x) {
      wrong += is_bright(quilt, y, x) != is_bright(quilt, y, 0);
      if (y >= period_px / 2) wrong += is_bright(quilt, y, x) == is_bright(quilt, y - period_px / 2, x);
    }
  }
  EXPECT_EQ(wrong, 0) << "pixels out of step, of " << quilt.total();
}

TEST(ImageQuilting, DependsOnTheSeedAlone) {
  const cv::Mat photo = photo_of_places({120, 100});
  const auto differing = [&](std::uint64_t a, std::uint64_t b) {
    cv::Mat difference;
    cv::absdiff(quilted(photo, {200, 200}, {24, a}), quilted(photo, {200, 200}, {24, b}), difference);
    return cv::countNonZero(difference.reshape(1));
  };
  EXPECT_EQ(differing(1, 1), 0);
  EXPECT_GT(differing(1, 2), 0);
}

TEST(ImageQuilting, PicturesMayBeSmallerThanABlock) {
  EXPECT_EQ(quilted(photo_of_places({60, 60}), {10, 50}, {40, 1}).size(), cv::Size(10, 50));
}

TEST(ImageQuilting, BlocksMustFit) {
  const cv::Mat photo = photo_of_places({60, 50});
  EXPECT_NO_THROW(quilted(photo, {100, 100}, {50, 1}));
  EXPECT_THROW(quilted(photo, {100, 100}, {51, 1}), std::invalid_argument);
  EXPECT_THROW(quilted(photo, {100, 100}, {kLeastBlock_px - 1, 1}), std::invalid_argument);
  EXPECT_THROW(quilted(cv::Mat(60, 60, CV_8U), {100, 100}, {20, 1}), std::invalid_argument);
}

}  // namespace test_image_quilting
}  // namespace tessera::bench
