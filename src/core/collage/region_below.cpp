#include "core/collage/region_below.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/field/field_lookup.h"
#include "core/geometry/rasterise.h"

namespace tessera {

std::uint32_t region_below(const Canvas& canvas, const Outline& outline, const Similarity& canvas_from_shape) {
  std::vector<FieldView> regions;
  for (const CanvasRegion& region : canvas.regions) regions.emplace_back(region.distance);
  std::vector<std::size_t> cells(std::max<std::size_t>(1, regions.size()), 0);
  // This many cells across are enough to find the region with the largest part of a piece of any size.
  constexpr float kCellsAcross = 256;
  const int step = std::max(1, int(canvas_from_shape.scale() / kCellsAcross));
  for (const Span& span : fill_spans(outline, canvas_from_shape, {0, 0, canvas.width_px, canvas.height_px})) {
    if (span.y % step != 0) continue;
    for (int x = span.x0 + (step - span.x0 % step) % step; x < span.x1; x += step) {
      const Vec2 middle_px{float(x) + 0.5f, float(span.y) + 0.5f};
      for (std::size_t r = 0; r < regions.size(); ++r) cells[r] += field_value(regions[r], middle_px) > 0;
    }
  }
  return std::uint32_t(std::max_element(cells.begin(), cells.end()) - cells.begin());
}

}  // namespace tessera
