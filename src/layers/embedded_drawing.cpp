#include "layers/embedded_drawing.h"

#include <algorithm>
#include <optional>

#include "artwork/images/looks_like_svg.h"
#include "core/base/error.h"
#include "layers/svg_image.h"

namespace tessera {
namespace {

/// Picture size for an SVG that cannot be copied: the size that its page states may be anything.
constexpr int kPictureOfSvg_px = 1024;

std::optional<std::string> copied(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& id,
                                  Drawers& drawers) {
  try {
    return drawers.import_svg(bytes, path, id);
  } catch (const InputError&) {
    return std::nullopt;  // Drawers::render reports the error, if there is one
  }
}

EmbeddedDrawing picture(const cv::Mat& bgra, const std::string& id) { return {svg_image(bgra, id), bgra.size()}; }

}  // namespace

EmbeddedDrawing embedded_drawing(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& id,
                                 Drawers& drawers) {
  const cv::Size2d size = drawers.natural_size(bytes, path);
  if (looks_like_svg(bytes)) {
    if (auto svg = copied(bytes, path, id, drawers)) return {std::move(*svg), size};
    return picture(drawers.render(bytes, path, kPictureOfSvg_px), id);
  }
  const double side = std::clamp(std::max(size.width, size.height), 1., double(kMaxBitmapSide_px));
  return picture(drawers.render(bytes, path, int(side)), id);
}

}  // namespace tessera
