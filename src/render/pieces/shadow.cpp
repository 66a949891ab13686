#include "render/pieces/shadow.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/geometry/rasterise.h"
#include "render/pieces/piece_drawing.h"

namespace tessera {
namespace {

/// A shadow with this blur looks the same when it is drawn in a coarser picture.
constexpr double kLeastBlur_px = 4;

/// A place between the middles of two px of the coarse picture.
struct Between {
  int first = 0;
  float second_part = 0;
};

Between between(int px, int coarseness) {
  const double at = (px + 0.5) / coarseness - 0.5;
  const double first = std::floor(at);
  return {int(first), float(at - first)};
}

}  // namespace

Shadow::Shadow(const CollageReport& report, const cv::Size& picture_px) : strength_(report.output.shadow_strength) {
  if (strength_ == 0) return;
  const OutputSpec& output = report.output;
  const double px = double(picture_px.width) / report.canvas->width_px;
  coarseness_ = std::max(1, int(output.shadow_blur_px * px / kLeastBlur_px));
  const double coarse_px = px / coarseness_;
  blur_px_ = output.shadow_blur_px * coarse_px;
  for (const Placement& placement : report.placements) {
    const Outline& outline = report.shape(placement.shape).outline;
    for (const Vec2 image : report.canvas->period.offsets()) {
      Similarity t = scaled(moved(placement.canvas_from_shape, image), float(coarse_px));
      t.tx += float(output.shadow_offset_px[0] * coarse_px);
      t.ty += float(output.shadow_offset_px[1] * coarse_px);
      const Window reach = bounding_window(outline, t).grown(1);
      casters_.push_back({{&outline.curves, t}, {reach.x0, reach.y0, reach.width(), reach.height()}});
    }
  }
}

void Shadow::draw(int top, cv::Mat rows) const {
  if (casters_.empty()) return;
  const int first_row = between(top, coarseness_).first;
  const int last_row = between(top + rows.rows - 1, coarseness_).first + 1;
  const cv::Rect window(-1, first_row, between(rows.cols - 1, coarseness_).first + 3, last_row + 1 - first_row);
  const cv::Mat coarse = blurred(window);
  std::vector<Between> columns;
  for (int x = 0; x < rows.cols; ++x) columns.push_back(between(x, coarseness_));
  cv::Mat dark(1, rows.cols, CV_8UC4);  // black, with the shadow as alpha
  for (int y = 0; y < rows.rows; ++y) {
    const Between row = between(top + y, coarseness_);
    const std::uint8_t* above = coarse.ptr(row.first - first_row);
    const std::uint8_t* below = coarse.ptr(row.first - first_row + 1);
    for (int x = 0; x < rows.cols; ++x) {
      const auto [first, part] = columns[std::size_t(x)];
      const auto mixed = [&](const std::uint8_t* at) {
        return float(at[first + 1]) * (1 - part) + float(at[first + 2]) * part;
      };
      const float shadow = mixed(above) * (1 - row.second_part) + mixed(below) * row.second_part;
      dark.at<cv::Vec4b>(0, x) = {0, 0, 0, std::uint8_t(std::lround(shadow * strength_))};
    }
    lay_over(dark, rows.row(y));
  }
}

cv::Mat Shadow::blurred(const cv::Rect& window) const {
  const int margin = int(std::ceil(3 * blur_px_)) + 1;  // reach of the blur on 8-bit images
  const cv::Rect wide(window.x - margin, window.y - margin, window.width + 2 * margin, window.height + 2 * margin);
  std::vector<PlacedCurves> near;
  for (const Caster& caster : casters_) {
    if (!(caster.reach & wide).empty()) near.push_back(caster.coarse);
  }
  cv::Mat coverage = filled_coverage(near, wide);
  cv::GaussianBlur(coverage, coverage, {0, 0}, blur_px_, blur_px_, cv::BORDER_CONSTANT);
  return coverage(cv::Rect(margin, margin, window.width, window.height));
}

}  // namespace tessera
