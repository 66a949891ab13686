// The command that a command line asks for.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "comm/communicator.h"

namespace tessera {

/// The chosen sub-command: exactly one of the two functions is set. Both return the exit code and throw InputError and
/// EnvironmentError.
struct Command {
  std::function<int()> run = {};  // runs on rank 0 only
  std::function<int(comm::Communicator&)> run_on_all_ranks = {};
  /// The value of --time-limit, where it is given: the start of MPI must finish within it, before the command runs.
  std::optional<std::string> time_limit = {};
};

}  // namespace tessera
