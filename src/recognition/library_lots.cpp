#include "recognition/library_lots.h"

#include <algorithm>

#include "library/storage/shape_models.h"

namespace tessera {

std::uint32_t shapes_of_lot(std::size_t library_shapes) {
  constexpr std::size_t kLeast = 2048, kMost = 16384, kLots = 8;
  return std::uint32_t(std::clamp((library_shapes + kLots - 1) / kLots, kLeast, kMost));
}

std::vector<ShapeRange> lots_of(std::size_t library_shapes, std::uint32_t lot_shapes) {
  std::vector<ShapeRange> lots;
  for (std::size_t begin = 0; begin < library_shapes; begin += lot_shapes) {
    lots.push_back({std::uint32_t(begin), std::uint32_t(std::min(library_shapes, begin + lot_shapes))});
  }
  return lots;
}

KnownShapes read_lot(const ShapeLibrary& library, const ShapeRange& range) {
  MatchingContext context;
  context.pad = library.pad_parameters();
  context.levels = kSearchedLevels;
  context.library_shapes = std::uint32_t(library.size());
  std::vector<float> drawn_scales_px;
  for (const Shape& head :
       library.read(range.begin, range.end, {.outline = false, .field = false, .levels = 0, .artwork = false})) {
    drawn_scales_px.push_back(head.drawn_scale_px);
  }
  return KnownShapes(ShapeId(range.begin), models_of(library, context)->models(range, {}), std::move(drawn_scales_px),
                     context.pad.levels);
}

void keep_best(std::vector<Recognition>& best, const std::vector<Recognition>& more, std::size_t most) {
  best.insert(best.end(), more.begin(), more.end());
  std::sort(best.begin(), best.end());
  if (best.size() > most) best.resize(most);
}

}  // namespace tessera
