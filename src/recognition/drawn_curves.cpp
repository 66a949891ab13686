#include "recognition/drawn_curves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>

#include "artwork/artwork_render.h"
#include "artwork/images/looks_like_svg.h"
#include "artwork/images/mask.h"
#include "core/base/error.h"
#include "core/geometry/polygon.h"
#include "job/canvas/canvas_edge.h"
#include "job/canvas/canvas_file.h"
#include "recognition/line_trace.h"
#include "recognition/thinning.h"

namespace tessera {
namespace {

/// Longest side of the drawn page.
constexpr int kDrawnSide_px = 1024;
/// Outlines around smaller areas are specks.
constexpr double kLeastArea_px2 = 16;
/// A drawing with more curves keeps the longest ones.
constexpr std::size_t kMostCurves = 200;

/// CV_8U: the pixels that are drawn. On an opaque page these are the pixels that differ from the colour along its edge;
/// holes of that colour are not drawn.
cv::Mat drawn_places(const cv::Mat& page) {
  cv::Mat drawn;
  if (has_transparency(page)) {
    cv::extractChannel(page, drawn, 3);
    return drawn >= 128;
  }
  cv::Mat bgr, difference, channels[3];
  cv::cvtColor(page, bgr, cv::COLOR_BGRA2BGR);
  cv::absdiff(bgr, cv::Scalar(prevailing_edge_colour(bgr)), difference);
  cv::split(difference, channels);
  const cv::Mat largest = cv::max(channels[0], cv::max(channels[1], channels[2]));
  cv::threshold(largest, drawn, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  return drawn;
}

std::vector<Curve> centre_lines(const cv::Mat& page, float pixel) {
  // A margin of one pixel keeps the width of lines at the page's edge.
  cv::Mat drawn;
  cv::copyMakeBorder(drawn_places(page), drawn, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat distance;
  cv::distanceTransform(drawn, distance, cv::DIST_L2, cv::DIST_MASK_5, CV_32F);
  Grid<std::uint8_t> filled(drawn.cols, drawn.rows);
  Grid<float> half_width(drawn.cols, drawn.rows);
  for (int y = 0; y < drawn.rows; ++y) {
    for (int x = 0; x < drawn.cols; ++x) filled(x, y) = drawn.at<std::uint8_t>(y, x) ? 1 : 0;
    std::copy_n(distance.ptr<float>(y), drawn.cols, half_width.row(y));
  }
  std::vector<Curve> curves = traced_lines(thinned(filled), half_width);
  for (Curve& curve : curves) {
    for (Vec2& p : curve.points) p = (p - Vec2{1, 1}) * pixel;
  }
  return curves;
}

std::vector<Curve> outlines(const cv::Mat& page, float pixel) {
  std::vector<Curve> curves;
  for (std::vector<Vec2>& points : traced_edge(mask_coverage(page), pixel)) {
    if (points.size() < 3 || std::abs(signed_area(points)) < kLeastArea_px2 * pixel * pixel) continue;
    curves.push_back({std::move(points), true});
  }
  return curves;
}

void keep_longest(std::vector<Curve>& curves) {
  if (curves.size() <= kMostCurves) return;
  std::vector<float> lengths;
  for (const Curve& curve : curves) lengths.push_back(length_of(curve));
  const auto last = lengths.begin() + std::ptrdiff_t(kMostCurves) - 1;
  std::nth_element(lengths.begin(), last, lengths.end(), std::greater<>());
  const float least = *last;
  std::erase_if(curves, [&](const Curve& curve) { return length_of(curve) < least; });
}

std::string lack_of_curves(TracedAs kind) {
  return kind == TracedAs::outlines
             ? "found nothing that is drawn; needed: an opaque silhouette on a transparent page or a plain background"
             : "found no lines; needed: lines that are longer than wide, on a transparent page or a plain background";
}

}  // namespace

DrawnCurves read_drawn_curves(const std::string& path, TracedAs kind, Drawers& drawers) {
  const std::vector<std::uint8_t> bytes = read_artwork_file(path);
  const cv::Size2d natural = drawers.natural_size(bytes, path);
  const bool outlined = kind == TracedAs::outlines;
  const cv::Mat page = drawers.render(bytes, path, kDrawnSide_px, outlined ? Background::cut_out : Background::kept);
  const float pixel = float(std::max(natural.width, natural.height) / kDrawnSide_px);
  DrawnCurves result{outlined ? outlines(page, pixel) : centre_lines(page, pixel), pixel};
  if (!looks_like_svg(bytes)) result.pixel = std::max(pixel, 1.f);  // an enlarged image shows no more
  keep_longest(result.curves);
  if (result.curves.empty()) throw InputError(path + ": " + lack_of_curves(kind));
  for (const Curve& curve : result.curves) {
    if (const std::string fault = curve_fault(curve); !fault.empty())
      throw InputError(path + ": a curve that cannot be used: " + fault);
  }
  return result;
}

}  // namespace tessera
