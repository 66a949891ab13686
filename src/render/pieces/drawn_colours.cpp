#include "render/pieces/drawn_colours.h"

#include <algorithm>
#include <cstdint>

#include "artwork/images/colour_conversion.h"
#include "artwork/silhouette.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "core/geometry/extent.h"
#include "render/pieces/artwork_original.h"
#include "render/pieces/sprite.h"

namespace tessera {
namespace {

int cell_along(float at, float low, float high) {
  return std::clamp(int((at - low) / (high - low) * kColourSide), 0, kColourSide - 1);
}

DrawnColours of_thumbnail(const Shape& shape, Drawers& drawers) {
  if (shape.artwork.thumbnail_png.empty()) return drawn_colours(shape);
  try {
    const std::string path = shape.artwork.path + " (thumbnail)";
    const DrawnColours drawn =
        drawn_colours(drawers.decode_png(shape.artwork.thumbnail_png, path, kThumbnailSide_px), shape);
    const auto is_drawn_on = [](double part) { return part > 0; };
    // A drawing may be smaller than a pixel on its page.
    return std::any_of(drawn.part.begin(), drawn.part.end(), is_drawn_on) ? drawn : drawn_colours(shape);
  } catch (const InputError&) {
    return drawn_colours(shape);  // the drawing of the picture reports the error
  }
}

}  // namespace

DrawnColours drawn_colours(const cv::Mat& bgra, const Shape& shape) {
  const Sprite sprite = sprite_of_drawing(bgra, shape, shape.outline);
  const Similarity shape_from_sprite =
      scaled(artwork_from_shape(shape.artwork), float(sprite.px_per_artwork_px)).inverse();
  const Extent box = extent_of(shape.outline.curves.front(), {1, 0, 0, 0});
  const float side = shape.artwork.mirrored ? -1 : 1;
  OfCells<cv::Vec4d> sums{};
  OfCells<double> pixels{};
  for (int y = 0; y < sprite.bgra.rows; ++y) {
    for (int x = 0; x < sprite.bgra.cols; ++x) {
      const Vec2 drawn = shape_from_sprite.apply({float(x) + 0.5f, float(y) + 0.5f});
      const Vec2 at{side * drawn.x, drawn.y};
      if (at.x < box.low.x || at.x >= box.high.x || at.y < box.low.y || at.y >= box.high.y) continue;
      const auto cell =
          std::size_t(cell_along(at.y, box.low.y, box.high.y) * kColourSide + cell_along(at.x, box.low.x, box.high.x));
      sums[cell] += cv::Vec4d(sprite.bgra.at<cv::Vec4b>(y, x));
      pixels[cell] += 1;
    }
  }
  DrawnColours colours;
  for (std::size_t cell = 0; cell < kColourCells; ++cell) {
    const cv::Vec4d& sum = sums[cell];
    if (sum[3] > 0) colours.bgr[cell] = cv::Vec3d(sum[0], sum[1], sum[2]) * (255 / sum[3]);
    if (pixels[cell] > 0) colours.part[cell] = sum[3] / 255 / pixels[cell];
  }
  return colours;
}

DrawnColours drawn_colours(const Shape& shape) {
  DrawnColours colours;
  const bool known = shape.colour_grid.known();
  const cv::Vec3d mean = cv::Vec3d(mean_bgr(shape));
  for (std::size_t cell = 0; cell < kColourCells; ++cell) {
    const std::uint8_t* bytes = shape.colour_grid.bytes.data() + 4 * cell;
    const Lab lab{float(bytes[0]) / 2.55f, float(bytes[1]) - 128, float(bytes[2]) - 128};
    colours.bgr[cell] = known ? cv::Vec3d(bgr_of(lab)) : mean;
    colours.part[cell] = known ? bytes[3] / 255. : 1;
  }
  return colours;
}

std::vector<DrawnColours> drawn_colours(const PlacedShapes& shapes, Drawers& drawers) {
  std::vector<DrawnColours> colours(shapes.size());
  parallel_for(shapes.size(), [&](std::size_t slot) { colours[slot] = of_thumbnail(shapes[slot], drawers); });
  return colours;
}

}  // namespace tessera
