// The pitch of rows and columns of elements.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <opencv2/imgproc.hpp>

#include "products/drawn_elements.h"
#include "products/random_labels.h"
#include "products/texture/element_pitch.h"

namespace tessera {
namespace test_element_pitch {

/// Rectangles in a grid with that pitch; every second row is moved by a part of it.
cv::Mat grid(double pitch_x, double pitch_y, double moved) {
  cv::Mat labels = cv::Mat::zeros(400, 600, CV_32S);
  int count = 0;
  for (int row = 0; row * pitch_y < labels.rows; ++row) {
    for (double x = row % 2 * moved * pitch_x; x < labels.cols; x += pitch_x) {
      const cv::Rect box(int(x), int(row * pitch_y), int(pitch_x * 0.85), int(pitch_y * 0.85));
      labels(box & cv::Rect({}, labels.size())) = ++count;
    }
  }
  return labels;
}

TEST(ElementPitch, OfTilesIsFoundBothWays) {
  const cv::Size2d pitch = element_pitch_px(LabelRuns(grid(47.5, 38, 0)), 38);
  EXPECT_NEAR(pitch.width, 47.5, 0.3);
  EXPECT_NEAR(pitch.height, 38, 0.3);
}

TEST(ElementPitch, OfBricksIsFoundFromRowToRow) {
  EXPECT_NEAR(element_pitch_px(LabelRuns(test::bricks()), 66).height, 52, 0.3);
}

TEST(ElementPitch, IsNoneWhereElementsLieInNoLines) {
  cv::RNG random(7);
  cv::Mat labels = cv::Mat::zeros(400, 600, CV_32S);
  for (int i = 1; i <= 60; ++i)
    cv::circle(labels, {random.uniform(0, 600), random.uniform(0, 400)}, random.uniform(10, 30), i, cv::FILLED);
  EXPECT_EQ(element_pitch_px(LabelRuns(labels), 35), cv::Size2d(0, 0));
  const cv::Size2d of_nothing = element_pitch_px(LabelRuns(cv::Mat::zeros(30, 40, CV_32S)), 10);
  EXPECT_EQ(of_nothing, cv::Size2d(0, 0));
}

RC_GTEST_PROP(ElementPitch, IsNoneOrAboutAsLongAsAnElement, ()) {
  const double element_px = *rc::gen::inRange(2, 20);
  const cv::Size2d pitch = element_pitch_px(LabelRuns(test::random_labels({70, 60})), element_px);
  for (const double side : {pitch.width, pitch.height})
    RC_ASSERT(side == 0 || (side > 0.3 * element_px - 1 && side < 3.2 * element_px + 1));
}

}  // namespace test_element_pitch
}  // namespace tessera
