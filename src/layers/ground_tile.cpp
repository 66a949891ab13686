#include "layers/ground_tile.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <span>
#include <utility>
#include <vector>

#include "artwork/artwork_render.h"
#include "artwork/images/alpha.h"
#include "artwork/images/image_header.h"
#include "artwork/images/looks_like_svg.h"
#include "core/base/error.h"
#include "job/canvas/canvas_file.h"
#include "job/canvas/canvas_page.h"
#include "job/picture_size.h"
#include "layers/embedded_drawing.h"
#include "layers/svg_image.h"

namespace tessera {
namespace {

constexpr const char* kGroundId = "ground-drawing";  // "ground" is the id of the pattern

double whole_part_of(double period_px, double length_px) {
  return period_px / std::max(1., std::round(period_px / length_px));
}

/// The pixels of the page that the drawing covers wholly. The page of an SVG may end within the last pixels, and tiles
/// would not fit together.
cv::Mat whole_px(const cv::Mat& page, cv::Size2d natural) {
  const double scale = std::max(page.cols, page.rows) / std::max(natural.width, natural.height);
  const auto whole = [&](double side, int px) { return std::clamp(int(std::floor(side * scale + 1e-6)), 1, px); };
  return page(cv::Rect(0, 0, whole(natural.width, page.cols), whole(natural.height, page.rows)));
}

/// The size of the drawing as its file states it. The page may be smaller (many pixels are reduced), and a photo may
/// have been turned.
cv::Size2d size_in_file(std::span<const std::uint8_t> bytes, cv::Size page) {
  const cv::Size2d found = image_size_from_header(bytes).value_or(cv::Size2d(page));
  if (found.area() <= page.area()) return page;
  return (found.width > found.height) == (page.width > page.height) ? found : cv::Size2d(found.height, found.width);
}

/// Longest side of the page that gives the tile as many pixels as the picture has there.
int page_side_px(const OutputSpec& output, const Canvas& canvas, cv::Size2d tile_px) {
  const double picture_px = double(picture_width_px(output)) / canvas.width_px;
  const double side_px = std::ceil(picture_px * std::max(tile_px.width, tile_px.height));
  return int(std::clamp(side_px, 1., double(kMaxArtworkSide_px)));
}

GroundTile drawn(const OutputSpec& output, const Canvas& canvas, Drawers& drawers) {
  const std::string& path = output.ground;
  const std::vector<std::uint8_t> bytes = read_artwork_file(path);
  GroundTile tile;
  if (looks_like_svg(bytes)) {
    const cv::Size2d natural = drawers.natural_size(bytes, path);
    tile.size_px = tile_size_px(natural, output.ground_px, canvas);
    const cv::Mat page = drawers.render(bytes, path, page_side_px(output, canvas, tile.size_px));
    tile.page = whole_px(page, natural);
    EmbeddedDrawing embedded = embedded_drawing(bytes, path, kGroundId, drawers);
    tile.svg = std::move(embedded.svg);
    tile.svg_size = embedded.size;
  } else {
    tile.page = drawers.whole_picture(bytes, path, kMaxArtworkSide_px);
    tile.size_px = tile_size_px(size_in_file(bytes, tile.page.size()), output.ground_px, canvas);
    const cv::Mat image = in_embedded_size(tile.page);
    tile.svg = svg_image(image, kGroundId);
    tile.svg_size = image.size();
  }
  premultiply(tile.page);
  return tile;
}

}  // namespace

cv::Size2d tile_size_px(cv::Size2d drawing, double width_px, const Canvas& canvas) {
  cv::Size2d size_px = drawing;
  if (width_px > 0) size_px = {width_px, width_px * drawing.height / drawing.width};
  size_px = {std::max(1., size_px.width), std::max(1., size_px.height)};
  if (canvas.period.x_px > 0) size_px.width = whole_part_of(canvas.period.x_px, size_px.width);
  if (canvas.period.y_px > 0) size_px.height = whole_part_of(canvas.period.y_px, size_px.height);
  return size_px;
}

GroundTile draw_ground(const OutputSpec& output, const Canvas& canvas, Drawers& drawers) {
  if (output.ground.empty()) return {};
  try {
    return drawn(output, canvas, drawers);
  } catch (const InputError& error) {
    throw InputError(std::string("output.ground: ") + error.what());
  }
}

}  // namespace tessera
