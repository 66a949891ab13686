// Turns within a node, for what one rank of a node should do before the others: compiled kernels are cached on disk,
// and ranks that find the cache cold would each compile for themselves, on the same cores.
#pragma once

#include <functional>

#include "comm/communicator.h"

namespace tessera::comm {

/// To be called by every rank but 0: runs `action` first on one of them on each node, then on the others together.
void first_worker_of_node_first(Communicator& ranks, const std::function<void()>& action);

}  // namespace tessera::comm
