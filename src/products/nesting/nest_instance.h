// Instances of strip packing as sparrow and jagua-rs have them: JSON with name, items (id, demand, allowed_orientations in
// degrees, shape) and strip_height or a bin; and layouts in the same manner.
#pragma once

#include <string>
#include <string_view>

#include "products/nesting/nest_input.h"

namespace tessera {

/// Lengths count as mm. Throws InputError, naming `path` and the item.
NestInput nest_instance(std::string_view json, const std::string& path);

}  // namespace tessera
