// The shapes that the master places, read from the library file as they are needed.
#pragma once

#include <list>
#include <unordered_map>

#include "core/shape_source.h"
#include "io/library/library_file.h"

namespace tessera::master {

/// Keeps the models of all shapes asked for (4 KB each) and the latest few whole shapes (80 KB each): a library of any
/// size fits. What is kept never changes what is answered.
class LibraryShapes : public ShapeSource {
 public:
  explicit LibraryShapes(const io::LibraryFile& library) : library_(library) {}

  const Shape& shape(std::uint32_t index) override;
  const ShapeModel& model(std::uint32_t index) override;

 private:
  struct Kept {
    std::uint32_t index;
    Shape shape;
  };

  const io::LibraryFile& library_;
  std::list<Kept> recent_;  // latest first
  std::unordered_map<std::uint32_t, std::list<Kept>::iterator> position_;
  std::unordered_map<std::uint32_t, ShapeModel> models_;
};

}  // namespace tessera::master
