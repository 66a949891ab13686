// The shapes that the master places, read from the library file as they are needed.
#pragma once

#include "io/library/library_file.h"
#include "master/cached_shapes.h"

namespace tessera::master {

class LibraryShapes : public CachedShapes {
 public:
  explicit LibraryShapes(const io::LibraryFile& library) : library_(library) {}

 protected:
  Shape load(ShapeId id) override;

 private:
  const io::LibraryFile& library_;
};

}  // namespace tessera::master
