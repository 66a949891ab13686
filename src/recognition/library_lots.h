// Prepares the shapes of a library file for recognition, lot by lot. The same lots give the same answers, whoever searches
// them.
#pragma once

#include <vector>

#include "core/recognition/known_shapes.h"
#include "core/recognition/recognition.h"
#include "library/storage/shape_library.h"

namespace tessera {

/// Smoothing levels that are searched. The coarsest level says too little about parts.
inline const std::vector<int> kSearchedLevels = {1, 2, 3, 4};

/// The number of shapes in a lot: an eighth of the library, between 2,048 and 16,384. A search in eight times as many
/// shapes takes two to three times as long, so large lots save time. But a lot is one rank's work, takes about 80 KB of
/// memory for each shape, and misses a few more hard queries, because only the nearest PADs of each lot are tried.
std::uint32_t shapes_of_lot(std::size_t library_shapes);

/// The lots of a library, with `lot_shapes` shapes each; the last one may have fewer.
std::vector<ShapeRange> lots_of(std::size_t library_shapes, std::uint32_t lot_shapes);

/// Reads and prepares a lot. Throws as ShapeLibrary::read().
KnownShapes read_lot(const ShapeLibrary& library, const ShapeRange& range);

/// Merges answers of another lot and keeps the `most` best.
void keep_best(std::vector<Recognition>& best, const std::vector<Recognition>& more, std::size_t most);

}  // namespace tessera
