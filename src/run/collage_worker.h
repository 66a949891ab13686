// The workers of tessera collage. Each searches a part of the library on the devices of its node, and replaces pieces on
// its cores.
#pragma once

#include "comm/communicator.h"

namespace tessera {

/// Does a worker's work, from receiving the master's job on. Leaves by JobEnded; throws InputError and EnvironmentError.
[[noreturn]] void run_collage_worker(comm::Communicator& ranks);

}  // namespace tessera
