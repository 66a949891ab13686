#include "core/nesting/column_layout.h"

#include <algorithm>
#include <cmath>

#include "core/nesting/nest_scene.h"

namespace tessera {
namespace {

struct Boxed {
  int item = 0;
  int angle = 0;
  NestPoint corner;  // the shift that puts the box into the corner of the material
  double width = 0, height = 0;
};

/// At the angle at which its box is smallest, of equals the narrowest.
Boxed boxed(const NestScene& material, int item) {
  Boxed best;
  bool any = false;
  for (int angle = 0; angle < material.angles_of(item); ++angle) {
    const PosedShape& shape = material.shape(item, angle);
    if (!material.fits(shape)) continue;
    const Boxed here{item, angle, material.range(shape).low, shape.own_box.width(), shape.own_box.height()};
    const double area = here.width * here.height, least = best.width * best.height;
    if (any && (area > least || (area == least && here.width >= best.width))) continue;
    best = here;
    any = true;
  }
  return best;
}

}  // namespace

void add_in_columns(const NestProblem& problem, const PosedItems& shapes, const std::vector<int>& items, double from,
                    NestLayout& layout) {
  if (items.empty()) return;
  NestScene material(shapes, problem.height, problem.spacing);
  material.set_length(problem.length);
  std::vector<Boxed> boxes;
  for (const int item : items) boxes.push_back(boxed(material, item));
  std::stable_sort(boxes.begin(), boxes.end(), [](const Boxed& a, const Boxed& b) { return a.width > b.width; });
  NestPoint at{from, 0};
  double column_end = from;
  layout.used_length = from;
  for (const Boxed& box : boxes) {
    if (at.y > 0 && at.y + box.height > problem.height) at = {column_end + problem.spacing, 0};
    if (at.x > 0 && at.x + box.width > problem.length) {
      ++layout.sheets;
      layout.used_length = 0;
      at = {};
    }
    layout.pieces.push_back({box.item, box.angle, box.corner + at, layout.sheets});
    column_end = at.y > 0 ? column_end : at.x + box.width;
    layout.used_length = std::max(layout.used_length, at.x + box.width);
    at.y += box.height + problem.spacing;
  }
  ++layout.sheets;
}

}  // namespace tessera
