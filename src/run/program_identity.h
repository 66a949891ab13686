// Which program a rank runs, told before anything else: other programs may understand nothing else in the same way.
#pragma once

#include <string>

#include "comm/communicator.h"

namespace tessera {

/// "tessera 0.1.0, commit 4554c24, kernels 5a0c1e4bd1f0a977"
std::string program_identity();

/// Rank 0: tells all other ranks which program is the master's. It is the first broadcast of a job, and the only one
/// that is no typed message (comm/encode.h): plain text.
void announce_program(comm::Communicator& ranks, const std::string& program);

/// Every other rank, first: throws EnvironmentError where `program`, its own, is not the master's.
void check_program(comm::Communicator& ranks, const std::string& program);

}  // namespace tessera
