#include "run/recognition/query_file.h"

#include <algorithm>
#include <cmath>

#include "artwork/images/looks_like_svg.h"
#include "core/base/error.h"
#include "core/geometry/contour.h"
#include "core/geometry/polygon.h"
#include "core/shape/outline.h"
#include "files/regular_file.h"

namespace tessera {
namespace {

constexpr std::size_t kMostBytes = std::size_t(256) << 20;
/// Longer sides of the pictures that are traced. Vectors have no pixels of their own.
constexpr double kVectorSide_px = 1024;
constexpr double kMostImageSide_px = 2048;
/// Outlines of less than this part of the largest one are dirt.
constexpr double kLeastPart = 1e-4;

Grid<float> alpha_of(const cv::Mat& bgra) {
  Grid<float> alpha(bgra.cols, bgra.rows);
  for (int y = 0; y < bgra.rows; ++y) {
    for (int x = 0; x < bgra.cols; ++x) alpha(x, y) = float(bgra.at<cv::Vec4b>(y, x)[3]) / 255;
  }
  return alpha;
}

}  // namespace

QueryFile read_query_file(Drawers& drawers, const std::string& path) {
  const std::vector<std::uint8_t> bytes = read_regular_file(path, kMostBytes);
  const cv::Size2d size = drawers.natural_size(bytes, path);
  const double longest = std::max(size.width, size.height);
  const double side_px = looks_like_svg(bytes) ? kVectorSide_px : std::min(longest, kMostImageSide_px);
  const cv::Mat page = drawers.render(bytes, path, int(std::ceil(side_px)));

  QueryFile file{path, {}, float(side_px / longest)};
  std::vector<std::vector<Vec2>> curves = contours(alpha_of(page), kEdgeOpacity);
  double largest = 0;
  for (const std::vector<Vec2>& curve : curves) largest = std::max(largest, std::abs(signed_area(curve)));
  for (std::vector<Vec2>& curve : curves) {
    if (std::abs(signed_area(curve)) < kLeastPart * largest) continue;
    Curve outline{std::move(curve), true};
    if (curve_fault(outline).empty()) file.outlines.push_back(std::move(outline));
  }
  if (file.outlines.empty()) throw InputError(path + ": shows nothing that has an outline");
  return file;
}

}  // namespace tessera
