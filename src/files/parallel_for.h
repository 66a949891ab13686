// A loop over independent items on all cores that the process may use.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "files/available_cores.h"

namespace tessera {

/// Calls body(i) for each i in [0, count), in any order, from `most_threads` threads or fewer. After an exception no
/// further item starts; the first one is thrown again here.
template <class Body>
void parallel_for_on(std::size_t most_threads, std::size_t count, Body&& body) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
    }
  };
  std::vector<std::jthread> threads;
  const std::size_t wanted = std::min(count, most_threads);
  try {
    while (threads.size() + 1 < wanted) threads.emplace_back(work);
  } catch (const std::system_error&) {  // no more threads are allowed: those that are there share the work
  }
  work();
  threads.clear();  // joins
  if (error) std::rethrow_exception(error);
}

/// The same from as many threads as this process may use cores.
template <class Body>
void parallel_for(std::size_t count, Body&& body) {
  parallel_for_on(std::size_t(available_cores()), count, body);
}

}  // namespace tessera
