#include "recognition/library_lots.h"

#include <algorithm>

#include "library/storage/shape_models.h"

namespace tessera {

ShapeRange lot_of(const ShapeLibrary& library, std::size_t lot, std::uint32_t lot_shapes) {
  const std::size_t begin = lot * lot_shapes;
  return {std::uint32_t(begin), std::uint32_t(std::min(library.size(), begin + lot_shapes))};
}

std::size_t number_of_lots(const ShapeLibrary& library, std::uint32_t lot_shapes) {
  return (library.size() + lot_shapes - 1) / lot_shapes;
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
