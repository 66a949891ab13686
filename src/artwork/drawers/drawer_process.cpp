#include "artwork/drawers/drawer_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include "artwork/drawers/drawer_program.h"
#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "files/child_process.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

/// Wall-clock limit as a multiple of the CPU time limit; it matters where the process does not compute.
constexpr double kPassesWithoutGain = 3;

/// The environment of a drawer: only what libraries, fonts and sanitizers need. Nothing of MPI or Slurm: a child that
/// takes itself for a rank would disturb the job.
std::vector<std::string> drawer_environment() {
  std::vector<std::string> environment = {"LC_ALL=C.UTF-8", "RAYON_NUM_THREADS=1", "MALLOC_ARENA_MAX=1"};
  for (const std::string name :
       {"HOME", "LD_LIBRARY_PATH", "FONTCONFIG_FILE", "FONTCONFIG_PATH", "XDG_DATA_HOME", "XDG_CONFIG_HOME",
        "XDG_CACHE_HOME", "XDG_DATA_DIRS", "GDK_PIXBUF_MODULE_FILE", "ASAN_OPTIONS", "UBSAN_OPTIONS"}) {
    if (const char* value = std::getenv(name.c_str())) environment.push_back(name + "=" + value);
  }
  return environment;
}

[[noreturn]] void throw_cannot_start(const std::string& reason) {
  throw EnvironmentError("cannot start tessera-drawer, which reads drawings: " + reason);
}

/// Starts a drawer that speaks through `socket`. Output of decoders must not reach the user's terminal.
pid_t start_drawer(const std::string& program, std::size_t bytes_per_process, int socket) {
  std::vector<int> descriptors(kDrawerSocket, kNoDescriptor);
  descriptors.push_back(socket);
  const pid_t pid =
      start_child(program, {"tessera-drawer", std::to_string(bytes_per_process), std::to_string(::getpid())},
                  drawer_environment(), descriptors);
  if (pid < 0) throw_cannot_start(program + ": " + std::generic_category().message(errno));
  return pid;
}

/// Kills and waits for the process; returns its status. SIGKILL does not change that of a process that died itself.
int killed_status(pid_t pid) {
  int status = 0;
  ::kill(pid, SIGKILL);
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string how_it_ended(int status, std::size_t bytes_per_process) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == kDrawerOutOfMemory) {
    return "needs more than " + std::to_string(bytes_per_process >> 20) + " MiB of memory";
  }
  if (!WIFSIGNALED(status)) return "its process gave up";
  return "crashed its process (" + std::string(::strsignal(WTERMSIG(status))) + ")";
}

constexpr char kAnotherVersion[] = "it is of another version of tessera";

/// Why the drawer is of another build, whose headers would not fit; empty where both builds are the same.
std::string another_build(const DrawerBuild& drawer) {
  const DrawerBuild program = this_build();
  if (drawer == program) return "";
  if (drawer.name.back() != 0) return kAnotherVersion;
  if (drawer.name == program.name) return "it was built from other sources; both must be of one build";
  return "it is tessera " + printable_utf8(drawer.name.data()) + ", and this program is tessera " +
         program.name.data() + "; both must be of one build";
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%g s", seconds);
  return text;
}

}  // namespace

DrawerLayers DrawerProcess::start() {
  const std::string program = program_.empty() ? drawer_program() : program_;
  int sockets[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) {
    throw_cannot_start(std::generic_category().message(errno));
  }
  try {
    const std::lock_guard lock(mutex_);
    pid_ = start_drawer(program, bytes_per_process_, sockets[1]);
  } catch (...) {
    for (const int socket : sockets) ::close(socket);
    throw;
  }
  ::close(sockets[1]);  // the child's end: when the child dies, reading from ours ends
  socket_ = sockets[0];
  ::fcntl(socket_, F_SETFL, O_NONBLOCK);
  return greet(program);
}

DrawerLayers DrawerProcess::greet(const std::string& program) {
  DrawerGreeting greeting;
  const std::string reason = refusal(greeting);
  if (reason.empty()) return greeting.layers;
  end();
  throw_cannot_start(program + ": " + reason);
}

/// Why this drawer cannot be used; empty where it can. The mark is checked first: another version may send less after
/// it, and wait.
std::string DrawerProcess::refusal(DrawerGreeting& greeting) {
  DrawerMark mark{};
  took_too_long_ = false;
  double left_s = seconds_to_start_;
  bool greeted = receive(mark.data(), mark.size(), left_s);
  if (greeted && mark != kDrawerMark) return kAnotherVersion;
  greeted = greeted && receive(&greeting, sizeof greeting, left_s);
  if (greeted) return another_build(greeting.build);
  if (took_too_long_) return "did not answer within " + seconds_text(seconds_to_start_);
  end();
  return how_it_ended(status_, bytes_per_process_);
}

std::optional<DrawingAnswer> DrawerProcess::ask(const DrawingRequest& request, double seconds) {
  took_too_long_ = false;
  allow_cpu_time(seconds);
  DrawingAnswer answer;
  double left_s = kPassesWithoutGain * seconds;
  if (exchange(request, answer, left_s)) return answer;
  end();
  if (WIFSIGNALED(status_) && WTERMSIG(status_) == SIGXCPU) took_too_long_ = true;
  failure_ = took_too_long_ ? "took longer than " + seconds_text(seconds) : how_it_ended(status_, bytes_per_process_);
  return std::nullopt;
}

bool DrawerProcess::exchange(const DrawingRequest& request, DrawingAnswer& answer, double& left_s) {
  const RequestHeader header = header_of(request);
  const bool sent = send(&header, sizeof header, left_s) && send(request.path.data(), request.path.size(), left_s) &&
                    send(request.scope_id.data(), request.scope_id.size(), left_s) &&
                    send(request.warp.data(), request.warp.size(), left_s) &&
                    send(request.bytes.data(), request.bytes.size(), left_s);
  if (!sent || !receive(&answer.header, sizeof answer.header, left_s)) return false;
  if (answer.header.bytes > most_answer_bytes(request)) return false;
  answer.payload.create(1, int(answer.header.bytes), CV_8U);
  return receive(answer.payload.data, answer.header.bytes, left_s);
}

/// Sets the limit on CPU time anew for each drawing. The process itself cannot raise its limits (drawer_sandbox.h).
void DrawerProcess::allow_cpu_time(double seconds) {
  clockid_t clock{};
  timespec used{};
  if (::clock_getcpuclockid(pid_, &clock) != 0 || ::clock_gettime(clock, &used) != 0) return;
  rlimit limit{};
  ::prlimit(pid_, RLIMIT_CPU, nullptr, &limit);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, rlim_t(used.tv_sec) + rlim_t(std::ceil(seconds)) + 1);
  ::prlimit(pid_, RLIMIT_CPU, &limit, nullptr);
}

/// Waits for the socket. Only kMostAtOnce_s of a longer pause counts: the job was suspended, or the machine is
/// overloaded.
bool DrawerProcess::wait_for(short events, double& left_s) {
  constexpr double kMostAtOnce_s = 1;
  took_too_long_ = left_s <= 0;
  if (took_too_long_) return false;
  const Stopwatch watch;
  pollfd watched{socket_, events, 0};
  ::poll(&watched, 1, 1 + int(1000 * std::min(left_s, kMostAtOnce_s)));
  left_s -= std::min(watch.seconds(), kMostAtOnce_s);
  return true;
}

bool DrawerProcess::send(const void* data, std::size_t bytes, double& left_s) {
  const char* from = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t sent =
        ::send(socket_, from, bytes, MSG_NOSIGNAL);  // MSG_NOSIGNAL: SIGPIPE of a dead child would kill the parent
    if (sent > 0) {
      from += sent;
      bytes -= std::size_t(sent);
    } else if (sent < 0 && (errno == EAGAIN || errno == EINTR)) {
      if (!wait_for(POLLOUT, left_s)) return false;
    } else {
      return false;
    }
  }
  return true;
}

bool DrawerProcess::receive(void* data, std::size_t bytes, double& left_s) {
  char* to = static_cast<char*>(data);
  while (bytes > 0) {
    const ssize_t got = ::recv(socket_, to, bytes, 0);
    if (got > 0) {
      to += got;
      bytes -= std::size_t(got);
    } else if (got < 0 && (errno == EAGAIN || errno == EINTR)) {
      if (!wait_for(POLLIN, left_s)) return false;
    } else {
      return false;
    }
  }
  return true;
}

void DrawerProcess::end() {
  const std::lock_guard lock(mutex_);
  if (socket_ >= 0) ::close(std::exchange(socket_, -1));
  if (pid_ > 0) status_ = killed_status(std::exchange(pid_, -1));
}

void DrawerProcess::kill() {
  const std::lock_guard lock(mutex_);
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

}  // namespace tessera
