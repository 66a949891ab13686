// Compares the program of each rank with the master's, before anything else: another program may read messages differently.
#pragma once

#include <string>

#include "comm/communicator.h"

namespace tessera {

/// "tessera 0.1.0, commit 4554c24, kernels 5a0c1e4bd1f0a977".
std::string program_identity();

/// Called by rank 0: tells all other ranks the master's program. It is the first broadcast of a job, and the only one that is
/// plain text and no typed message (comm/encode.h).
void announce_program(comm::Communicator& ranks, const std::string& program);

/// Called first by every other rank: throws EnvironmentError where its own `program` is not the master's.
void check_program(comm::Communicator& ranks, const std::string& program);

}  // namespace tessera
