// The size of elements, found in photos where it is known.
#include "products/elements/element_size.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "drawn_elements.h"

namespace tessera {
namespace test_element_size {

using test::photographed;

const cv::Scalar kStone(110, 120, 130), kDarkJoint(45, 50, 55), kBrick(60, 80, 150), kMortar(170, 175, 180);

/// A size that is wrong by 1.4 costs little.
void expect_about(double found_px, double px) {
  EXPECT_GT(found_px, px / 1.4);
  EXPECT_LT(found_px, px * 1.4);
}

TEST(ElementSize, IsThatOfMostElements) {
  expect_about(found_element_px(photographed(test::discs(), kStone, kDarkJoint).bgr), 48);
  expect_about(found_element_px(photographed(test::bricks(), kBrick, kMortar).bgr), 44);
  expect_about(found_element_px(photographed(test::cobbles(), kStone, kDarkJoint).bgr), 50);
}

TEST(ElementSize, ShrinksWithThePhoto) {
  cv::Mat half;
  cv::resize(photographed(test::cobbles(), kStone, kDarkJoint).bgr, half, {}, 0.5, 0.5, cv::INTER_AREA);
  expect_about(found_element_px(half), 25);
}

TEST(ElementSize, IsThatOfTheMiddleOfALargePhoto) {
  cv::Mat wall;
  cv::repeat(photographed(test::cobbles(), kStone, kDarkJoint).bgr, 3, 3, wall);
  expect_about(found_element_px(wall), 50);
}

TEST(ElementSize, IsNoneWithoutElements) {
  cv::Mat noise(90, 120, CV_8UC3);
  cv::RNG random(3);
  random.fill(noise, cv::RNG::NORMAL, 128, 20);
  EXPECT_EQ(found_element_px(noise), 0);
  for (const cv::Size size : {cv::Size(120, 90), cv::Size(1, 1), cv::Size(1, 400), cv::Size(30, 30)}) {
    EXPECT_EQ(found_element_px(cv::Mat(size, CV_8UC3, cv::Scalar(90, 100, 110))), 0);
    EXPECT_EQ(found_element_px(cv::Mat(size, CV_8UC4, cv::Scalar(90, 100, 110, 255))), 0);
  }
}

TEST(ElementSize, DependsOnNothingButThePhoto) {
  const cv::Mat photo = photographed(test::discs(), kStone, kDarkJoint).bgr(cv::Rect(0, 0, 150, 120)).clone();
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const double on_one = found_element_px(photo);
  cv::setNumThreads(3);
  cv::theRNG().state = 12345;
  const double on_three = found_element_px(photo);
  cv::setNumThreads(threads);
  EXPECT_EQ(on_one, on_three);
}

}  // namespace test_element_size
}  // namespace tessera
