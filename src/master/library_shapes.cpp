#include "master/library_shapes.h"

namespace tessera::master {
namespace {

constexpr io::LibraryParts kBody{.outline = true, .field = true, .levels = 0, .artwork = false, .original = false};
constexpr io::LibraryParts kContour{.outline = true, .field = false, .levels = 0, .artwork = false, .original = false};

}  // namespace

Shape LibraryShapes::load(std::uint32_t index) { return std::move(library_.read(index, index + 1, kBody).front()); }

ShapeContour LibraryShapes::load_contour(std::uint32_t index) {
  Shape shape = std::move(library_.read(index, index + 1, kContour).front());
  return {std::move(shape.outline), shape.perimeter, shape.radius};
}

}  // namespace tessera::master
