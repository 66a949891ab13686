// A shape as bytes, for the way between two processes of the same program. Not a file format: see library_file.h.
#pragma once

#include <string>
#include <string_view>

#include "core/shape/shape.h"

namespace tessera {

std::string encode_shape(const Shape& shape);

/// Throws std::runtime_error where the bytes are not what encode_shape gave.
Shape decode_shape(std::string_view bytes);

}  // namespace tessera
