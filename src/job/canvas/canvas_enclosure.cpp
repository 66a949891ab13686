#include "job/canvas/canvas_enclosure.h"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace tessera {
namespace {

/// Longest side of the grid that is searched for enclosed areas: a large canvas takes no more memory than others.
constexpr int kMostCells = 1024;
/// Tolerance by which a line that runs between two nodes still closes an outline.
constexpr float kHalfDiagonal_px = 0.75f;

/// `inside_px(i, j)`: signed distance at a node, positive inside. An area is enclosed if it is not connected to the
/// border of the grid.
template <typename Distance>
double covered_part(const Grid<float>& nodes, const Distance& inside_px) {
  const int step = (std::max(nodes.width(), nodes.height()) + kMostCells - 1) / kMostCells;
  cv::Mat cells(nodes.height() / step + 3, nodes.width() / step + 3, CV_8U, cv::Scalar(0));
  double covered_px2 = 0;
  for (int j = 0; j < nodes.height(); ++j) {
    std::uint8_t* row = cells.ptr<std::uint8_t>(j / step + 1) + 1;
    for (int i = 0; i < nodes.width(); ++i) {
      const float distance_px = inside_px(i, j);
      covered_px2 += double(std::clamp(distance_px + 0.5f, 0.f, 1.f));
      if (distance_px > -kHalfDiagonal_px) row[i / step] = 1;
    }
  }
  cv::floodFill(cells, cv::Point(0, 0), cv::Scalar(2));
  const double enclosed_px2 = double(cells.total() - std::size_t(cv::countNonZero(cells == 2))) * step * step;
  return enclosed_px2 > 0 ? std::min(1.0, covered_px2 / enclosed_px2) : 1;
}

}  // namespace

double covered_share(const Canvas& canvas) {
  const Grid<float>& distance = canvas.distance.value;
  if (!canvas.has_zones()) return covered_part(distance, [&](int i, int j) { return distance(i, j); });
  const Grid<float>& to_zones = canvas.keep_out.value;
  return covered_part(distance, [&](int i, int j) { return std::max(distance(i, j), -to_zones(i, j)); });
}

double zones_part_of_enclosed(const Canvas& canvas) {
  if (!canvas.has_zones()) return 1;
  const Grid<float>& to_zones = canvas.keep_out.value;
  return covered_part(to_zones, [&](int i, int j) { return -to_zones(i, j); });
}

}  // namespace tessera
