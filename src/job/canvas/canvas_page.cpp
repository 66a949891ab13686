#include "job/canvas/canvas_page.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "artwork/artwork_render.h"
#include "core/base/error.h"
#include "job/millimetres.h"

namespace tessera {

std::vector<std::uint8_t> read_canvas_file(const std::string& path, const char* key) {
  try {
    return read_artwork_file(path);
  } catch (const InputError& error) {
    throw InputError(std::string(key) + ": " + error.what());
  }
}

CanvasPage page_in_box(std::span<const std::uint8_t> bytes, const std::string& path, cv::Size box_px, Drawers& drawers,
                       Background background) {
  const cv::Size box = box_px * 2;
  const int side = std::min(std::max(box.width, box.height), kMaxArtworkSide_px);
  cv::Mat page = drawers.render(bytes, path, side, background);
  const double fit = std::min(double(box.width) / page.cols, double(box.height) / page.rows);
  if (fit > 1) return {page, int(std::lround(page.cols * fit / 2)), int(std::lround(page.rows * fit / 2)), 1};
  if (fit < 1) page = drawers.render(bytes, path, std::max(1, int(fit * side)), background);
  return {page, (page.cols + 1) / 2, (page.rows + 1) / 2, 2};
}

Background background_of(const CanvasSpec& spec) {
  return spec.region_colours.empty() ? Background::cut_out : Background::kept;
}

namespace {

/// The largest size within the box that has the page's aspect ratio, in the box's unit.
cv::Size2d fitted_size(const cv::Size2d& natural, const cv::Size2d& box) {
  return natural * std::min(box.width / natural.width, box.height / natural.height);
}

/// The page of a job with lengths in mm. Its exact box differs from canvas.size_px by a fraction of a px; a page of the
/// same aspect ratio fills it.
CanvasPage page_on_paper(std::span<const std::uint8_t> bytes, const CanvasSpec& spec, Drawers& drawers) {
  const cv::Size2d box_px = cv::Size2d(spec.width_mm, spec.height_mm) * px_per_mm(spec);
  const cv::Size2d exact_px = fitted_size(drawers.natural_size(bytes, spec.file), box_px);
  const auto side = std::max(1L, std::lround(2 * std::max(exact_px.width, exact_px.height)));
  const bool is_fine = side <= kMaxArtworkSide_px;
  const int drawn_px = is_fine ? int(side) : kMaxArtworkSide_px;
  return {drawers.render(bytes, spec.file, drawn_px, background_of(spec)), int(std::lround(exact_px.width)),
          int(std::lround(exact_px.height)), is_fine ? 2 : 1};
}

}  // namespace

void shrink_box_to_page(CanvasSpec& spec, const Canvas& canvas, Drawers& drawers) {
  if (spec.file.empty() || spec.width_mm == 0) return;
  const cv::Size2d natural = drawers.natural_size(read_canvas_file(spec.file), spec.file);
  const cv::Size2d size_mm = fitted_size(natural, {spec.width_mm, spec.height_mm});
  spec.width_px = canvas.width_px;
  spec.height_px = canvas.height_px;
  spec.width_mm = size_mm.width;
  spec.height_mm = size_mm.height;
}

CanvasPage canvas_page(const CanvasSpec& spec, Drawers& drawers) {
  if (spec.width_mm > 0) return page_on_paper(read_canvas_file(spec.file), spec, drawers);
  return page_in_box(read_canvas_file(spec.file), spec.file, {spec.width_px, spec.height_px}, drawers,
                     background_of(spec));
}

Grid<float> coverage_on_canvas(const CanvasPage& page, const Grid<float>& coverage) {
  const int width = page.cells_per_px * page.width_px, height = page.cells_per_px * page.height_px;
  Grid<float> cells(width, height, 0.f);
  if (page.cells_per_px == 1) {
    const cv::Mat drawn(coverage.height(), coverage.width(), CV_32F, const_cast<float*>(coverage.row(0)));
    cv::Mat on_canvas(height, width, CV_32F, cells.row(0));
    cv::resize(drawn, on_canvas, on_canvas.size(), 0, 0, cv::INTER_LINEAR);
  } else {
    const int columns = std::min(width, coverage.width()), rows = std::min(height, coverage.height());
    for (int y = 0; y < rows; ++y) std::copy_n(coverage.row(y), columns, cells.row(y));
  }
  return cells;
}

}  // namespace tessera
