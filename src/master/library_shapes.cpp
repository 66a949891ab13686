#include "master/library_shapes.h"

namespace tessera::master {
namespace {

constexpr io::LibraryParts kBody{.outline = true, .field = true, .levels = 0, .artwork = false, .original = false};

}  // namespace

Shape LibraryShapes::load(std::uint32_t index) { return std::move(library_.read(index, index + 1, kBody).front()); }

}  // namespace tessera::master
