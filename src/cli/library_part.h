// The part of the library that one rank matches.
#pragma once

#include <cstddef>

#include "core/matching/matcher.h"

namespace tessera::cli {

/// Part `part` of `parts`; every shape has as many samples, so the parts have as many shapes, give or take one.
ShapeRange library_part(std::size_t shapes, int part, int parts);

}  // namespace tessera::cli
