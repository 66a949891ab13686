// The cost of wrong colours. Improving adds it to the free area, so that it does not buy coverage with wrong colours.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "core/collage/placement.h"
#include "core/colour/colour_wish.h"
#include "core/shape/shape_source.h"

namespace tessera::master {

class OffColour {
 public:
  /// `shapes` outlives it.
  OffColour(const ColourWish& wish, ShapeSource& shapes) : wish_(wish), shapes_(shapes) {}

  /// The sum of area times colour difference over the pieces, in 256ths of px² of free canvas that cost as much. 0 without
  /// a wish for colours. It is a whole number, so the order of the pieces does not matter.
  std::int64_t loss_256ths_px2(const std::vector<Placement>& placements);

 private:
  using PosedShapeKey = std::array<std::uint32_t, 5>;  // shape and the bits of its pose
  std::int64_t loss_of(const Placement& placement) const;

  ColourWish wish_;
  ShapeSource& shapes_;
  std::map<PosedShapeKey, std::int64_t> losses_;  // of the pieces of the last call, most of which stay
};

}  // namespace tessera::master
