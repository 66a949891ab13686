// Separate elements on a plain ground are found at any size, and other grounds are distinguished from it.
#include "products/elements/plain_ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include <opencv2/imgproc.hpp>
#include <vector>

#include "drawn_elements.h"
#include "products/elements/touching_elements.h"

namespace tessera {
namespace test_plain_ground {

constexpr int kWidth_px = 600, kHeight_px = 400;

/// A mask of pieces with large tabs: the truth, as CV_8U.
cv::Mat pieces_mask() {
  cv::Mat mask = cv::Mat::zeros(kHeight_px, kWidth_px, CV_8U);
  for (const cv::Point at : {cv::Point(100, 100), cv::Point(300, 120), cv::Point(490, 270), cv::Point(150, 290)}) {
    cv::rectangle(mask, {at.x - 40, at.y - 40}, {at.x + 40, at.y + 40}, 255, cv::FILLED);
    cv::circle(mask, {at.x + 48, at.y + 3}, 14, 255, cv::FILLED);
    cv::circle(mask, {at.x - 2, at.y + 33}, 13, 0, cv::FILLED);
    cv::rectangle(mask, {at.x - 8, at.y + 30}, {at.x + 4, at.y + 41}, 0, cv::FILLED);
  }
  return mask;
}

/// A photo of the mask's pieces in many colours, on a ground lit from one side, with soft shadows, blur and noise.
cv::Mat photo_of(const cv::Mat& mask, const cv::Scalar& ground_bgr, double noise, bool has_shadow = true) {
  cv::Mat photo(mask.size(), CV_32FC3);
  cv::Mat shadow;
  mask.convertTo(shadow, CV_32F, has_shadow ? 0.2 / 255 : 0);
  const cv::Matx23f shift(1, 0, 9, 0, 1, 10);
  cv::warpAffine(shadow, shadow, shift, shadow.size());
  cv::GaussianBlur(shadow, shadow, {}, 3);
  cv::RNG random(7);
  cv::Vec3f colour;
  for (int c = 0; c < 3; ++c) colour[c] = float(ground_bgr[c]);
  for (int y = 0; y < photo.rows; ++y) {
    for (int x = 0; x < photo.cols; ++x) {
      const float light = (0.85F + 0.15F * float(x) / float(photo.cols)) * (1 - shadow.at<float>(y, x));
      const float wave = float(std::sin(x * 0.05) + std::cos(y * 0.07));
      const cv::Vec3f piece(60 + 30 * wave, 90 - 20 * wave, 200 + 25 * wave);
      photo.at<cv::Vec3f>(y, x) = mask.at<std::uint8_t>(y, x) ? piece : colour * light;
    }
  }
  cv::GaussianBlur(photo, photo, {}, 0.8);
  cv::Mat grain(photo.size(), CV_32FC3);
  random.fill(grain, cv::RNG::NORMAL, 0, noise);
  photo += grain;
  photo.convertTo(photo, CV_8UC3);
  return photo;
}

/// Expects all pieces, each as a region whose boundary is within about 1 px of the truth.
void expect_found(const cv::Mat& photo, const cv::Mat& truth) {
  const std::optional<cv::Mat> labels = elements_on_plain_ground(photo);
  ASSERT_TRUE(labels);
  EXPECT_EQ(region_boxes(*labels).size(), 5U) << "four pieces";
  cv::Mat outer, inner;
  cv::dilate(truth, outer, round_window(5));
  cv::erode(truth, inner, round_window(5));
  const cv::Mat found = *labels > 0;
  EXPECT_EQ(cv::countNonZero(found & ~outer), 0) << "ground, or a shadow, counts as piece";
  EXPECT_EQ(cv::countNonZero(inner & ~found), 0) << "something of a piece is missing";
  EXPECT_NEAR(cv::countNonZero(found), cv::countNonZero(truth), 0.02 * cv::countNonZero(truth));
}

TEST(PlainGround, PiecesOnWhiteBlackGreyAndGreen) {
  const cv::Mat truth = pieces_mask();
  for (const cv::Scalar& ground :
       {cv::Scalar(250, 250, 250), cv::Scalar(12, 12, 12), cv::Scalar(140, 140, 140), cv::Scalar(70, 150, 60)}) {
    SCOPED_TRACE(ground[0]);
    expect_found(photo_of(truth, ground, 4), truth);
  }
}

TEST(PlainGround, PiecesOfTwoSizesAndThoseThatTheEdgeCuts) {
  cv::Mat truth = pieces_mask();
  cv::circle(truth, {420, 60}, 11, 255, cv::FILLED);
  cv::circle(truth, {300, 399}, 40, 255, cv::FILLED);
  const std::optional<cv::Mat> labels = elements_on_plain_ground(photo_of(truth, {250, 250, 250}, 2));
  ASSERT_TRUE(labels);
  EXPECT_EQ(region_boxes(*labels).size(), 7U);
}

/// Grey pieces on white could be taken for shadows of the ground, but nothing in the photo is darker.
TEST(PlainGround, GreyPiecesAreNoShadows) {
  const cv::Mat truth = pieces_mask();
  cv::Mat photo(truth.size(), CV_8UC3, cv::Scalar(245, 245, 245));
  photo.setTo(cv::Scalar(190, 190, 190), truth);
  expect_found(photo, truth);
}

TEST(PlainGround, OtherPhotosHaveNone) {
  const test::ElementPhoto cobbles = test::photographed(test::cobbles(), {110, 120, 130}, {45, 50, 55});
  const test::ElementPhoto bricks = test::photographed(test::bricks(), {60, 80, 150}, {170, 175, 180});
  EXPECT_FALSE(elements_on_plain_ground(cobbles.bgr)) << "stones all over the edge";
  EXPECT_FALSE(elements_on_plain_ground(bricks.bgr));
  EXPECT_FALSE(elements_on_plain_ground(photo_of(cv::Mat::zeros(300, 300, CV_8U), {90, 90, 90}, 3, false)))
      << "nothing but ground";
  EXPECT_FALSE(elements_on_plain_ground(photo_of(pieces_mask(), {120, 120, 120}, 60))) << "a rough ground";
  cv::Mat two_grounds = photo_of(pieces_mask(), {200, 200, 200}, 2);
  two_grounds.colRange(kWidth_px * 6 / 10, kWidth_px).setTo(cv::Scalar(60, 90, 60));
  EXPECT_FALSE(elements_on_plain_ground(two_grounds)) << "two fifths of the edge show another ground";
  EXPECT_FALSE(elements_on_plain_ground(cv::Mat(4, 4, CV_8UC3, cv::Scalar(9, 9, 9))));
  EXPECT_FALSE(elements_on_plain_ground(cv::Mat()));
}

LabelRuns runs_of(const cv::Mat& mask) {
  cv::Mat labels;
  cv::connectedComponents(mask, labels, 4);
  return LabelRuns(labels);
}

int touching(const cv::Mat& mask) {
  int count = 0;
  for (const bool touches : touching_regions(runs_of(mask))) count += touches;
  return count;
}

TEST(TouchingElements, CoinsThatTouchAreSeveralAndPiecesWithTabsAreNot) {
  cv::Mat coins = cv::Mat::zeros(200, 400, CV_8U);
  cv::circle(coins, {80, 100}, 40, 255, cv::FILLED);
  EXPECT_EQ(touching(coins), 0);
  cv::circle(coins, {157, 100}, 40, 255, cv::FILLED);
  cv::circle(coins, {320, 100}, 30, 255, cv::FILLED);
  EXPECT_EQ(touching(coins), 1);
  EXPECT_EQ(touching(pieces_mask()), 0);
}

TEST(TouchingElements, TheSearchTakesThemApartAndLeavesTheOthers) {
  cv::Mat coins = cv::Mat::zeros(200, 400, CV_8U), searched = cv::Mat::zeros(200, 400, CV_32S);
  cv::circle(coins, {80, 100}, 40, 255, cv::FILLED);
  cv::circle(coins, {157, 100}, 40, 255, cv::FILLED);
  cv::circle(coins, {320, 100}, 30, 255, cv::FILLED);
  cv::circle(searched, {80, 100}, 36, 1, cv::FILLED);
  cv::circle(searched, {157, 100}, 36, 2, cv::FILLED);
  cv::rectangle(searched, {310, 90}, {330, 110}, 3, cv::FILLED);
  cv::rectangle(searched, {10, 10}, {30, 30}, 4, cv::FILLED);
  const LabelRuns apart = runs_of(coins);
  const LabelRuns all = with_touching_apart(apart, touching_regions(apart), LabelRuns(searched));
  ASSERT_EQ(all.regions().size(), 4U) << "two coins of the search, and one as it is";
  EXPECT_EQ(all.regions()[1].box, cv::Rect(44, 64, 73, 73));
  EXPECT_EQ(all.regions()[3].box, cv::Rect(290, 70, 61, 61));
  const LabelRuns none =
      with_touching_apart(apart, touching_regions(apart), LabelRuns(cv::Mat::zeros(200, 400, CV_32S)));
  EXPECT_EQ(none.regions().size(), 3U) << "what the search does not find stays";
}

}  // namespace test_plain_ground
}  // namespace tessera
