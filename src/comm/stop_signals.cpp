#include "comm/stop_signals.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <initializer_list>
#include <string_view>

namespace tessera::comm {
namespace {

volatile sig_atomic_t launcher_has_begun = 0;

/// mpirun or its daemon on this node. Called by a signal handler: no memory, no streams.
bool is_launcher(pid_t process) {
  char path[32] = "/proc/";
  char* end = std::to_chars(path + 6, path + sizeof path - 6, process).ptr;
  std::memcpy(end, "/comm", 6);
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  char text[16];
  const ssize_t length = read(file, text, sizeof text);
  close(file);
  const std::string_view name(text, length > 0 ? std::size_t(length) : 0);
  for (const std::string_view launcher : {"mpirun", "mpiexec", "orte", "prte"}) {
    if (name.starts_with(launcher)) return true;
  }
  return false;
}

// Others send SIGCONT too: a shell after Ctrl-Z, Slurm after a suspension.
void on_continue(int, siginfo_t* info, void*) {
  const int saved_errno = errno;
  if (is_launcher(info->si_pid)) {
    launcher_has_begun = 1;
    raise(SIGTERM);
  }
  errno = saved_errno;
}

void on_first_stop(int) {}

std::atomic<bool> signalled{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void remember(int) { signalled.store(true, std::memory_order_relaxed); }

}  // namespace

void prepare_stop_signals(int rank) {
  struct sigaction action = {};
  if (rank == 0) {
    action.sa_sigaction = on_continue;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    sigaction(SIGCONT, &action, nullptr);
    return;
  }
  signal(SIGUSR2, SIG_IGN);
  action.sa_handler = on_first_stop;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  for (const int stop : {SIGINT, SIGTERM, SIGHUP}) sigaction(stop, &action, nullptr);
}

bool launcher_ends_job() { return launcher_has_begun != 0; }

void install_stop_handlers() {
  struct sigaction action = {};
  action.sa_handler = remember;
  action.sa_flags = SA_RESTART;  // a system call of MPI or OpenCL goes on
  for (const int signal : {SIGINT, SIGTERM, SIGUSR2}) sigaction(signal, &action, nullptr);
}

bool stop_signalled() { return signalled.load(std::memory_order_relaxed); }

}  // namespace tessera::comm
