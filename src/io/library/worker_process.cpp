#include "io/library/worker_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>
#include <system_error>
#include <utility>

#include "core/base/error.h"

namespace tessera::io {
namespace {

/// Goes before every message, both ways.
struct Header {
  std::uint64_t bytes;
  std::uint64_t done;  // of a result; otherwise unused
};

// A parent that is killed must not leave writers behind, nor a dead child kill its parent: no SIGPIPE.
bool send_all(int socket, const void* data, std::size_t bytes) {
  const char* from = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t sent = ::send(socket, from, bytes, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    from += sent;
    bytes -= std::size_t(sent);
  }
  return true;
}

bool receive_all(int socket, void* data, std::size_t bytes) {
  char* to = static_cast<char*>(data);
  while (bytes > 0) {
    const ssize_t got = ::recv(socket, to, bytes, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    to += got;
    bytes -= std::size_t(got);
  }
  return true;
}

bool send_message(int socket, const std::string& text, bool done) {
  const Header header{text.size(), done};
  return send_all(socket, &header, sizeof header) && send_all(socket, text.data(), text.size());
}

/// Bytes of data segments and private mappings, which is what RLIMIT_DATA counts.
std::size_t data_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::size_t pages = 0;
  for (int field = 0; field < 6; ++field) statm >> pages;  // the sixth: data + stack
  return pages * std::size_t(::sysconf(_SC_PAGESIZE));
}

void set_limit(decltype(RLIMIT_DATA) resource, std::size_t most) {
  rlimit limit{};
  ::getrlimit(resource, &limit);
  limit.rlim_cur = std::min<rlim_t>(most, limit.rlim_max);
  ::setrlimit(resource, &limit);
}

void become_worker(const PoolSettings& settings) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::signal(SIGINT, SIG_IGN);  // Ctrl-C goes to the whole group; the parent decides
  ::signal(SIGTERM, SIG_DFL);
  // Decoders print what they do not like; the parent's progress line and table are the place for that.
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
  set_limit(RLIMIT_DATA, data_bytes() + settings.bytes_per_process);
  set_limit(RLIMIT_CORE, 0);
}

PoolResult answer(const PoolWork& work, const std::string& input, const PoolSettings& settings) {
  try {
    return {true, work(input), {}};
  } catch (const std::bad_alloc&) {
    return {false, {}, "needs more than " + std::to_string(settings.bytes_per_process >> 20) + " MiB of memory"};
  } catch (const std::exception& error) {
    return {false, {}, error.what()};
  }
}

[[noreturn]] void serve(int socket, const PoolWork& work, const PoolSettings& settings) {
  become_worker(settings);
  Header header{};
  while (receive_all(socket, &header, sizeof header)) {
    std::string input(header.bytes, '\0');
    if (!receive_all(socket, input.data(), input.size())) break;
    const PoolResult result = answer(work, input, settings);
    if (!send_message(socket, result.done ? result.output : result.reason, result.done)) break;
  }
  ::_exit(0);  // without the parent's clean-up: its files are not ours
}

std::string how_it_ended(int status) {
  if (!WIFSIGNALED(status)) return "its process ended";
  const int signal = WTERMSIG(status);
  return "crashed its process (" + std::string(::strsignal(signal)) + ")";
}

}  // namespace

WorkerProcess::WorkerProcess(const PoolWork& work, const PoolSettings& settings) {
  int sockets[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) {
    throw EnvironmentError("cannot start a process: " + std::generic_category().message(errno));
  }
  pid_ = ::fork();
  if (pid_ == 0) {
    ::close(sockets[0]);
    serve(sockets[1], work, settings);
  }
  const int reason = errno;
  ::close(sockets[1]);  // the child's own: that it closes is how we learn of its death
  socket_ = sockets[0];
  if (pid_ < 0) {
    ::close(sockets[0]);
    throw EnvironmentError("cannot start a process: " + std::generic_category().message(reason));
  }
}

WorkerProcess::~WorkerProcess() { end(); }

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept { *this = std::move(other); }

WorkerProcess& WorkerProcess::operator=(WorkerProcess&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(socket_, other.socket_);
  std::swap(input_, other.input_);
  std::swap(deadline_, other.deadline_);
  std::swap(received_, other.received_);
  return *this;
}

void WorkerProcess::give(std::size_t index, const std::string& input, Clock::time_point deadline) {
  input_ = index;
  deadline_ = deadline;
  received_.clear();
  send_message(socket_, input, false);  // a dead child shows when its answer is read
}

WorkerProcess::Answer WorkerProcess::receive(PoolResult& result) {
  char buffer[1 << 16];
  const ssize_t got = ::recv(socket_, buffer, sizeof buffer, 0);
  if (got < 0 && errno == EINTR) return Answer::incomplete;
  if (got <= 0) return Answer::dead;
  received_.append(buffer, std::size_t(got));
  Header header{};
  if (received_.size() < sizeof header) return Answer::incomplete;
  std::memcpy(&header, received_.data(), sizeof header);
  if (received_.size() - sizeof header < header.bytes) return Answer::incomplete;
  result.done = header.done != 0;
  (result.done ? result.output : result.reason) = received_.substr(sizeof header, header.bytes);
  input_.reset();
  return Answer::complete;
}

std::string WorkerProcess::end() {
  if (pid_ < 0) return {};
  ::close(std::exchange(socket_, -1));
  int status = 0;
  // A process that died by itself is collected as it is; SIGKILL does nothing to it any more.
  ::kill(pid_, SIGKILL);
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return how_it_ended(status);
}

}  // namespace tessera::io
