#include "render/pieces/warped_artwork.h"

#include <algorithm>
#include <cmath>

#include "artwork/warping/warped_picture.h"

namespace tessera {

Warp warp_of_page(const Artwork& artwork, const Warp& warp, double units_per_px) {
  const float units = float(units_per_px);
  return in_frame(warp, artwork.unit_px * units, artwork.centroid_px * units, artwork.mirrored);
}

Sprite warped_sprite(const Sprite& sprite, const Artwork& artwork, const Warp& warp, float margin_px) {
  const double scale = sprite.px_per_artwork_px;
  Warp pixel_warp = warp_of_page(artwork, warp, scale);
  const float margin = margin_px * float(scale);
  for (Vec2& d : pixel_warp.displacement.data()) d = d + Vec2{margin, margin};
  const cv::Size size(std::max(1, int(std::ceil((artwork.width_px + 2 * double(margin_px)) * scale))),
                      std::max(1, int(std::ceil((artwork.height_px + 2 * double(margin_px)) * scale))));
  return {warped_picture(sprite.bgra, pixel_warp, size), scale};
}

}  // namespace tessera
