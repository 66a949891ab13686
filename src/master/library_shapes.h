// The shapes that the master places, read from the library file as they are needed.
#pragma once

#include <cstdint>
#include <vector>

#include "io/library/shape_library.h"
#include "master/cached_shapes.h"

namespace tessera::master {

class LibraryShapes : public CachedShapes {
 public:
  /// Throws InputError where the library is damaged.
  explicit LibraryShapes(const io::ShapeLibrary& library)
      : library_(library),
        variant_of_(library.variant_of()),
        drawings_(library.drawings()) {}

  ShapeId silhouette(ShapeId id) const override { return ShapeId(variant_of_[index_of(id)]); }
  ShapeId drawing(ShapeId id) const override { return ShapeId(drawings_[index_of(id)]); }

 protected:
  Shape load(ShapeId id) override;

 private:
  const io::ShapeLibrary& library_;
  const std::vector<std::uint32_t> variant_of_;
  const std::vector<std::uint32_t> drawings_;
};

}  // namespace tessera::master
