// Launchers whose processes do not find each other: those of other MPI libraries than Open MPI, and srun without PMIx.
// Each process would be a master of its own.
#pragma once

#include <functional>
#include <string>

namespace tessera::comm {

/// The value of an environment variable, or null.
using Environment = std::function<const char*(const char* name)>;

/// Empty where the job's `ranks` are those that a launcher started, or none did: a batch script's own process, a shell
/// inside an allocation. Otherwise what is wrong and what to do. `ranks`: of MPI; 1 without it.
std::string launcher_problem(const Environment& environment, int ranks);

}  // namespace tessera::comm
