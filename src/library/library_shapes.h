// Shapes read from the library file as they are needed, for code that places them or tries where they fit.
#pragma once

#include <cstdint>
#include <vector>

#include "core/shape/cached_shapes.h"
#include "library/storage/shape_library.h"

namespace tessera {

class LibraryShapes : public CachedShapes {
 public:
  /// Throws InputError where the library is damaged.
  explicit LibraryShapes(const ShapeLibrary& library)
      : library_(library),
        variant_of_(library.variant_of()),
        drawings_(library.drawings()) {}

  ShapeId silhouette(ShapeId id) const override { return ShapeId(variant_of_[index_of(id)]); }
  ShapeId drawing(ShapeId id) const override { return ShapeId(drawings_[index_of(id)]); }

 protected:
  Shape load(ShapeId id) override;

 private:
  const ShapeLibrary& library_;
  const std::vector<std::uint32_t> variant_of_;
  const std::vector<std::uint32_t> drawings_;
};

}  // namespace tessera
