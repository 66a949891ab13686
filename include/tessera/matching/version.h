/// @file
/// The version of the library, by semantic versioning. While the first number is 0, a new second number may change the
/// interface; from 1.0 on only a new first number does.
#pragma once

#include "tessera/matching/export.h"

namespace tessera::matching {

/// The version of the library that the program runs with, such as "0.1.0".
TESSERA_MATCHING_API const char* version();

}  // namespace tessera::matching
