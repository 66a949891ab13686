// Thick lines become lines one pixel wide, and these become curves: their number, lengths and ends.
#include "recognition/line_trace.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/geometry/polygon.h"
#include "recognition/thinning.h"

namespace tessera {
namespace test_line_trace {

Grid<std::uint8_t> filled(const cv::Mat& image) {
  Grid<std::uint8_t> grid(image.cols, image.rows);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) grid(x, y) = image.at<std::uint8_t>(y, x) ? 1 : 0;
  }
  return grid;
}

std::vector<Curve> lines_of(const cv::Mat& image, float width) {
  return traced_lines(thinned(filled(image)), Grid<float>(image.cols, image.rows, width / 2));
}

cv::Mat blank() { return cv::Mat::zeros(200, 200, CV_8U); }

int parts_of(const Grid<std::uint8_t>& grid) {
  cv::Mat image(grid.height(), grid.width(), CV_8U, const_cast<std::uint8_t*>(grid.row(0)));
  cv::Mat labels;
  return cv::connectedComponents(image, labels, 8) - 1;
}

TEST(Thinning, ABarBecomesItsMiddleLine) {
  cv::Mat image = blank();
  cv::rectangle(image, {20, 50}, {180, 58}, 255, cv::FILLED);
  const Grid<std::uint8_t> thin = thinned(filled(image));
  for (int x = 30; x < 170; ++x) {
    int count = 0;
    for (int y = 0; y < 200; ++y) count += thin(x, y);
    EXPECT_EQ(count, 1) << x;
    EXPECT_EQ(thin(x, 54), 1) << x;
  }
}

TEST(Thinning, NothingStaysNothingAndAPixelStaysOne) {
  EXPECT_EQ(thinned(Grid<std::uint8_t>(3, 3)).data(), Grid<std::uint8_t>(3, 3).data());
  Grid<std::uint8_t> pixel(3, 3);
  pixel(1, 1) = 1;
  EXPECT_EQ(thinned(pixel).data(), pixel.data());
}

RC_GTEST_PROP(Thinning, lines_stay_connected, ()) {
  cv::Mat image = blank();
  const int width = *rc::gen::inRange(1, 12);
  const auto any = [] { return cv::Point(*rc::gen::inRange(10, 190), *rc::gen::inRange(10, 190)); };
  for (int k = 0; k < 4; ++k) cv::line(image, any(), any(), 255, width);
  const Grid<std::uint8_t> all = filled(image);
  const Grid<std::uint8_t> thin = thinned(all);
  RC_ASSERT(parts_of(thin) == parts_of(all));
  for (std::size_t k = 0; k < thin.data().size(); ++k) RC_ASSERT(thin.data()[k] <= all.data()[k]);
}

TEST(LineTrace, ALineIsOneOpenCurve) {
  cv::Mat image = blank();
  cv::line(image, {20, 30}, {170, 120}, 255, 5);
  const std::vector<Curve> lines = lines_of(image, 5);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].closed);
  EXPECT_NEAR(length_of(lines[0]), std::hypot(150, 90), 6);
}

TEST(LineTrace, ARingIsOneClosedCurveWithItsInteriorOnTheLeft) {
  cv::Mat image = blank();
  cv::circle(image, {100, 100}, 60, 255, 7);
  const std::vector<Curve> lines = lines_of(image, 7);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_NEAR(signed_area(lines[0].points), 3.1416 * 60 * 60, 500);
  for (const Vec2 p : lines[0].points) EXPECT_NEAR(norm(p - Vec2{100.5f, 100.5f}), 60, 2);
}

TEST(LineTrace, ACrossIsFourArmsAndACornerIsOneLine) {
  cv::Mat cross = blank();
  cv::line(cross, {20, 100}, {180, 100}, 255, 5);
  cv::line(cross, {100, 20}, {100, 180}, 255, 5);
  const std::vector<Curve> arms = lines_of(cross, 5);
  ASSERT_EQ(arms.size(), 4u);
  for (const Curve& arm : arms) EXPECT_NEAR(length_of(arm), 80, 6);
  cv::Mat corner = blank();
  cv::line(corner, {20, 20}, {20, 180}, 255, 9);
  cv::line(corner, {20, 180}, {180, 180}, 255, 9);
  EXPECT_EQ(lines_of(corner, 9).size(), 1u) << "the spur at the corner is dropped";
}

TEST(LineTrace, ALollipopIsARingAndAStick) {
  cv::Mat image = blank();
  cv::circle(image, {100, 60}, 40, 255, 5);
  cv::line(image, {100, 100}, {100, 190}, 255, 5);
  const std::vector<Curve> lines = lines_of(image, 5);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NEAR(length_of(lines[0]) + length_of(lines[1]), 2 * 3.1416 * 40 + 90, 15);
}

TEST(LineTrace, SpecksAreNoLines) {
  cv::Mat image = blank();
  image.at<std::uint8_t>(50, 50) = 255;
  cv::rectangle(image, {100, 100}, {102, 102}, 255, cv::FILLED);
  EXPECT_TRUE(lines_of(image, 3).empty());
}

}  // namespace test_line_trace
}  // namespace tessera
