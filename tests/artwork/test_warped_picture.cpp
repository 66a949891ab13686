// Deformed pictures, against a scan of all triangles for each pixel.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "artwork/warping/warped_picture.h"

namespace tessera {
namespace test_warped_picture {

cv::Mat noise(cv::Size size, bool opaque) {
  cv::Mat bgra(size, CV_8UC4);
  cv::RNG random(2016);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int alpha = opaque ? 255 : random.uniform(0, 256);
      auto& pixel = bgra.at<cv::Vec4b>(y, x);
      for (int c = 0; c < 3; ++c) pixel[c] = std::uint8_t(random.uniform(0, alpha + 1));
      pixel[3] = std::uint8_t(alpha);
    }
  }
  return bgra;
}

Warp still_warp(cv::Size covered, float step, bool falling) {
  const int columns = int(std::ceil(float(covered.width) / step)) + 1;
  const int rows = int(std::ceil(float(covered.height) / step)) + 1;
  return {.origin = {0, 0},
          .step = step,
          .displacement = {columns, rows},
          .active = {columns - 1, rows - 1, 1},
          .falling = falling};
}

Warp smooth_warp(cv::Size covered, bool falling) {
  Warp warp = still_warp(covered, 6.25f, falling);
  for (int j = 0; j < warp.displacement.height(); ++j) {
    for (int i = 0; i < warp.displacement.width(); ++i) {
      warp.displacement(i, j) = {7.3f + 2.5f * std::sin(0.7f * float(j)), 6.1f + 2 * std::cos(0.9f * float(i + j))};
    }
  }
  return warp;
}

bool equal(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

/// Three nodes of a cell, which form a triangle.
using Corners = std::array<std::array<int, 2>, 3>;

std::array<Corners, 2> triangles_of_cell(int i, int j, bool falling) {
  if (falling) return {{{{{i, j}, {i + 1, j}, {i + 1, j + 1}}}, {{{i, j}, {i + 1, j + 1}, {i, j + 1}}}}};
  return {{{{{i, j}, {i + 1, j}, {i, j + 1}}}, {{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}}}};
}

/// The place in the source of a point p of the result, by this triangle; nullopt if p lies outside.
std::optional<cv::Point2d> source_in(const Corners& corners, const Warp& warp, cv::Point2d p) {
  std::array<cv::Point2d, 3> from, to;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 node = warp.node(corners[k][0], corners[k][1]), moved = warp.warped_node(corners[k][0], corners[k][1]);
    from[k] = {node.x, node.y};
    to[k] = {moved.x, moved.y};
  }
  const double area = (to[1] - to[0]).cross(to[2] - to[0]);
  cv::Point2d source(0, 0);
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = (to[(k + 1) % 3] - p).cross(to[(k + 2) % 3] - p) / area;
    if (weight < 0) return std::nullopt;
    source += from[k] * weight;
  }
  return source;
}

std::optional<cv::Point2d> source_of(const Warp& warp, cv::Point2d p) {
  for (int j = 0; j < warp.active.height(); ++j) {
    for (int i = 0; i < warp.active.width(); ++i) {
      if (!warp.active(i, j)) continue;
      for (const Corners& corners : triangles_of_cell(i, j, warp.falling)) {
        if (const auto source = source_in(corners, warp, p)) return source;
      }
    }
  }
  return std::nullopt;
}

cv::Vec4d bilinear(const cv::Mat& bgra, cv::Point2d p) {
  const int x = int(std::floor(p.x - 0.5)), y = int(std::floor(p.y - 0.5));
  const double s = p.x - 0.5 - x, t = p.y - 0.5 - y;
  cv::Vec4d sum(0, 0, 0, 0);
  for (int k = 0; k < 4; ++k) {
    const int i = x + k % 2, j = y + k / 2;
    if (i < 0 || j < 0 || i >= bgra.cols || j >= bgra.rows) continue;
    const cv::Vec4b pixel = bgra.at<cv::Vec4b>(j, i);
    sum += cv::Vec4d(pixel[0], pixel[1], pixel[2], pixel[3]) * ((k % 2 ? s : 1 - s) * (k / 2 ? t : 1 - t));
  }
  return sum;
}

TEST(WarpedPicture, WithoutDisplacementIsThePictureBitForBit) {
  const cv::Mat picture = noise({101, 67}, false);
  for (const bool falling : {true, false}) {
    for (const float step : {3.f, 7.7f, 200.f}) {
      EXPECT_TRUE(equal(warped_picture(picture, still_warp(picture.size(), step, falling), picture.size()), picture));
    }
  }
}

TEST(WarpedPicture, MovesByWholePixelsIntoALargerOne) {
  const cv::Mat picture = noise({40, 30}, false);
  Warp warp = still_warp(picture.size(), 5.5f, true);
  for (Vec2& d : warp.displacement.data()) d = {12, 7};
  cv::Mat expected(60, 80, CV_8UC4, cv::Scalar::all(0));
  picture.copyTo(expected(cv::Rect(12, 7, 40, 30)));
  EXPECT_TRUE(equal(warped_picture(picture, warp, expected.size()), expected));
}

TEST(WarpedPicture, IsWhatAScanOfAllTrianglesSays) {
  cv::Mat picture = noise({70, 55}, false);
  cv::GaussianBlur(picture, picture, {5, 5}, 1.5);
  for (const bool falling : {true, false}) {
    Warp warp = smooth_warp(picture.size(), falling);
    warp.active(2, 3) = 0;
    const cv::Mat result = warped_picture(picture, warp, {90, 75});
    int on_edges = 0;
    for (int y = 0; y < result.rows; ++y) {
      for (int x = 0; x < result.cols; ++x) {
        const auto source = source_of(warp, {x + 0.5, y + 0.5});
        const cv::Vec4d expected = source ? bilinear(picture, *source) : cv::Vec4d();
        const cv::Vec4b pixel = result.at<cv::Vec4b>(y, x);
        double worst = 0;
        for (int c = 0; c < 4; ++c) worst = std::max(worst, std::abs(pixel[c] - expected[c]));
        if (worst > 1.5) ++on_edges;
      }
    }
    EXPECT_LE(on_edges, 2) << "centres that lie within the tolerance of the outer edge";
  }
}

TEST(WarpedPicture, HasNoSeams) {
  const cv::Mat picture(80, 100, CV_8UC4, cv::Scalar(10, 20, 30, 255));
  for (const bool falling : {true, false}) {
    for (const float stretch : {0.7f, 1.f, 1.6f}) {
      Warp warp = smooth_warp(picture.size(), falling);
      for (int j = 0; j < warp.displacement.height(); ++j) {
        for (int i = 0; i < warp.displacement.width(); ++i) {
          Vec2& d = warp.displacement(i, j);
          d = d + warp.node(i, j) * (stretch - 1);
        }
      }
      const cv::Mat result = warped_picture(picture, warp, {200, 160});
      for (int y = 0; y < result.rows; ++y) {
        for (int x = 0; x < result.cols; ++x) {
          const auto source = source_of(warp, {x + 0.5, y + 0.5});
          const bool is_deep = source && source->x > 1 && source->y > 1 && source->x < 99 && source->y < 79;
          if (!is_deep) continue;
          ASSERT_EQ(result.at<cv::Vec4b>(y, x), cv::Vec4b(10, 20, 30, 255)) << x << ", " << y;
        }
      }
    }
  }
}

TEST(WarpedPicture, ShowsNothingOfCellsThatAreNotActive) {
  const cv::Mat picture(40, 40, CV_8UC4, cv::Scalar::all(255));
  Warp warp = still_warp(picture.size(), 10, true);
  warp.active(1, 1) = 0;
  cv::Mat expected = picture.clone();
  expected(cv::Rect(10, 10, 10, 10)) = cv::Scalar::all(0);
  EXPECT_TRUE(equal(warped_picture(picture, warp, picture.size()), expected));
}

TEST(WarpedPicture, LiesOnAPageThatIsDeformed) {
  const cv::Mat picture = noise({20, 10}, true);
  Warp warp = still_warp({100, 100}, 9, true);  // on a page on which a pixel is 4 units large, upside down
  const cv::Matx23d source_from_page(-0.25, 0, 22, 0, -0.25, 15);
  for (Vec2& d : warp.displacement.data()) d = {-8, -20};
  const cv::Mat result = warped_picture(picture, source_from_page, warp, {80, 40});
  cv::Mat turned, expected;
  cv::flip(picture, turned, -1);
  cv::resize(turned, expected, {80, 40}, 0, 0, cv::INTER_LINEAR);
  const cv::Rect inner(2, 2, 76, 36);  // without pixels that mix with the area beyond the edge
  EXPECT_LE(cv::norm(result(inner), expected(inner), cv::NORM_INF), 1);
}

/// Folds, huge displacements and grids elsewhere: the function still returns a picture.
TEST(WarpedPicture, OutlastsAbsurdWarps) {
  const cv::Mat picture = noise({30, 30}, true);
  const float endless = std::numeric_limits<float>::infinity();
  for (const float far : {1e9f, -1e9f, 1e30f, endless, std::nanf("")}) {
    Warp warp = still_warp(picture.size(), 5, true);
    warp.displacement(2, 2) = {far, 3};
    EXPECT_EQ(warped_picture(picture, warp, {30, 30}).size(), cv::Size(30, 30));
    warp.origin = {far, far};
    EXPECT_EQ(warped_picture(picture, warp, {30, 30}).size(), cv::Size(30, 30));
  }
}

}  // namespace test_warped_picture
}  // namespace tessera
