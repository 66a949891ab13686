// The ranks of tessera collage that search the library, a part of it each, on the devices of their node, and replace
// pieces on its cores.
#pragma once

#include "comm/communicator.h"

namespace tessera {

/// A worker's life, from the master's job on. Leaves by JobEnded; throws InputError and EnvironmentError.
[[noreturn]] void run_collage_worker(comm::Communicator& ranks);

}  // namespace tessera
