#include "io/job/canvas_file.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/field/free_field.h"
#include "io/artwork/mask.h"
#include "io/job/canvas_keep_out.h"
#include "io/job/canvas_regions.h"
#include "io/job/job_keys.h"
#include "io/number_text.h"

namespace tessera::io {
namespace {

constexpr int kMinCanvas_px = 16;

}  // namespace

std::vector<std::uint8_t> read_canvas_file(const std::string& path, const char* key) {
  try {
    return read_artwork_file(path);
  } catch (const InputError& error) {
    throw InputError(std::string(key) + ": " + error.what());
  }
}

cv::Mat page_in_box(std::span<const std::uint8_t> bytes, const std::string& path, cv::Size box_px, Drawers& drawers) {
  const int side = std::max(box_px.width, box_px.height);
  const cv::Mat page = drawers.render(bytes, path, side);
  const double fit = std::min(double(box_px.width) / page.cols, double(box_px.height) / page.rows);
  return fit >= 1 ? page : drawers.render(bytes, path, std::max(1, int(fit * side)));
}

cv::Mat canvas_page(const CanvasSpec& spec, Drawers& drawers) {
  return page_in_box(read_canvas_file(spec.file), spec.file, {2 * spec.width_px, 2 * spec.height_px}, drawers);
}

bool has_transparency(const cv::Mat& page) {
  constexpr int kRim_px = 2;
  if (page.cols <= 2 * kRim_px || page.rows <= 2 * kRim_px) return false;
  const cv::Rect inner(kRim_px, kRim_px, page.cols - 2 * kRim_px, page.rows - 2 * kRim_px);
  cv::Mat alpha;
  cv::extractChannel(page(inner), alpha, 3);
  double least = 255;
  cv::minMaxLoc(alpha, &least);
  return least < 128;
}

namespace {

cv::Mat region(const cv::Mat& page) {
  cv::Mat alpha;
  cv::extractChannel(page, alpha, 3);
  if (!has_transparency(page)) {  // an SVG with a background; images come cut out already
    cv::Mat bgr;
    cv::cvtColor(page, bgr, cv::COLOR_BGRA2BGR);
    cv::extractChannel(cut_from_background(bgr), alpha, 3);
  }
  alpha.convertTo(alpha, CV_32F, 1.0 / 255);
  return alpha;
}

void check_box(const CanvasSpec& spec) {
  if (std::max(spec.width_px, spec.height_px) <= kMaxMaskCanvas_px) return;
  throw InputError("canvas.size_px: found [" + std::to_string(spec.width_px) + ", " + std::to_string(spec.height_px) +
                   "], allowed with a canvas.file: " + std::to_string(kMaxMaskCanvas_px) + " px or less each");
}

void check_no_file(const CanvasSpec& spec) {
  if (spec.seamless == Seamless::none) return;
  const std::string& found = find_job_key("canvas", "seamless")->words[std::size_t(spec.seamless)];
  throw InputError("canvas.seamless: found \"" + found + "\" with the canvas.file " + spec.file +
                   ", allowed with a file: \"none\", as only a rectangle goes on across its edges");
}

}  // namespace

Grid<float> mask_coverage(const cv::Mat& page) {
  const cv::Mat inside = region(page);
  Grid<float> coverage(inside.cols + inside.cols % 2, inside.rows + inside.rows % 2, 0.f);
  for (int y = 0; y < inside.rows; ++y) std::copy_n(inside.ptr<float>(y), inside.cols, coverage.row(y));
  return coverage;
}

void check_images(const Canvas& canvas, const PieceSettings& pieces) {
  if (!canvas.period.repeats()) return;
  const Window nodes = free_field_grid(canvas, pieces).nodes();
  const double px2 = double(nodes.width()) * nodes.height();
  if (px2 <= kMaxCanvas_px2) return;
  throw InputError("canvas.seamless: " + fixed(px2 / 1e6, 1) + " million px with the images beside the canvas, as far as " +
                   "pieces of pieces.scale_px reach; allowed: " + fixed(kMaxCanvas_px2 / 1e6, 0) + " million");
}

Grid<float> canvas_coverage(const cv::Mat& page, const CanvasSpec& spec) {
  return spec.region_colours.empty() ? mask_coverage(page) : region_coverage(page, spec);
}

/// A page of the largest size may take three times its pixels.
DrawerSettings canvas_drawer_settings(const CanvasSpec& spec, double seconds, int side_px) {
  constexpr std::size_t kMebibyte = std::size_t(1) << 20;
  const std::size_t side = std::size_t(std::max({2 * spec.width_px, 2 * spec.height_px, side_px}));
  return {.seconds_per_drawing = seconds,
          .bytes_per_process = std::max(512 * kMebibyte, 256 * kMebibyte + 3 * 4 * side * side)};
}

Canvas load_canvas(const CanvasSpec& spec, double seconds) {
  Drawers drawers(canvas_drawer_settings(spec, seconds));
  return load_canvas(spec, drawers);
}

namespace {

Canvas canvas_without_zones(const CanvasSpec& spec, Drawers& drawers) {
  if (spec.file.empty()) {
    const bool both = spec.seamless == Seamless::both;
    return make_seamless_canvas(spec.width_px, spec.height_px, both || spec.seamless == Seamless::x,
                                both || spec.seamless == Seamless::y);
  }
  check_no_file(spec);
  check_box(spec);
  const cv::Mat page = canvas_page(spec, drawers);
  const Grid<float> coverage = canvas_coverage(page, spec);
  if (std::min(coverage.width(), coverage.height()) < 2 * kMinCanvas_px) {
    throw InputError("canvas file " + spec.file + ": only " + std::to_string(coverage.width() / 2) + " x " +
                     std::to_string(coverage.height() / 2) + " px in the box of canvas.size_px, allowed: " +
                     std::to_string(kMinCanvas_px) + " px or more each");
  }
  Canvas canvas = make_mask_canvas(coverage);
  if (canvas.area_px2 <= 0) {
    throw InputError("canvas file " + spec.file + ": no area to fill; needed: an opaque silhouette on a transparent " +
                     "page or a plain background");
  }
  canvas.regions = canvas_regions(page, spec);
  return canvas;
}

}  // namespace

Canvas load_canvas(const CanvasSpec& spec, Drawers& drawers) {
  Canvas canvas = canvas_without_zones(spec, drawers);
  take_out_zones(spec, drawers, canvas);
  return canvas;
}

}  // namespace tessera::io
