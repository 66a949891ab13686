// Where the master gets the shapes that it places: one at a time, as they are needed.
#pragma once

#include <cstdint>

#include "core/shape.h"
#include "core/shape_model.h"

namespace tessera {

/// What it takes to score a candidate. Cheap to get, unlike the field, of which a library file has 32 KB a shape.
struct ShapeContour {
  Outline outline;
  float perimeter = 0;
  float radius = 0;
};

class ShapeSource {
 public:
  virtual ~ShapeSource() = default;
  /// With outline and field. Valid until the next call.
  virtual const Shape& shape(std::uint32_t index) = 0;
  /// Valid as long as the source.
  virtual const ShapeContour& contour(std::uint32_t index) = 0;
  /// Without PADs. Valid as long as the source.
  virtual const ShapeModel& model(std::uint32_t index) = 0;
};

}  // namespace tessera
