// Detects launchers whose processes do not find each other: those of other MPI libraries than Open MPI, and srun
// without PMIx. Each of their processes would be a master of its own.
#pragma once

#include <functional>
#include <string>

namespace tessera::comm {

/// Returns the value of an environment variable, or null.
using Environment = std::function<const char*(const char* name)>;

/// A message that says what is wrong with the launcher and what to do. Empty where a launcher started as many ranks as
/// the job has. Also empty without a launcher (a batch script's own process, a shell inside an allocation). `ranks`:
/// the size that MPI reports; 1 without MPI.
std::string launcher_problem(const Environment& environment, int ranks);

}  // namespace tessera::comm
