// The shapes of a library that were placed, each once, and found by what a piece says of its own.
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
  /// `id`: in the library, of a shape that is not there yet.
  void add(ShapeId id, Shape shape);
  /// The same with a drawing of its own, whatever its name.
  void add_apart(ShapeId id, Shape shape);

  std::size_t size() const { return shapes_.size(); }
  Shape& operator[](std::size_t slot) { return shapes_[slot]; }
  const Shape& operator[](std::size_t slot) const { return shapes_[slot]; }
  std::vector<std::string> names() const;
  auto begin() const { return shapes_.begin(); }
  auto end() const { return shapes_.end(); }

  /// The place of the shape in the order in which they were added. Throws std::out_of_range where it is not there.
  std::size_t slot_of(ShapeId id) const;
  /// The first place of what has the same drawing: a shape and its mirror image, of one name, have one.
  std::size_t slot_of_drawing(std::size_t slot) const;

 private:
  std::vector<Shape> shapes_;
  std::unordered_map<ShapeId, std::size_t> slot_of_;
  std::unordered_map<std::string, std::size_t> slot_as_drawn_;  // by name, of shapes that are no mirror images
};

/// For each placement what is said of its shape; `of_shapes` has a text for each of the shapes, in their order.
std::vector<std::string> of_placements(const std::vector<std::string>& of_shapes, const PlacedShapes& shapes,
                                       const std::vector<Placement>& placements);

/// Those parts of the shapes, one after the other, by their place in the library; before each `check_stop` is called and may
/// throw.
PlacedShapes read_placed_shapes(const ShapeLibrary& library, const std::vector<Placement>& placements,
                                const LibraryParts& parts, const StopCheck& check_stop = never_stop);

}  // namespace tessera
