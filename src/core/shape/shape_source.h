// A source of shapes for ranks that place or try them: it gives one at a time, when it is needed.
#pragma once

#include <memory>

#include "core/shape/shape.h"
#include "core/shape/shape_id.h"
#include "core/shape/shape_model.h"

namespace tessera {

class ShapeSource {
 public:
  virtual ~ShapeSource() = default;
  /// The shape with outline and field, valid until the next call.
  virtual const Shape& shape(ShapeId id) = 0;
  /// The same shape, valid as long as the caller holds it: for work on several shapes at a time.
  virtual std::shared_ptr<const Shape> hold(ShapeId id) { return std::make_shared<Shape>(shape(id)); }
  /// The shape's model without PADs, valid as long as the source.
  virtual const ShapeModel& model(ShapeId id) = 0;
  /// The first shape with this silhouette: shapes that differ only by their colours repeat each other.
  virtual ShapeId silhouette(ShapeId id) const { return id; }
  /// The shape whose mirror image this one is, or the shape itself. Both count as one drawing.
  virtual ShapeId drawing(ShapeId id) const { return id; }
};

}  // namespace tessera
