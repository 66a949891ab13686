// Where ranks get the shapes that they place, or try: one at a time, as they are needed.
#pragma once

#include "core/shape/shape.h"
#include "core/shape/shape_id.h"
#include "core/shape/shape_model.h"

namespace tessera {

class ShapeSource {
 public:
  virtual ~ShapeSource() = default;
  /// The shape with outline and field. It is valid until the next call.
  virtual const Shape& shape(ShapeId id) = 0;
  /// The shape's model without PADs. It is valid as long as the source.
  virtual const ShapeModel& model(ShapeId id) = 0;
  /// The first shape with this silhouette: shapes that differ by their colours alone repeat each other.
  virtual ShapeId silhouette(ShapeId id) const { return id; }
  /// The shape that this one is the mirror image of: they are one drawing, and used as one. Mostly itself.
  virtual ShapeId drawing(ShapeId id) const { return id; }
};

}  // namespace tessera
