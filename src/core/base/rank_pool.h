// The cores of this rank and the threads that compute on them. All computations on several threads use this pool, so
// that workers on one node do not compete for cores; tests/scripts/threads_test.sh lists the exceptions. A forked child
// must not use the pool, as it does not have the threads.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/base/task_pool.h"

namespace tessera {

/// The one pool of this process, which is a rank. Its breadth is the number of cores that the allocation gives to the
/// process (its affinity: taskset, Slurm, CPU sets of containers), until share_cores() is called.
TaskPool& rank_pool();

/// Divides the cores of the process among `ranks` ranks, this one included, from now on. Must be called while no task
/// runs.
void share_cores(int ranks);

/// The number of cores that this rank computes on, at least 1.
inline int rank_cores() { return rank_pool().breadth(); }

/// Calls body(i) for each i in [0, count), in any order, on any of the rank's threads. After an exception no further
/// item begins, and the first exception is thrown again here.
template <class Body>
void parallel_for(std::size_t count, Body&& body) {
  rank_pool().run(count, [&](std::size_t i) { body(i); });
}

/// parallel_for for small items: one task is `portion` items, one after the other.
template <class Body>
void parallel_for_portions(std::size_t count, std::size_t portion, Body&& body) {
  parallel_for((count + portion - 1) / portion, [&](std::size_t k) {
    for (std::size_t i = k * portion; i < std::min(count, (k + 1) * portion); ++i) body(i);
  });
}

/// Calls `here` on this thread and `beside` on another one, or afterwards if none is free. When both have ended, throws
/// the first exception of either.
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
