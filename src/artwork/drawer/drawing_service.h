// The work of a drawer: answers requests.
#pragma once

#include "artwork/protocol/drawer_protocol.h"

namespace tessera {

/// Does what the request asks for. Throws InputError where the bytes cannot be used, and OpenCV's exceptions.
DrawingAnswer answer_of(const DrawingRequest& request);

/// Calls answer_of(); where that throws, the answer is the reason.
DrawingAnswer answer_or_reason(const DrawingRequest& request);

}  // namespace tessera
