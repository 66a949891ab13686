// Lack of memory as one exception, whichever library reports it.
#pragma once

#include <functional>

namespace tessera {

/// Returns what `work` returns. OpenCV's own exception for lack of memory becomes std::bad_alloc; other exceptions
/// pass.
int with_lack_of_memory_named(const std::function<int()>& work);

}  // namespace tessera
