#include "library/hdf5/hdf5_trial.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <exception>
#include <system_error>
#ifdef __SANITIZE_ADDRESS__
#include <filesystem>
#include <iterator>
#endif

#include "core/base/error.h"
#include "library/hdf5/hdf5_handles.h"

namespace tessera {
namespace {

constexpr unsigned kMostCpu_s = 20;
constexpr unsigned kMost_s = 600;  // by the clock, because disks of clusters are slow at times and jobs are suspended

/// Runs `read` in the child, which is there to crash: MPI says nothing about it, and no core file is written.
[[noreturn]] void run_in_child(const std::function<void()>& read) {
  for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGALRM}) std::signal(number, SIG_DFL);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const rlimit cpu_s{kMostCpu_s, kMostCpu_s};
  ::setrlimit(RLIMIT_CPU, &cpu_s);
  ::alarm(kMost_s);
  try {
    read();
  } catch (const std::exception&) {
    ::_exit(0);
  }
  ::_exit(0);
}

#ifdef __SANITIZE_ADDRESS__
/// With a sanitizer there is no trial where other threads run. Unlike the C library's allocator, the sanitizer's is copied
/// by a fork with its locks: where another thread holds one, the child waits for ever. Forged files are tested without
/// other threads.
bool has_other_threads() {
  const std::filesystem::directory_iterator threads("/proc/self/task");
  return std::distance(begin(threads), end(threads)) > 1;
}
#endif

}  // namespace

void try_in_child(const std::function<void()>& read) {
#ifdef __SANITIZE_ADDRESS__
  if (has_other_threads()) return;
#endif
  const pid_t child = ::fork();
  if (child < 0)
    throw EnvironmentError("no further process can be started to check a file: " +
                           std::generic_category().message(errno));
  if (child == 0) run_in_child(read);
  int status = 0;
  pid_t ended = -1;
  while ((ended = ::waitpid(child, &status, 0)) < 0 && errno == EINTR) {
  }
  if (ended < 0) throw Hdf5Error("cannot be checked: the process that tried it is lost");
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) throw Hdf5Error("could not be read within ten minutes");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Hdf5Error("damaged or forged: HDF5 cannot take it apart");
}

}  // namespace tessera
