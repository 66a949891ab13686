#include "job/canvas/overlay.h"

#include <algorithm>

#include "artwork/artwork_render.h"
#include "artwork/drawers/drawers.h"
#include "artwork/images/looks_like_svg.h"
#include "core/base/error.h"
#include "job/canvas/canvas_page.h"

namespace tessera {
namespace {

cv::Mat page_of(const std::vector<std::uint8_t>& bytes, const std::string& path, const char* key, int side_px,
                Drawers& drawers) try {
  return looks_like_svg(bytes) ? drawers.render(bytes, path, side_px)
                               : drawers.whole_picture(bytes, path, kMaxArtworkSide_px);
} catch (const InputError& error) {
  throw InputError(std::string(key) + ": " + error.what());
}

}  // namespace

cv::Mat whole_overlay(const std::string& path, const char* key, int side_px, Drawers& drawers) {
  const std::vector<std::uint8_t> bytes = read_canvas_file(path, key);
  return page_of(bytes, path, key, std::clamp(side_px, 1, kMaxArtworkSide_px), drawers);
}

cv::Mat overlay_picture(const std::string& path, const char* key, const Canvas& canvas, int side_px, Drawers& drawers) {
  const cv::Mat page = whole_overlay(path, key, side_px, drawers);
  const double fit = std::min(double(page.cols) / canvas.width_px, double(page.rows) / canvas.height_px);
  const cv::Size part(std::max(1, int(canvas.width_px * fit)), std::max(1, int(canvas.height_px * fit)));
  return page(cv::Rect({(page.cols - part.width) / 2, (page.rows - part.height) / 2}, part));
}

}  // namespace tessera
