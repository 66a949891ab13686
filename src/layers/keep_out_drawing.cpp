#include "layers/keep_out_drawing.h"

#include <algorithm>
#include <utility>

#include "job/canvas/canvas_edge.h"
#include "job/canvas/canvas_file.h"
#include "job/canvas/canvas_keep_out.h"
#include "job/canvas/canvas_page.h"
#include "job/picture_size.h"
#include "layers/embedded_drawing.h"

namespace tessera {
namespace {

constexpr const char* kKeepOutId = "keep-out";

/// Longest side of the page: twice as fine as the picture, like the sprites of pieces.
int page_side_px(const OutputSpec& output, const Canvas& canvas, const cv::Rect2d& place_px) {
  const double picture_px = double(picture_width_px(output)) / canvas.width_px;
  const double side = 2 * picture_px * std::max(place_px.width, place_px.height);
  return int(std::clamp(side, double(kEdgeSide_px), double(kMaxArtworkSide_px)));
}

std::vector<std::vector<Vec2>> clip_of(const cv::Mat& page, const cv::Rect2d& place_px) {
  if (has_transparency(page)) return {};
  auto clip = traced_edge(mask_coverage(page), float(place_px.width / page.cols));
  for (std::vector<Vec2>& curve : clip) {
    for (Vec2& p : curve) p = p + Vec2{float(place_px.x), float(place_px.y)};
  }
  return clip;
}

}  // namespace

KeepOutDrawing draw_keep_out(const std::string& path, const OutputSpec& output, const Canvas& canvas,
                             Drawers& drawers) {
  if (path.empty()) return {};
  const auto bytes = read_canvas_file(path, "canvas.keep_out");
  const cv::Size2d natural = drawers.natural_size(bytes, path);
  KeepOutDrawing drawing;
  drawing.place_px = place_on_canvas(natural, canvas);
  drawing.page = drawers.render(bytes, path, page_side_px(output, canvas, drawing.place_px));
  drawing.clip = clip_of(drawing.page, drawing.place_px);
  EmbeddedDrawing embedded = embedded_drawing(bytes, path, kKeepOutId, drawers);
  drawing.svg = std::move(embedded.svg);
  drawing.svg_width = embedded.size.width;
  return drawing;
}

}  // namespace tessera
