#include "core/replacing/repetition.h"

#include <algorithm>

#include "core/base/portable_math.h"

namespace tessera {
namespace {

template <class Areas>
auto place_of(Areas& drawn, ShapeId drawing) {
  return std::lower_bound(drawn.begin(), drawn.end(), drawing,
                          [](const DrawingArea& a, ShapeId id) { return a.drawing < id; });
}

}  // namespace

double repeated_px2(double area_px2, double even_share_px2) {
  return area_px2 > 0 ? area_px2 * (portable_log(area_px2 / even_share_px2) - 1) : 0;
}

Repetition::Repetition(const ReplacementWindow& window)
    : cost_(double(window.repetition_cost)),
      even_share_px2_(window.even_share_px2),
      drawn_(window.drawn) {}

double Repetition::area_px2(ShapeId drawing) const {
  const auto found = place_of(drawn_, drawing);
  return found == drawn_.end() || found->drawing != drawing ? 0 : found->area_px2;
}

double Repetition::cost_px2(ShapeId drawing, double scale_px) const {
  const double before_px2 = area_px2(drawing);
  const double after_px2 = before_px2 + scale_px * scale_px;
  return cost_ * (repeated_px2(after_px2, even_share_px2_) - repeated_px2(before_px2, even_share_px2_));
}

void Repetition::change(ShapeId drawing, double by_px2) {
  auto found = place_of(drawn_, drawing);
  if (found == drawn_.end() || found->drawing != drawing) found = drawn_.insert(found, {drawing, 0});
  const double before_px2 = found->area_px2;
  found->area_px2 += by_px2;
  energy_px2_ += cost_ * (repeated_px2(found->area_px2, even_share_px2_) - repeated_px2(before_px2, even_share_px2_));
}

}  // namespace tessera
