#include "result/placed_shapes.h"

#include <set>
#include <stdexcept>
#include <utility>

#include "core/base/stop.h"

namespace tessera {

void PlacedShapes::add(ShapeId id, Shape shape) {
  slot_of_.emplace(id, shapes_.size());
  if (!shape.artwork.mirrored) slot_as_drawn_.emplace(shape.name, shapes_.size());
  shapes_.push_back(std::move(shape));
}

void PlacedShapes::add_apart(ShapeId id, Shape shape) {
  slot_of_.emplace(id, shapes_.size());
  shapes_.push_back(std::move(shape));
}

std::vector<std::string> PlacedShapes::names() const {
  std::vector<std::string> names;
  for (const Shape& shape : shapes_) names.push_back(shape.name);
  return names;
}

std::size_t PlacedShapes::slot_of(ShapeId id) const {
  const auto found = slot_of_.find(id);
  if (found == slot_of_.end()) {
    throw std::out_of_range("shape " + std::to_string(index_of(id)) + " is not among those that were placed");
  }
  return found->second;
}

std::size_t PlacedShapes::slot_of_drawing(std::size_t slot) const {
  if (!shapes_[slot].artwork.mirrored) return slot;
  const auto drawn = slot_as_drawn_.find(shapes_[slot].name);
  return drawn == slot_as_drawn_.end() ? slot : drawn->second;
}

std::vector<std::string> of_placements(const std::vector<std::string>& of_shapes, const PlacedShapes& shapes,
                                       const std::vector<Placement>& placements) {
  std::vector<std::string> texts;
  for (const Placement& placement : placements) texts.push_back(of_shapes[shapes.slot_of(placement.shape)]);
  return texts;
}

PlacedShapes read_placed_shapes(const ShapeLibrary& library, const std::vector<Placement>& placements,
                                const LibraryParts& parts, const StopCheck& check_stop) {
  std::set<ShapeId> placed;
  for (const Placement& placement : placements) placed.insert(placement.shape);
  PlacedShapes shapes;
  for (const ShapeId id : placed) {
    check_stop();
    const std::uint32_t index = index_of(id);
    shapes.add(id, std::move(library.read(index, index + 1, parts).front()));
  }
  return shapes;
}

}  // namespace tessera
