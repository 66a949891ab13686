#include "copied_part.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace tessera::bench {
namespace {

constexpr double kEqual = 0.9;
/// Squares are compared in this size, so that shifts by a part of a pixel do not count.
constexpr double kCompared_px = 32;

bool comes_again(const cv::Mat& grey, const cv::Rect& square) {
  cv::Mat alike;
  cv::matchTemplate(grey, grey(square), alike, cv::TM_CCOEFF_NORMED);
  const int reach = square.width - 1;  // squares are nearer than a side
  const cv::Rect near(square.x - reach, square.y - reach, 2 * reach + 1, 2 * reach + 1);
  alike(near & cv::Rect({}, alike.size())) = 0;
  double highest = 0;
  cv::minMaxLoc(alike, nullptr, &highest);
  return highest >= kEqual;
}

}  // namespace

double copied_part(const cv::Mat& bgr, int square_px) {
  const double scale = std::min(1., kCompared_px / square_px);
  cv::Mat small, grey;
  cv::resize(bgr, small, {}, scale, scale, cv::INTER_AREA);
  cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
  const int side = std::max(1, int(std::lround(square_px * scale))), step = std::max(1, side / 2);
  if (std::max(grey.cols, grey.rows) < 2 * side || std::min(grey.cols, grey.rows) < side) return 0;
  int all = 0, again = 0;
  for (int y = 0; y + side <= grey.rows; y += step) {
    for (int x = 0; x + side <= grey.cols; x += step) {
      ++all;
      again += comes_again(grey, {x, y, side, side});
    }
  }
  return double(again) / all;
}

}  // namespace tessera::bench
