#include "job/canvas/canvas_keep_out.h"

#include <algorithm>

#include "artwork/artwork_render.h"
#include "core/base/error.h"
#include "core/field/keep_out.h"
#include "job/canvas/canvas_file.h"
#include "job/canvas/canvas_page.h"

namespace tessera {
namespace {

/// Longest side of a canvas with such a file, as the file is drawn at twice the canvas' resolution.
constexpr int kMaxMaskCanvas_px = kMaxArtworkSide_px / 2;

void check_size(const CanvasSpec& spec, const Canvas& canvas) {
  if (std::max(canvas.width_px, canvas.height_px) <= kMaxMaskCanvas_px) return;
  throw InputError("canvas.keep_out: found " + spec.keep_out + " with a canvas of " + std::to_string(canvas.width_px) +
                   " x " + std::to_string(canvas.height_px) +
                   " px, allowed with a file: " + std::to_string(kMaxMaskCanvas_px) + " px or less each");
}

/// The silhouette in the file over the whole canvas, at twice its resolution.
Grid<float> coverage_of_file(const CanvasSpec& spec, Drawers& drawers, const Canvas& canvas) {
  check_size(spec, canvas);
  const cv::Size box_px(2 * canvas.width_px, 2 * canvas.height_px);
  const auto bytes = read_canvas_file(spec.keep_out, "canvas.keep_out");
  const CanvasPage drawn = page_in_box(bytes, spec.keep_out, {canvas.width_px, canvas.height_px}, drawers);
  const Grid<float> page = mask_coverage(drawn.bgra);
  Grid<float> coverage(box_px.width, box_px.height, 0.f);
  const int left = (box_px.width - page.width()) / 2;
  const int top = (box_px.height - page.height()) / 2;
  for (int y = 0; y < page.height(); ++y) std::copy_n(page.row(y), page.width(), coverage.row(top + y) + left);
  const std::vector<float>& cells = coverage.data();
  if (std::none_of(cells.begin(), cells.end(), [](float part) { return part >= 0.5f; })) {
    throw InputError("canvas.keep_out: " + spec.keep_out + " shows nothing; needed: an opaque silhouette on a " +
                     "transparent page or a plain background");
  }
  return coverage;
}

}  // namespace

void take_out_zones(const CanvasSpec& spec, Drawers& drawers, Canvas& canvas) {
  if (!spec.keep_out_rectangles.empty()) take_out(distance_to(spec.keep_out_rectangles, canvas), canvas);
  if (!spec.keep_out.empty()) take_out(distance_to(coverage_of_file(spec, drawers, canvas), canvas), canvas);
  if (canvas.area_px2 > 0) return;
  throw InputError("canvas.keep_out and [[keep_out]] leave nothing of the canvas; needed: room for pieces");
}

cv::Rect2d place_on_canvas(cv::Size2d page, const Canvas& canvas) {
  const double fit = std::min(canvas.width_px / page.width, canvas.height_px / page.height);
  const cv::Size2d size = page * fit;
  return {cv::Point2d((canvas.width_px - size.width) / 2, (canvas.height_px - size.height) / 2), size};
}

}  // namespace tessera
