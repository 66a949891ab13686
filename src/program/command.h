// What a command line asks for.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "comm/communicator.h"

namespace tessera {

/// What the chosen sub-command runs: one of the two. Both return the exit code and throw InputError and
/// EnvironmentError.
struct Command {
  std::function<int()> run = {};  // on rank 0 alone
  std::function<int(comm::Communicator&)> run_on_all_ranks = {};
  /// The value of --time-limit, where it is given: MPI's start must keep to it before the command runs.
  std::optional<std::string> time_limit = {};
};

}  // namespace tessera
