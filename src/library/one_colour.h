// Recognises a library of silhouettes, drawn in one colour that tells nothing about them.
#pragma once

#include "library/storage/shape_library.h"

namespace tessera {

/// Whether nearly all shapes have one colour each, and all the same one. False for libraries of older versions, which do
/// not know. Throws as ShapeLibrary::read().
bool is_of_one_colour(const ShapeLibrary& library);

}  // namespace tessera
