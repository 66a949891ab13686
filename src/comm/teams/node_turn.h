// Lets one rank of a node do something before the others. Compiled kernels are cached on disk; without turns, all ranks
// that find an empty cache would compile for themselves, on the same cores.
#pragma once

#include <functional>

#include "comm/communicator.h"

namespace tessera::comm {

/// Runs `action` on one rank of each node first, then on the node's other ranks together. To be called by every rank
/// except 0.
void first_worker_of_node_first(Communicator& ranks, const std::function<void()>& action);

}  // namespace tessera::comm
