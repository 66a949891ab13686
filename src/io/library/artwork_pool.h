// Work on untrusted files in child processes: one that hangs, crashes or eats the memory costs its own result only.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace tessera::io {

struct PoolSettings {
  int processes = 1;
  double seconds_per_input = 20;
  std::size_t bytes_per_process = std::size_t(384) << 20;  // of data, beyond what a process starts with
};

struct PoolResult {
  bool done = false;
  std::string output;  // where done
  std::string reason;  // where not: what the work's exception says, or how its process ended
};

/// Runs in a child process. Throws where the input is of no use; the message becomes the reason.
using PoolWork = std::function<std::string(const std::string& input)>;
/// Runs in the calling process, in the order of the inputs. May throw, which ends the pool.
using PoolConsumer = std::function<void(std::size_t index, PoolResult result)>;

/// Does `work` on all inputs. Call it while the process has a single thread: children are forked as needed and go on
/// without exec. Returns false where `interrupted` (asked several times a second) said so. No child outlives the call.
/// Throws EnvironmentError where no process can be started.
bool work_in_processes(const std::vector<std::string>& inputs, const PoolWork& work, const PoolConsumer& consume,
                       const PoolSettings& settings, const std::function<bool()>& interrupted);

}  // namespace tessera::io
