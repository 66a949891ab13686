#include "io/job/canvas_edge.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/geometry/contour.h"
#include "io/job/canvas_file.h"

namespace tessera::io {
namespace {

// px of the page. Drawn coverage has few steps, so that its contour trembles by a tenth of a px: a blur takes that away,
// and rounds corners by no more than itself.
constexpr double kBlur_px = 1;
constexpr double kTolerance_px = 0.02;

int longest_side(const cv::Mat& page) { return std::max(page.cols, page.rows); }

void blur(Grid<float>& coverage) {
  cv::Mat image(coverage.height(), coverage.width(), CV_32F, coverage.data().data());
  cv::GaussianBlur(image, image, {0, 0}, kBlur_px, kBlur_px, cv::BORDER_REPLICATE);
}

/// With as few points as the tolerance allows.
std::vector<Vec2> simplified(const std::vector<Vec2>& curve) {
  std::vector<cv::Point2f> points, kept;
  for (const Vec2& p : curve) points.emplace_back(p.x, p.y);
  cv::approxPolyDP(points, kept, kTolerance_px, true);
  std::vector<Vec2> result;
  for (const cv::Point2f& p : kept) result.push_back({p.x, p.y});
  return result;
}

}  // namespace

std::vector<std::vector<Vec2>> traced_edge(Grid<float> coverage, float canvas_px) {
  blur(coverage);
  std::vector<std::vector<Vec2>> edge;
  for (const std::vector<Vec2>& curve : contours(coverage, 0.5f)) {
    edge.push_back(simplified(curve));
    for (Vec2& p : edge.back()) p = (p + Vec2{0.5f, 0.5f}) * canvas_px;  // nodes lie in the middle of their px
  }
  return edge;
}

std::vector<std::vector<Vec2>> canvas_edge(const CanvasSpec& spec, Drawers& drawers) {
  if (spec.file.empty()) return {};
  const int canvas_page_px = longest_side(canvas_page(spec, drawers));
  const int side_px = std::max(canvas_page_px, kEdgeSide_px);
  return traced_edge(canvas_coverage(drawers.render(read_canvas_file(spec.file), spec.file, side_px), spec),
                     0.5f * float(canvas_page_px) / float(side_px));
}

}  // namespace tessera::io
