#include "comm/stop_signals.h"

#include <fcntl.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/base/stop.h"

namespace tessera::comm {
namespace {

volatile sig_atomic_t launcher_has_begun = 0;

/// Whether the process is mpirun or its daemon on this node. Called by a signal handler: no memory, no streams.
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

// Only SIGCONT from the launcher counts: a shell after Ctrl-Z and Slurm after a suspension send it, too.
void on_continue(int, siginfo_t* info, void*) {
  const int saved_errno = errno;
  if (is_launcher(info->si_pid)) {
    launcher_has_begun = 1;
    raise(SIGTERM);
  }
  errno = saved_errno;
}

void on_first_stop(int) {}

std::atomic<int> signalled{0};          // number of the signal
std::atomic<std::int64_t> first_ns{0};  // time of the first signal; 0: none has come
std::atomic<bool> signalled_again{false};
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

std::int64_t now_ns() {
  struct timespec now = {};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

void remember(int number) {
  signalled.store(number, std::memory_order_relaxed);
  constexpr std::int64_t kOneStop_ns = 1'000'000'000;
  const std::int64_t at_ns = now_ns();
  std::int64_t none = 0;
  if (!first_ns.compare_exchange_strong(none, at_ns) && at_ns - first_ns.load() >= kOneStop_ns) signalled_again = true;
}

/// Returns the number of the signal that has come (0: none) and forgets it.
int forgotten_stop() {
  first_ns = 0;
  signalled_again = false;
  return signalled.exchange(0);
}

void (*clean_up_at_end)() = nullptr;

void end_at_once(int number) {
  clean_up_at_end();
  constexpr char kLine[] = "\ntessera: interrupted\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kLine, sizeof kLine - 1);
  signal(number, SIG_DFL);
  sigset_t own;
  sigemptyset(&own);
  sigaddset(&own, number);
  pthread_sigmask(SIG_UNBLOCK, &own, nullptr);
  raise(number);
}

/// The signals that install_stop_handlers handles.
constexpr std::array kStops = {SIGINT, SIGTERM, SIGUSR2, SIGHUP, SIGXCPU};

/// Whether the signal stays ignored. nohup ignores SIGHUP, so that the program goes on. A shell without job control
/// ignores SIGINT for programs in the background, but a SIGINT that somebody sends to a run is meant.
bool stays_ignored(int signal) {
  struct sigaction now = {};
  return signal == SIGHUP && sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

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

void end_at_once_when_signalled(void (*clean_up)()) {
  clean_up_at_end = clean_up;
  struct sigaction action = {}, before = {};
  action.sa_handler = end_at_once;
  for (const int signal : kStops) {
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_DFL) sigaction(signal, &action, nullptr);
  }
}

void install_stop_handlers() {
  struct sigaction action = {};
  action.sa_handler = remember;
  action.sa_flags = SA_RESTART;  // system calls of MPI or OpenCL are restarted
  for (const int signal : kStops) {
    if (!stays_ignored(signal)) sigaction(signal, &action, nullptr);
  }
}

bool stop_signalled() { return signalled.load(std::memory_order_relaxed) != 0; }

std::optional<StopReason> stop_asked_by_signal() {
  return stop_signalled() ? std::optional(StopReason::signal) : std::nullopt;
}

double seconds_since_stop() {
  const std::int64_t at_ns = first_ns;
  return at_ns == 0 ? 0 : 1e-9 * double(now_ns() - at_ns);
}

bool stop_signalled_again() { return signalled_again && !launcher_ends_job(); }

void end_stop_handlers() {
  struct sigaction at_once = {}, before = {};
  at_once.sa_handler = clean_up_at_end ? end_at_once : SIG_DFL;
  for (const int signal : kStops) {
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == remember) sigaction(signal, &at_once, nullptr);
  }
  if (const int number = forgotten_stop(); number != 0) raise(number);
}

struct StopDelay::Before {
  std::array<struct sigaction, kStops.size()> actions = {};
};

StopDelay::StopDelay() : before_(std::make_unique<Before>()) {
  for (std::size_t i = 0; i < kStops.size(); ++i) sigaction(kStops[i], nullptr, &before_->actions[i]);
  install_stop_handlers();
}

StopDelay::~StopDelay() {
  for (std::size_t i = 0; i < kStops.size(); ++i) sigaction(kStops[i], &before_->actions[i], nullptr);
  if (const int number = forgotten_stop(); number != 0) raise(number);
}

}  // namespace tessera::comm
