// Reads instances of strip packing in the format of sparrow and jagua-rs: JSON with name, items (id, demand,
// allowed_orientations in degrees, shape) and strip_height or a bin; and layouts in the same format.
#pragma once

#include <string>
#include <string_view>

#include "products/nesting/nest_input.h"

namespace tessera {

/// Lengths count as mm. Throws InputError that names `path` and the item.
NestInput nest_instance(std::string_view json, const std::string& path);

}  // namespace tessera
