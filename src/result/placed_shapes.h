// The shapes of a library that were placed, each once, and the way from a piece to its shape.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/stop.h"
#include "core/collage/placement.h"
#include "core/shape/shape.h"
#include "core/shape/shape_id.h"
#include "library/storage/shape_library.h"

namespace tessera {

class PlacedShapes {
 public:
  /// Adds a shape. `id`: in the library; it must be new.
  void add(ShapeId id, Shape shape);
  /// Adds a shape with a drawing of its own, even where another shape has its name.
  void add_apart(ShapeId id, Shape shape);

  std::size_t size() const { return shapes_.size(); }
  Shape& operator[](std::size_t slot) { return shapes_[slot]; }
  const Shape& operator[](std::size_t slot) const { return shapes_[slot]; }
  std::vector<std::string> names() const;
  auto begin() const { return shapes_.begin(); }
  auto end() const { return shapes_.end(); }

  /// The place of the shape in the order in which shapes were added. Throws std::out_of_range where it was not added.
  std::size_t slot_of(ShapeId id) const;
  /// The first place of a shape with the same drawing. A shape and its mirror image have the same name and drawing.
  std::size_t slot_of_drawing(std::size_t slot) const;

 private:
  std::vector<Shape> shapes_;
  std::unordered_map<ShapeId, std::size_t> slot_of_;
  std::unordered_map<std::string, std::size_t> slot_as_drawn_;  // by name, of shapes that are no mirror images
};

/// A text for each placement. `of_shapes` has a text for each of the shapes, in their order.
std::vector<std::string> of_placements(const std::vector<std::string>& of_shapes, const PlacedShapes& shapes,
                                       const std::vector<Placement>& placements);

/// Reads these parts of the placed shapes, one after the other, in the order of the library. Calls `check_stop`, which may
/// throw, before each shape.
PlacedShapes read_placed_shapes(const ShapeLibrary& library, const std::vector<Placement>& placements,
                                const LibraryParts& parts, const StopCheck& check_stop = never_stop);

}  // namespace tessera
