// Says in words why a file gives no shape.
#pragma once

#include <string>

#include "core/shape/outline.h"

namespace tessera {

/// The reason, and what the user can do about it, for messages and tables.
std::string skip_reason_text(SkipReason reason);

}  // namespace tessera
