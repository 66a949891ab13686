// The cores of this rank, and the threads that compute on them. What computes on several threads takes them from here, so
// that workers on one node do not compete for cores; tests/scripts/threads_test.sh lists the exceptions. A child that was
// forked must not use the pool: its threads are not there.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/base/task_pool.h"

namespace tessera {

/// The one pool of this process, which is a rank. Its breadth is the number of cores that the allocation leaves to the
/// process (its affinity: taskset, Slurm, containers' CPU sets), until share_cores().
TaskPool& rank_pool();

/// From here on the cores that the process may use are divided among so many ranks, this one included. To be called
/// while no task is under way.
void share_cores(int ranks);

/// How many cores this rank computes on, 1 at least.
inline int rank_cores() { return rank_pool().breadth(); }

/// Calls body(i) for each i in [0, count), in any order, from any of the rank's threads. After an exception no further
/// item begins; the first exception is thrown again here.
template <class Body>
void parallel_for(std::size_t count, Body&& body) {
  rank_pool().run(count, [&](std::size_t i) { body(i); });
}

/// As parallel_for, for small items: `portion` items, one after the other, are one task.
template <class Body>
void parallel_for_portions(std::size_t count, std::size_t portion, Body&& body) {
  parallel_for((count + portion - 1) / portion, [&](std::size_t k) {
    for (std::size_t i = k * portion; i < std::min(count, (k + 1) * portion); ++i) body(i);
  });
}

/// Calls `here` on this thread and `beside` on another one, or afterwards where none is free. Throws what one of them
/// threw, when both have ended.
template <class Here, class Beside>
void run_both(Here&& here, Beside&& beside) {
  rank_pool().run(2, [&](std::size_t i) {
    if (i == 0) {
      here();
    } else {
      beside();
    }
  });
}

}  // namespace tessera
