#include "io/artwork/artwork_page.h"

#include <algorithm>
#include <cmath>

#include "io/artwork/raster_page.h"
#include "io/artwork/svg_page.h"

namespace tessera::io {

std::unique_ptr<ArtworkPage> open_artwork_page(std::span<const std::uint8_t> bytes, const std::string& path,
                                               Background background) {
  if (looks_like_svg(bytes)) return open_svg_page(bytes, path);
  return open_raster_page(bytes, path, background);
}

cv::Size page_size_px(const ArtworkPage& page, int longest_side_px) {
  const cv::Size2d natural = page.natural_size();
  const double scale = longest_side_px / std::max(natural.width, natural.height);
  // The longest side must come out exactly, so a rounding error must not add a column.
  const auto side = [&](double length) { return std::max(1, int(std::ceil(length * scale - 1e-6))); };
  return {side(natural.width), side(natural.height)};
}

}  // namespace tessera::io
