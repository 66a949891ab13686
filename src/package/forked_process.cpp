#include "package/forked_process.h"

#include <unistd.h>

#include <atomic>

#include "tessera/matching/error.h"

namespace tessera::matching {

void check_threads_are_own() {
  static std::atomic<pid_t> owner = 0;
  pid_t found = 0;
  if (owner.compare_exchange_strong(found, ::getpid()) || found == ::getpid()) return;
  throw Error(
      "this process was forked from one that had recognised outlines before, and has none of its threads; fork "
      "earlier, or "
      "start processes anew (in Python: multiprocessing.set_start_method('spawn'))");
}

}  // namespace tessera::matching
