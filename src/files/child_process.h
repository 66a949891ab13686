// Starts another program with descriptors, signals and a process group of its own. A fork without exec would be wrong in our
// programs: MPI and OpenCL have threads.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace tessera {

/// Stands for /dev/null in the list of start_child().
inline constexpr int kNoDescriptor = -1;

/// Starts the program at this path. `words`: the name that it sees of itself, and its arguments. `environment`:
/// "NAME=VALUE". `descriptors`: the one at place i becomes its descriptor i; it has no others. Ctrl-C of a terminal does not
/// reach it: only its parent hears that. Returns its number, or -1, with errno, where it cannot be started.
pid_t start_child(const std::string& program, std::vector<std::string> words, std::vector<std::string> environment,
                  const std::vector<int>& descriptors);

}  // namespace tessera
