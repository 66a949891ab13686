// What a drawer does with a request.
#pragma once

#include "artwork/protocol/drawer_protocol.h"

namespace tessera {

/// Does what the request asks. Throws InputError where the bytes are of no use, and what OpenCV throws where it fails.
DrawingAnswer answer_of(const DrawingRequest& request);

/// The same, with the reason as answer where that throws.
DrawingAnswer answer_or_reason(const DrawingRequest& request);

}  // namespace tessera
