// Writes quickly a library file of many shapes, of which no two have equal models.
#pragma once

#include "library/storage/library_file.h"
#include "support/matching_scene.h"

namespace tessera::test {

/// Repeats a few outlines with other perimeters.
inline void write_many_shapes(const std::string& path, std::uint32_t count) {
  const std::vector<Shape> some = formula_shapes(6, PadParameters());
  LibraryWriter writer(path, PadParameters());
  for (std::uint32_t i = 0; i < count; ++i) {
    Shape shape = some[i % some.size()];
    shape.name = "shape " + std::to_string(i);
    shape.artwork.width_px = shape.artwork.height_px = 600;
    shape.mean_lab = {50, 10, -20};
    shape.drawn_scale_px = 20 + float(i % 30);
    shape.perimeter *= 1 + float(i) / float(count);  // makes the models different
    writer.append(shape);
  }
  writer.finish();
}

}  // namespace tessera::test
