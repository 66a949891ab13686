#include "io/job/overlay.h"

#include <algorithm>

#include "io/artwork/artwork_render.h"
#include "io/artwork/svg_page.h"
#include "io/drawing/drawers.h"
#include "io/job/canvas_page.h"

namespace tessera::io {

cv::Mat overlay_picture(const std::string& path, const char* key, const Canvas& canvas, int side_px) {
  Drawers drawers(photo_drawer_settings(1));
  const std::vector<std::uint8_t> bytes = read_canvas_file(path, key);
  const cv::Mat page = looks_like_svg(bytes)
                           ? drawers.render(bytes, path, std::clamp(side_px, 1, kMaxArtworkSide_px))
                           : drawers.whole_picture(bytes, path, kMaxArtworkSide_px);
  const double fit = std::min(double(page.cols) / canvas.width_px, double(page.rows) / canvas.height_px);
  const cv::Size part(std::max(1, int(canvas.width_px * fit)), std::max(1, int(canvas.height_px * fit)));
  return page(cv::Rect({(page.cols - part.width) / 2, (page.rows - part.height) / 2}, part));
}

}  // namespace tessera::io
