// Lack of memory as one exception, whoever met it.
#pragma once

#include <functional>

namespace tessera {

/// Returns what `work` returns. OpenCV's own exception for a lack of memory becomes std::bad_alloc; others pass.
int with_lack_of_memory_named(const std::function<int()>& work);

}  // namespace tessera
