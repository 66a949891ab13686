// The cost of wrong colours: improving adds it to what is free, so that it does not buy coverage with colours.
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

  /// The sum over the pieces of area times difference, in px² of free canvas that cost as much; 0 without a wish. In
  /// whole numbers: the same in any order of the pieces.
  std::int64_t loss_256ths_px2(const std::vector<Placement>& placements);

 private:
  using Lying = std::array<std::uint32_t, 5>;  // shape and the bits of its pose
  std::int64_t loss_of(const Placement& placement) const;

  ColourWish wish_;
  ShapeSource& shapes_;
  std::map<Lying, std::int64_t> losses_;  // of the pieces that were asked for last: most of them stay
};

}  // namespace tessera::master
