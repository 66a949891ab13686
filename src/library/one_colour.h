// Whether a library is one of silhouettes: cut of one colour, which says nothing about them.
#pragma once

#include "library/storage/shape_library.h"

namespace tessera {

/// Nearly all shapes are of one colour each, and all of these of the same. What libraries of older versions do not know
/// counts as no. Throws as ShapeLibrary::read().
bool is_of_one_colour(const ShapeLibrary& library);

}  // namespace tessera
