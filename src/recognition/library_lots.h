// Shapes of a library file, made ready for recognition in lots: whoever searches a library lot by lot finds the same.
#pragma once

#include <vector>

#include "core/recognition/known_shapes.h"
#include "core/recognition/recognition.h"
#include "library/storage/shape_library.h"

namespace tessera {

/// Smoothing levels that are searched. The coarsest says too little of parts.
inline const std::vector<int> kSearchedLevels = {1, 2, 3, 4};

/// How many shapes a lot has: an eighth of the library, but 2,048 at least and 16,384 at most. A look-up in eight times as many
/// shapes takes two to three times as long, so large lots save time; but a lot is one rank's work, takes about 80 KB of
/// memory for each shape, and of hard queries a few more are missed, as of each lot the nearest PADs are tried.
std::uint32_t shapes_of_lot(std::size_t library_shapes);

/// The lots of a library, of `lot_shapes` each; the last one may have fewer.
std::vector<ShapeRange> lots_of(std::size_t library_shapes, std::uint32_t lot_shapes);

/// Throws as ShapeLibrary::read().
KnownShapes read_lot(const ShapeLibrary& library, const ShapeRange& range);

/// Keeps the `most` best of what several lots gave.
void keep_best(std::vector<Recognition>& best, const std::vector<Recognition>& more, std::size_t most);

}  // namespace tessera
