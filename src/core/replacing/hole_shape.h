// The data of a library shape that replacement needs: its contacts, and the points where it can dock to the rim of a
// hole. Shape frame.
#pragma once

#include <vector>

#include "core/relax/contact_shape.h"
#include "core/shape/shape.h"

namespace tessera {

/// A point of the outer boundary at which the shape may dock.
struct DockPoint {
  Vec2 at;
  Vec2 inward;          // unit
  float thickness = 0;  // length of the way through the shape from here inward
};

struct HoleShape {
  ContactShape contact;
  std::vector<DockPoint> docks;
  std::vector<Vec2> interior;  // points of an even grid
};

/// Uses outline, field, perimeter and radius of `shape`.
HoleShape make_hole_shape(const Shape& shape);

}  // namespace tessera
