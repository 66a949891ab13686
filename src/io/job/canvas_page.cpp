#include "io/job/canvas_page.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "io/artwork/artwork_render.h"

namespace tessera::io {

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

CanvasPage canvas_page(const CanvasSpec& spec, Drawers& drawers) {
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
    for (int y = 0; y < coverage.height(); ++y) std::copy_n(coverage.row(y), coverage.width(), cells.row(y));
  }
  return cells;
}

}  // namespace tessera::io
