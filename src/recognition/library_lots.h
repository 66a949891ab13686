// Shapes of a library file, made ready for recognition in lots: whoever searches a library lot by lot finds the same.
#pragma once

#include <vector>

#include "core/recognition/known_shapes.h"
#include "core/recognition/recognition.h"
#include "library/storage/shape_library.h"

namespace tessera {

/// Smoothing levels that are searched. The coarsest says too little of parts.
inline const std::vector<int> kSearchedLevels = {1, 2, 3, 4};

/// Lot number `lot` of so many shapes each; the last one may have fewer.
ShapeRange lot_of(const ShapeLibrary& library, std::size_t lot, std::uint32_t lot_shapes);
std::size_t number_of_lots(const ShapeLibrary& library, std::uint32_t lot_shapes);

/// Throws as ShapeLibrary::read().
KnownShapes read_lot(const ShapeLibrary& library, const ShapeRange& range);

/// Keeps the `most` best of what several lots gave.
void keep_best(std::vector<Recognition>& best, const std::vector<Recognition>& more, std::size_t most);

}  // namespace tessera
