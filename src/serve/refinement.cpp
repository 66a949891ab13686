#include "serve/refinement.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>
#include <system_error>

#include "core/base/error.h"

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

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Reads nothing, prints nothing on stdout, and has `errors` as its stderr. Ctrl-C does not reach it.
class SpawnSettings {
 public:
  explicit SpawnSettings(int errors) {
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    ::posix_spawnattr_init(&attributes);
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSettings() {
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
};

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
  std::vector<std::string> environment = environment_of_child();
  const SpawnSettings settings(errors.number());
  const int error = ::posix_spawn(&pid_, program.c_str(), &settings.actions, &settings.attributes,
                                  pointers_to(words).data(), pointers_to(environment).data());
  if (error != 0) {
    throw EnvironmentError("cannot start tessera refine: " + program + ": " + std::generic_category().message(error));
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
