#include "job/canvas/canvas_edge.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/geometry/contour.h"
#include "job/canvas/canvas_file.h"
#include "job/canvas/canvas_page.h"
#include "job/canvas/canvas_regions.h"
#include "job/canvas/whole_regions.h"

namespace tessera {
namespace {

// Blur of the coverage in px of the page. Drawn coverage has few steps, so its contour wavers by a tenth of a px. The
// blur removes that, and rounds corners by no more than itself.
constexpr double kBlur_px = 1;
constexpr double kBorderBlur_px = 2;  // between regions, where the shares of the colours are less certain
constexpr double kTolerance_px = 0.02;
/// Distance by which a ground reaches beneath those after it, and all grounds beyond the page.
constexpr int kBeneath_px = 8;

/// A page and the size of its pixels on the canvas.
struct EdgePage {
  cv::Mat bgra;
  float canvas_px = 1;  // width of a px of the page
};

EdgePage edge_page(const CanvasSpec& spec, Drawers& drawers) {
  const CanvasPage page = canvas_page(spec, drawers);
  const int page_side_px = std::max(page.bgra.cols, page.bgra.rows);
  const int side_px = std::max(page_side_px, kEdgeSide_px);
  const float canvas_px = page.canvas_px() * float(page_side_px) / float(side_px);
  return {drawers.render(read_canvas_file(spec.file), spec.file, side_px, background_of(spec)), canvas_px};
}

/// The curve with as few points as the tolerance allows.
std::vector<Vec2> simplified(const std::vector<Vec2>& curve) {
  std::vector<cv::Point2f> points, kept;
  for (const Vec2& p : curve) points.emplace_back(p.x, p.y);
  cv::approxPolyDP(points, kept, kTolerance_px, true);
  std::vector<Vec2> result;
  for (const cv::Point2f& p : kept) result.push_back({p.x, p.y});
  return result;
}

/// The contour of a coverage whose first node is at (corner_px, corner_px) of the page.
std::vector<std::vector<Vec2>> traced(Grid<float> coverage, double blur_px, int corner_px, float canvas_px) {
  cv::Mat image(coverage.height(), coverage.width(), CV_32F, coverage.row(0));
  cv::GaussianBlur(image, image, {0, 0}, blur_px, blur_px, cv::BORDER_REPLICATE);
  const float to_corner = float(corner_px) + 0.5f;  // nodes are at the centres of their px
  std::vector<std::vector<Vec2>> curves;
  for (const std::vector<Vec2>& curve : contours(coverage, 0.5f)) {
    curves.push_back(simplified(curve));
    for (Vec2& p : curves.back()) p = (p + Vec2{to_corner, to_corner}) * canvas_px;
  }
  return curves;
}

/// Coverage of a region with a rim: beneath the regions after it and round the page. Its border with the regions before
/// it runs where the colours mix.
Grid<float> ground_coverage(const cv::Mat_<short>& with_rim, const std::vector<BorderPlace>& borders, short region) {
  const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * kBeneath_px + 1, 2 * kBeneath_px + 1});
  const cv::Mat own = with_rim == region;
  cv::Mat ground;
  cv::dilate(own, ground, disc);
  ground = own | (ground & (with_rim > region));
  Grid<float> coverage(ground.cols, ground.rows);
  const cv::Mat as_floats(ground.rows, ground.cols, CV_32F, coverage.row(0));
  ground.convertTo(as_floats, CV_32F, 1. / 255);
  for (const BorderPlace& place : borders) {
    if (place.second == region) coverage(place.at.x + kBeneath_px, place.at.y + kBeneath_px) = place.second_share;
  }
  return coverage;
}

std::vector<Ground> region_grounds(const EdgePage& page, const CanvasSpec& spec) {
  const std::vector<std::string>& colours = spec.region_backgrounds;
  if (std::all_of(colours.begin(), colours.end(), [](const std::string& colour) { return colour.empty(); })) return {};
  const WholeRegions whole = whole_regions(region_labels(page.bgra, spec), page.bgra);
  cv::Mat_<short> with_rim;
  cv::copyMakeBorder(whole.labels, with_rim, kBeneath_px, kBeneath_px, kBeneath_px, kBeneath_px, cv::BORDER_REPLICATE);
  std::vector<Ground> grounds;
  for (std::size_t k = 0; k < colours.size(); ++k) {
    Grid<float> coverage = ground_coverage(with_rim, whole.borders, short(k));
    grounds.push_back({traced(std::move(coverage), kBorderBlur_px, -kBeneath_px, page.canvas_px), colours[k]});
  }
  return grounds;
}

}  // namespace

std::vector<std::vector<Vec2>> traced_edge(Grid<float> coverage, float canvas_px) {
  return traced(std::move(coverage), kBlur_px, 0, canvas_px);
}

void check_canvas_edge(const CanvasSpec& spec, const Canvas& canvas, Drawers& drawers) {
  const bool drawn_already = 2 * std::max(canvas.width_px, canvas.height_px) >= kEdgeSide_px;
  if (spec.file.empty() || drawn_already) return;
  drawers.render(read_canvas_file(spec.file), spec.file, kEdgeSide_px, background_of(spec));
}

CanvasEdge canvas_edge(const CanvasSpec& spec, Drawers& drawers) {
  if (spec.file.empty()) return {};
  const EdgePage page = edge_page(spec, drawers);
  return {traced_edge(canvas_coverage(page.bgra, spec), page.canvas_px), region_grounds(page, spec)};
}

}  // namespace tessera
