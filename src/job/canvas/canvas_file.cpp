#include "job/canvas/canvas_file.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "artwork/images/mask.h"
#include "artwork/silhouette.h"
#include "artwork/solid_coverage.h"
#include "core/base/error.h"
#include "core/field/free_field.h"
#include "job/canvas/canvas_keep_out.h"
#include "job/canvas/canvas_regions.h"
#include "job/job_keys.h"
#include "text/number_text.h"

namespace tessera {
namespace {

constexpr int kMinCanvas_px = 16;

}  // namespace

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

/// Longest side of the page in which translucent parts are found: larger pages would take gigabytes.
constexpr int kMostForParts_px = 4096;

cv::Mat shrunk_alpha(const cv::Mat& image, int longest_side_px) {
  const double scale = double(longest_side_px) / std::max(image.cols, image.rows);
  if (scale >= 1) return image;
  cv::Mat small;
  cv::resize(image, small, {}, scale, scale, cv::INTER_AREA);
  return small;
}

/// Adds translucent parts that end at edges to an alpha channel, as a library does (solid_coverage.h). Soft edges stay:
/// in an enlarged image their width is not known here.
void add_translucent_parts(cv::Mat& alpha) {
  const cv::Mat small = shrunk_alpha(alpha, kSilhouetteSide_px);
  if (solid_coverage(small, 0).coverage.data == small.data) return;  // most drawings have no such parts
  cv::Mat parts;
  cv::resize(solid_coverage(shrunk_alpha(alpha, kMostForParts_px), 0).coverage, parts, alpha.size(), 0, 0,
             cv::INTER_LINEAR);
  alpha = cv::max(alpha, parts);
}

cv::Mat region(const cv::Mat& page) {
  cv::Mat alpha;
  cv::extractChannel(page, alpha, 3);
  add_translucent_parts(alpha);
  if (!has_transparency(page)) {  // an SVG with a background; images already come cut out
    cv::Mat bgr;
    cv::cvtColor(page, bgr, cv::COLOR_BGRA2BGR);
    cv::extractChannel(cut_from_background(bgr), alpha, 3);
  }
  alpha.convertTo(alpha, CV_32F, 1.0 / 255);
  return alpha;
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
  Grid<float> coverage(inside.cols, inside.rows);
  for (int y = 0; y < inside.rows; ++y) std::copy_n(inside.ptr<float>(y), inside.cols, coverage.row(y));
  return coverage;
}

void check_images(const Canvas& canvas, const PieceSettings& pieces) {
  if (!canvas.period.repeats()) return;
  const Window nodes = free_field_grid(canvas, pieces).nodes();
  const double px2 = double(nodes.width()) * nodes.height();
  if (px2 <= kMaxCanvas_px2) return;
  throw InputError("canvas.seamless: " + fixed(px2 / 1e6, 1) +
                   " million px with the images beside the canvas, as far as " +
                   "pieces of pieces.scale_px reach; allowed: " + fixed(kMaxCanvas_px2 / 1e6, 0) + " million");
}

Grid<float> canvas_coverage(const cv::Mat& page, const CanvasSpec& spec) {
  return spec.region_colours.empty() ? mask_coverage(page) : region_coverage(page, region_labels(page, spec));
}

/// Memory limit: a page of the largest size may take three times the memory of its pixels.
DrawerSettings canvas_drawer_settings(const CanvasSpec& spec, double seconds, int side_px) {
  constexpr std::size_t kMebibyte = std::size_t(1) << 20;
  const int largest_px = std::max({2 * spec.width_px, 2 * spec.height_px, side_px});
  const std::size_t side = std::size_t(std::min(largest_px, kMaxArtworkSide_px));
  return {.seconds_per_drawing = seconds,
          .bytes_per_process = std::max(512 * kMebibyte, 256 * kMebibyte + 3 * 4 * side * side)};
}

Canvas load_canvas(const CanvasSpec& spec, double seconds) {
  Drawers drawers(canvas_drawer_settings(spec, seconds));
  return load_canvas(spec, drawers);
}

Canvas canvas_of(const Job& job) {
  try {
    return load_canvas(job.canvas);
  } catch (const InputError& error) {
    throw InputError(job.path + ": " + error.what());
  }
}

namespace {

Canvas canvas_without_zones(const CanvasSpec& spec, Drawers& drawers) {
  if (spec.file.empty()) {
    const bool both = spec.seamless == Seamless::both;
    return make_seamless_canvas(spec.width_px, spec.height_px, both || spec.seamless == Seamless::x,
                                both || spec.seamless == Seamless::y);
  }
  check_no_file(spec);
  const CanvasPage page = canvas_page(spec, drawers);
  if (std::min(page.width_px, page.height_px) < kMinCanvas_px) {
    throw InputError("canvas file " + spec.file + ": only " + std::to_string(page.width_px) + " x " +
                     std::to_string(page.height_px) + " px in the box of canvas.size_px, allowed: " +
                     std::to_string(kMinCanvas_px) + " px or more each");
  }
  Canvas canvas = make_mask_canvas(coverage_on_canvas(page, canvas_coverage(page.bgra, spec)), page.cells_per_px);
  if (canvas.area_px2 <= 0) {
    throw InputError("canvas file " + spec.file + ": no area to fill; needed: an opaque silhouette on a transparent " +
                     "page or a plain background");
  }
  if (!spec.region_colours.empty()) canvas.regions = canvas_regions(page, region_labels(page.bgra, spec), spec);
  return canvas;
}

}  // namespace

Canvas load_canvas(const CanvasSpec& spec, Drawers& drawers) {
  Canvas canvas = canvas_without_zones(spec, drawers);
  take_out_zones(spec, drawers, canvas);
  return canvas;
}

}  // namespace tessera
