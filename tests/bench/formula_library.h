// A library file of formula shapes in a temporary folder.
#pragma once

#include "bench/inputs/formula_shapes.h"
#include "library/storage/library_file.h"
#include "support/scratch_folder.h"

namespace tessera::test {

class FormulaLibrary {
 public:
  explicit FormulaLibrary(std::size_t count) : path_(folder_.path("blobs.h5")) {
    LibraryWriter writer(path_, PadParameters{});
    std::size_t number = 0;
    for (Shape& shape : bench::blob_shapes(count)) {
      shape.name = "blob " + std::to_string(number++);
      shape.artwork.width_px = shape.artwork.height_px = 600;
      writer.append(shape);
    }
    writer.finish();
  }

  const std::string& path() const { return path_; }

 private:
  ScratchFolder folder_;
  std::string path_;
};

}  // namespace tessera::test
