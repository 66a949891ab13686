#include "products/elements/segmentation/region_labels.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "products/elements/segmentation/mask_parts.h"

namespace tessera {
namespace {

/// One side of the convex hull of points that come from top to bottom: its points farthest to the right. With
/// cv::convexHull(), which sorts the points first, solidity_of() takes more than twice the time.
class HullSide {
 public:
  void add(cv::Point p) {
    while (points_.size() > 1 && !bulges(points_[points_.size() - 2], points_.back(), p)) points_.pop_back();
    if (!points_.empty() && points_.back().y == p.y) {
      if (points_.back().x >= p.x) return;
      points_.pop_back();
      return add(p);
    }
    points_.push_back(p);
  }

  /// Twice the area between the side and x = 0.
  long long doubled_area_px2() const {
    long long sum = 0;
    for (std::size_t i = 1; i < points_.size(); ++i)
      sum += (long long)(points_[i].x + points_[i - 1].x) * (points_[i].y - points_[i - 1].y);
    return sum;
  }

 private:
  /// Whether b lies on the right of the way down from a to c.
  static bool bulges(cv::Point a, cv::Point b, cv::Point c) {
    return (long long)(b.x - a.x) * (c.y - a.y) > (long long)(c.x - a.x) * (b.y - a.y);
  }

  std::vector<cv::Point> points_;
};

/// Whether the mask is one part without holes. Its pixels, less their common sides, plus the corners that four share, are
/// the parts less the holes (Euler's number).
bool is_solid(const cv::Mat& mask) {
  int parts_less_holes = 0;
  for (int y = 0; y < mask.rows; ++y) {
    const std::uint8_t *row = mask.ptr<std::uint8_t>(y),
                       *below = y + 1 < mask.rows ? mask.ptr<std::uint8_t>(y + 1) : row;
    const bool has_below = below != row;
    for (int x = 0; x < mask.cols; ++x) {
      const bool here = row[x], right = here && x + 1 < mask.cols && row[x + 1];
      const bool under = here && has_below && below[x];
      parts_less_holes += int(here) - int(right) - int(under) + int(right && under && below[x + 1]);
    }
  }
  return parts_less_holes == 1 && mask_parts(mask).size() == 1;
}

}  // namespace

std::vector<RegionBox> region_boxes(const cv::Mat& labels) {
  double greatest = 0;
  if (!labels.empty()) cv::minMaxLoc(labels, nullptr, &greatest);
  struct Extent {
    int x0 = INT_MAX, y0 = INT_MAX, x1 = -1, y1 = -1;
  };
  std::vector<Extent> extents(std::size_t(greatest) + 1);
  std::vector<RegionBox> regions(extents.size());
  for (int y = 0; y < labels.rows; ++y) {
    const int* row = labels.ptr<int>(y);
    for (int x = 0; x < labels.cols;) {
      int end = x + 1;
      while (end < labels.cols && row[end] == row[x]) ++end;
      Extent& e = extents[std::size_t(row[x])];
      e = {std::min(e.x0, x), std::min(e.y0, y), std::max(e.x1, end - 1), std::max(e.y1, y)};
      regions[std::size_t(row[x])].area_px2 += end - x;
      x = end;
    }
  }
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const Extent& e = extents[i];
    if (e.x1 >= 0) regions[i].box = {e.x0, e.y0, e.x1 - e.x0 + 1, e.y1 - e.y0 + 1};
  }
  return regions;
}

bool reaches_edge(const cv::Rect& box, const cv::Size& picture) {
  return box.x <= 0 || box.y <= 0 || box.br().x >= picture.width || box.br().y >= picture.height;
}

cv::Rect grown_within(const cv::Rect& box, int margin_px, const cv::Size& picture) {
  const cv::Point margin(margin_px, margin_px);
  return cv::Rect(box.tl() - margin, box.br() + margin) & cv::Rect({}, picture);
}

double size_preference(double relative_area, double larger, double smaller) {
  const double size = std::log(relative_area);
  const double too_large = std::max(0., size - larger) / 0.7;
  const double too_small = std::max(0., -size - smaller) / 0.6;
  return std::exp(-0.5 * (too_large * too_large + too_small * too_small));
}

cv::Mat bgr_of(const cv::Mat& picture) {
  if (picture.channels() == 3) return picture;
  cv::Mat bgr;
  cv::cvtColor(picture, bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

cv::Mat round_window(int side_px) { return cv::getStructuringElement(cv::MORPH_ELLIPSE, {side_px, side_px}); }

/// Works in the mask itself, with a byte for each pixel; OpenCV's connected components would take five.
cv::Mat solid_part(const cv::Mat& mask) {
  constexpr int kSeen = 64, kLargest = 32, kReached = 128;
  cv::Mat framed;
  cv::copyMakeBorder(mask, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  cv::compare(framed, 0, framed, cv::CMP_NE);
  cv::Point largest;
  int most_px2 = 0;
  for (int y = 0; y < framed.rows; ++y) {
    for (int x = 0; x < framed.cols; ++x) {
      if (framed.at<std::uint8_t>(y, x) != 255) continue;
      const int area_px2 = cv::floodFill(framed, {x, y}, kSeen);
      if (area_px2 <= most_px2) continue;
      most_px2 = area_px2;
      largest = {x, y};
    }
  }
  if (most_px2 == 0) return cv::Mat::zeros(mask.size(), CV_8U);
  cv::floodFill(framed, largest, kLargest);
  cv::compare(framed, kLargest, framed, cv::CMP_NE);
  cv::floodFill(framed, {0, 0}, kReached, nullptr, 0, 0, 8);
  return framed(cv::Rect({1, 1}, mask.size())) != kReached;
}

double solidity_of(const cv::Mat& mask) {
  HullSide left, right;
  int area_px2 = 0;
  for (int y = 0; y < mask.rows; ++y) {
    const std::uint8_t* row = mask.ptr<std::uint8_t>(y);
    int first = -1, last = -1;
    for (int x = 0; x < mask.cols; ++x) {
      if (!row[x]) continue;
      if (first < 0) first = x;
      last = x;
      ++area_px2;
    }
    if (first < 0) continue;
    for (const int edge : {y, y + 1}) {
      left.add({-first, edge});
      right.add({last + 1, edge});
    }
  }
  if (area_px2 == 0) return 0;
  return 2. * area_px2 / double(left.doubled_area_px2() + right.doubled_area_px2());
}

cv::Mat solid_regions(const cv::Mat& labels, double least_area_px2, double least_solidity) {
  struct Solid {
    cv::Rect box;
    cv::Mat mask;
    int area_px2;
  };
  std::vector<Solid> solids;
  const std::vector<RegionBox> regions = region_boxes(labels);
  for (std::size_t label = 1; label < regions.size(); ++label) {
    const RegionBox& region = regions[label];
    if (region.area_px2 == 0 || region.box.area() < least_area_px2) continue;  // the solid part lies in the box
    const cv::Mat pixels = labels(region.box) == int(label);
    const cv::Mat mask = is_solid(pixels) ? pixels : solid_part(pixels);  // most are
    const int area_px2 = cv::countNonZero(mask);
    if (area_px2 < least_area_px2 || solidity_of(mask) < least_solidity) continue;
    solids.push_back({region.box, mask, area_px2});
  }
  // Smaller regions first, so that a larger one covers those in its holes.
  std::vector<std::size_t> order(solids.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return solids[a].area_px2 < solids[b].area_px2; });
  cv::Mat covered = cv::Mat::zeros(labels.size(), CV_32S);
  for (const std::size_t i : order) covered(solids[i].box).setTo(int(i) + 1, solids[i].mask);

  std::vector<int> number(solids.size() + 1, 0);
  int next = 0;
  const std::vector<RegionBox> left = region_boxes(covered);
  for (std::size_t i = 1; i < left.size(); ++i) {
    if (left[i].area_px2 > 0) number[i] = ++next;
  }
  covered.forEach<int>([&](int& label, const int*) { label = number[std::size_t(label)]; });
  return covered;
}

}  // namespace tessera
