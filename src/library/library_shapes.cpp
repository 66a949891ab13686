#include "library/library_shapes.h"

#include "core/base/error.h"
#include "core/shape/shape_contradiction.h"

namespace tessera {
namespace {

constexpr LibraryParts kBody{.outline = true, .field = true, .levels = 0, .artwork = false, .original = false};

}  // namespace

Shape LibraryShapes::load(ShapeId id) {
  const std::uint32_t index = index_of(id);
  Shape shape = std::move(library_.read(index, index + 1, kBody).front());
  const std::string contradiction = shape_contradiction(shape);
  if (!contradiction.empty()) {
    throw InputError(library_.path() + ": damaged: shape " + std::to_string(index) + ": " + contradiction +
                     "; build it again with tessera library build");
  }
  return shape;
}

}  // namespace tessera
