// What replacing needs of a library shape: contacts, and where it can dock to the rim of a hole. Shape frame.
#pragma once

#include <vector>

#include "core/relax/contact_shape.h"
#include "core/shape/shape.h"

namespace tessera {

/// A point of the outer boundary.
struct DockPoint {
  Vec2 at;
  Vec2 inward;          // unit
  float thickness = 0;  // way through the shape from here inward
};

struct HoleShape {
  ContactShape contact;
  std::vector<DockPoint> docks;
  std::vector<Vec2> interior;  // an even grid
};

/// Of `shape` it needs outline, field, perimeter and radius.
HoleShape make_hole_shape(const Shape& shape);

}  // namespace tessera
