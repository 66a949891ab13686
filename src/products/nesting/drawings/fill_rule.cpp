#include "products/nesting/drawings/fill_rule.h"

#include "products/nesting/drawings/nest_contours.h"

namespace tessera {

std::vector<bool> ends_fill(const std::vector<NestRing>& contours, bool even_odd) {
  std::vector<bool> ends(contours.size(), true);
  if (even_odd || contours.size() < 2) return ends;
  std::vector<RingRows> rows(contours.begin(), contours.end());
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const auto turns = [&](std::size_t contour) { return signed_area(contours[contour]) > 0 ? 1 : -1; };
    int winding_outside = 0;
    for (std::size_t j = 0; j < contours.size(); ++j) {
      if (j != i && holds(rows[j].box(), rows[i].box()) && lies_in(contours[i], rows[j])) winding_outside += turns(j);
    }
    ends[i] = (winding_outside == 0) != (winding_outside + turns(i) == 0);
  }
  return ends;
}

}  // namespace tessera
