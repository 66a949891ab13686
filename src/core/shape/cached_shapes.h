// A cache in front of a source of shapes that are expensive to get: read from a file, or computed.
#pragma once

#include <list>
#include <memory>
#include <unordered_map>

#include "core/shape/shape_source.h"

namespace tessera {

/// Keeps the models of requested shapes (4 KB each) and the most recent whole shapes (80 KB each), so that a library of
/// any size can be used. The cache never changes the answers.
class CachedShapes : public ShapeSource {
 public:
  const Shape& shape(ShapeId id) override { return *recent(id); }
  std::shared_ptr<const Shape> hold(ShapeId id) override { return recent(id); }
  const ShapeModel& model(ShapeId id) override;

 protected:
  /// Gets the shape with outline and field.
  virtual Shape load(ShapeId id) = 0;

 private:
  struct Kept {
    ShapeId id;
    std::shared_ptr<const Shape> shape;
  };
  const std::shared_ptr<const Shape>& recent(ShapeId id);

  std::list<Kept> recent_;  // most recent first
  std::unordered_map<ShapeId, std::list<Kept>::iterator> position_;
  std::unordered_map<ShapeId, ShapeModel> models_;
};

}  // namespace tessera
