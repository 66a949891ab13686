// A shape as bytes, sent between two processes of the same program. It is no file format: see library_file.h.
#pragma once

#include <string>
#include <string_view>

#include "core/shape/shape.h"

namespace tessera {

std::string encode_shape(const Shape& shape);

/// Throws std::runtime_error where the bytes are not from encode_shape.
Shape decode_shape(std::string_view bytes);

}  // namespace tessera
