#include "bench/inputs/enlarged_library.h"

#include <algorithm>

#include "bench/inputs/varied_shapes.h"

namespace tessera::bench {
namespace {

constexpr std::uint32_t kShapesInAPart = 512;  // whole shapes, 80 KB each

/// The artwork of a missing drawing: a page with the shape in its middle.
Artwork blank_page() {
  constexpr int kSide_px = 600;
  Artwork artwork;
  artwork.width_px = artwork.height_px = kSide_px;
  artwork.centroid_px = {kSide_px / 2, kSide_px / 2};
  artwork.unit_px = kSide_px / 4;
  return artwork;
}

}  // namespace

void write_library_of_size(const LibraryFile& library, std::uint32_t count, const std::string& path) {
  const VariedShapes varied(library);
  LibraryWriter writer(path, library.pad_parameters());
  for (std::uint32_t begin = 0; begin < count; begin += kShapesInAPart) {
    const ShapeRange part{begin, std::min(count, begin + kShapesInAPart)};
    std::uint32_t number = begin;
    for (Shape& shape : varied.shapes(part)) {
      shape.name = "shape " + std::to_string(number++);
      shape.artwork = blank_page();
      writer.append(shape);
    }
  }
  writer.finish();
}

}  // namespace tessera::bench
