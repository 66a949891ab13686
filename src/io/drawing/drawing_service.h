// What a drawer does with a request.
#pragma once

#include "io/drawing/drawer_protocol.h"

namespace tessera::io {

/// Throws InputError where the bytes are of no use, std::bad_alloc where the process may have no more memory.
DrawingAnswer answer_of(const DrawingRequest& request);

/// The same, with the reason as answer where that throws.
DrawingAnswer answer_or_reason(const DrawingRequest& request);

}  // namespace tessera::io
