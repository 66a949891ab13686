#include "serve/refinement.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "files/child_process.h"

namespace tessera::serve {
namespace {

constexpr std::size_t kMostLine_bytes = 2000;

/// Our environment without what mpirun and srun tell their ranks: the new process is no rank of ours.
std::vector<std::string> environment_of_child() {
  std::vector<std::string> kept;
  for (char** variable = environ; *variable; ++variable) {
    const std::string_view text = *variable;
    if (!text.starts_with("OMPI_COMM_WORLD_") && !text.starts_with("PMIX_")) kept.emplace_back(text);
  }
  return kept;
}

int exit_code_of(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string without_prefix(std::string line) {
  constexpr std::string_view kPrefix = "tessera: ";
  return line.starts_with(kPrefix) ? line.substr(kPrefix.size()) : line;
}

}  // namespace

Refinement::Refinement(const std::string& program, const std::vector<std::string>& arguments) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    throw EnvironmentError("cannot start tessera refine: " + std::generic_category().message(errno));
  }
  output_ = FileDescriptor(ends[0]);
  const FileDescriptor errors(ends[1]);
  std::vector<std::string> words = {"tessera", "refine"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  pid_ =
      start_child(program, std::move(words), environment_of_child(), {kNoDescriptor, kNoDescriptor, errors.number()});
  if (pid_ < 0) {
    throw EnvironmentError("cannot start tessera refine: " + program + ": " + std::generic_category().message(errno));
  }
  try {
    reader_ = std::thread([this] { read_to_the_end(); });
  } catch (const std::system_error& thrown) {
    ::kill(pid_, SIGKILL);
    exit_code_of(pid_);
    throw EnvironmentError(std::string("cannot watch tessera refine: ") + thrown.what());
  }
}

Refinement::~Refinement() {
  stop();
  reader_.join();
}

Refinement::State Refinement::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

void Refinement::stop() {
  const std::lock_guard lock(mutex_);  // while it runs nobody has waited for it: the number is still its own
  if (state_.runs) ::kill(pid_, SIGTERM);
}

void Refinement::read_to_the_end() {
  std::string line;
  char part[4096];
  for (;;) {
    const ssize_t bytes = ::read(output_.number(), part, sizeof part);
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes <= 0) break;
    for (const char c : std::string_view(part, std::size_t(bytes))) {
      if (c != '\n') {
        if (line.size() < kMostLine_bytes) line += c;
        continue;
      }
      const std::lock_guard lock(mutex_);
      if (!line.empty()) state_.last_line = without_prefix(line);
      line.clear();
    }
  }
  siginfo_t ended;
  while (::waitid(P_PID, id_t(pid_), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
  const std::lock_guard lock(mutex_);
  state_.exit_code = exit_code_of(pid_);
  state_.runs = false;
}

}  // namespace tessera::serve
