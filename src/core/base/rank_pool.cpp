#include "core/base/rank_pool.h"

#include <sched.h>

#include <algorithm>
#include <cerrno>
#include <thread>
#include <vector>

namespace tessera {
namespace {

/// The number of cores in this process' affinity, at least 1; fewer than the machine has if it is shared.
int available_cores() {
  // The kernel refuses a mask that is smaller than its own.
  for (std::size_t cpus = 1024; cpus <= (std::size_t(1) << 20); cpus *= 2) {
    std::vector<cpu_set_t> mask(cpus / CPU_SETSIZE);
    const std::size_t bytes = mask.size() * sizeof(cpu_set_t);
    if (sched_getaffinity(0, bytes, mask.data()) == 0) return std::max(1, CPU_COUNT_S(bytes, mask.data()));
    if (errno != EINVAL) break;
  }
  return int(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace

TaskPool& rank_pool() {
  // Never destroyed: a library may end the process while tasks are running.
  static TaskPool& pool = *new TaskPool(available_cores());
  return pool;
}

void share_cores(int ranks) { rank_pool().resize(available_cores() / std::max(1, ranks)); }

}  // namespace tessera
