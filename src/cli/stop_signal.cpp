#include "cli/stop_signal.h"

#include <atomic>
#include <csignal>

namespace tessera::cli {
namespace {

std::atomic<bool> signalled{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void remember(int) { signalled.store(true, std::memory_order_relaxed); }

}  // namespace

void install_stop_handlers() {
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = SA_RESTART;  // a system call of MPI or OpenCL goes on
  for (const int signal : {SIGINT, SIGTERM, SIGUSR2}) sigaction(signal, &action, nullptr);
}

bool stop_signalled() { return signalled.load(std::memory_order_relaxed); }

}  // namespace tessera::cli
