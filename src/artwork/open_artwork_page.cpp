#include "artwork/open_artwork_page.h"

#include "artwork/images/looks_like_svg.h"
#include "artwork/images/raster_page.h"
#include "artwork/svg/svg_page.h"

namespace tessera {

std::unique_ptr<ArtworkPage> open_artwork_page(std::span<const std::uint8_t> bytes, const std::string& path,
                                               Background background) {
  if (looks_like_svg(bytes)) return open_svg_page(bytes, path);
  return open_raster_page(bytes, path, background);
}

}  // namespace tessera
