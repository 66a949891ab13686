// Why a file gives no shape, in words for its owner.
#pragma once

#include <string>

#include "core/shape/outline.h"

namespace tessera {

/// Says for messages and tables what the reason is, and what the user can do about it.
std::string skip_reason_text(SkipReason reason);

}  // namespace tessera
