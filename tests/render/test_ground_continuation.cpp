// Ground is continued into small gaps by its own grains.
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <set>

#include "render/ground_continuation.h"

namespace tessera {
namespace test_ground_continuation {

constexpr int kGroundWidth_px = 9;

/// Ground of random greys from 80 to 120 in the first columns of a canvas; the rest shows nothing.
cv::Mat canvas() {
  cv::Mat pixels = cv::Mat::zeros(60, 90, CV_8UC4);
  cv::RNG random(3);
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < kGroundWidth_px; ++x) {
      const int grey = random.uniform(80, 120);
      pixels.at<cv::Vec4b>(y, x) = cv::Vec4b::all(std::uint8_t(grey));
      pixels.at<cv::Vec4b>(y, x)[3] = 255;
    }
  }
  return pixels;
}

cv::Mat continued(const cv::Mat& shown, const cv::Rect& window) {
  cv::Mat pixels = shown(window).clone();
  continue_ground(cv::Mat::zeros(pixels.size(), CV_8U), pixels);
  return pixels;
}

TEST(GroundContinuation, HasTheGroundsGrainsAndNoStreaks) {
  const cv::Mat shown = canvas(), pixels = continued(shown, {{}, shown.size()});
  for (int y = 4; y < pixels.rows - 4; ++y) {
    std::set<int> greys;
    for (int x = kGroundWidth_px; x < kGroundWidth_px + 12; ++x) {
      const cv::Vec4b& pixel = pixels.at<cv::Vec4b>(y, x);
      ASSERT_EQ(pixel[3], 255);
      ASSERT_GE(pixel[0], 80);
      ASSERT_LE(pixel[0], 120);
      greys.insert(pixel[0]);
    }
    EXPECT_GE(greys.size(), 5U);  // a row of streaks would have one
    EXPECT_EQ(pixels.at<cv::Vec4b>(y, kGroundWidth_px + 12)[3], 0);
  }
}

TEST(GroundContinuation, LeavesWhatIsShown) {
  const cv::Mat shown = canvas(), pixels = continued(shown, {{}, shown.size()});
  const cv::Rect ground(0, 0, kGroundWidth_px, shown.rows);
  EXPECT_EQ(cv::norm(shown(ground), pixels(ground), cv::NORM_INF), 0);
}

TEST(GroundContinuation, TakesNothingFromPieces) {
  cv::Mat pixels = canvas();
  cv::Mat is_piece = cv::Mat::zeros(pixels.size(), CV_8U);
  is_piece.colRange(4, kGroundWidth_px) = 255;
  pixels.colRange(4, kGroundWidth_px) = cv::Scalar(0, 0, 250, 255);
  continue_ground(is_piece, pixels);
  EXPECT_LT(pixels.at<cv::Vec4b>(30, kGroundWidth_px + 4)[2], 130);
}

TEST(GroundContinuation, IsTheSameInEachWindow) {
  const cv::Mat shown = canvas(), whole = continued(shown, {{}, shown.size()});
  const cv::Rect window(0, 0, 60, 60 - 7), inner(0, 0, 60, window.height - kContinuation_px);
  EXPECT_EQ(cv::norm(whole(inner), continued(shown, window)(inner), cv::NORM_INF), 0);
  const cv::Rect below(0, 11, 60, 49);
  const cv::Rect both(0, 11 + kContinuation_px, 60, 49 - kContinuation_px);
  EXPECT_EQ(cv::norm(whole(both), continued(shown, below)(both - below.tl()), cv::NORM_INF), 0);
}

TEST(GroundContinuation, OfNothingIsNothing) {
  cv::Mat pixels = cv::Mat::zeros(20, 20, CV_8UC4);
  continue_ground(cv::Mat::zeros(pixels.size(), CV_8U), pixels);
  EXPECT_EQ(cv::norm(pixels, cv::NORM_INF), 0);
}

}  // namespace test_ground_continuation
}  // namespace tessera
