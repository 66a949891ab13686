#include "files/output_lock.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>

#include "core/base/error.h"
#include "files/named_file.h"
#include "files/own_file.h"

namespace tessera {
namespace {

/// The holder of a lock as words by name; the file has one line for each.
using Holder = std::map<std::string, std::string>;

constexpr std::size_t kMostBytes = 4096;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value && *value ? value : "0";
}

/// Identifies this boot of the machine: a process of another boot is not in this system's list of processes.
std::string boot_id() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  file >> id;
  return id.empty() ? "unknown" : id;
}

Holder this_process() {
  char host[256] = "unknown";
  gethostname(host, sizeof host - 1);
  return {{"host", host},
          {"pid", std::to_string(getpid())},
          {"boot", boot_id()},
          {"slurm_job", variable("SLURM_JOB_ID")},
          {"slurm_restart", variable("SLURM_RESTART_COUNT")}};
}

Holder read_holder(int file) {
  std::string text(kMostBytes, '\0');
  const ssize_t length = pread(file, text.data(), text.size(), 0);
  std::istringstream lines(text.substr(0, length > 0 ? std::size_t(length) : 0));
  Holder holder;
  std::string name;
  std::string word;
  while (lines >> name >> word) holder[name] = word;
  return holder;
}

bool write_holder(int file, const Holder& holder) {
  std::string text;
  for (const auto& [name, word] : holder) text += name + " " + word + "\n";
  return ftruncate(file, 0) == 0 && pwrite(file, text.data(), text.size(), 0) == ssize_t(text.size());
}

std::string word(const Holder& holder, const std::string& name) {
  const auto at = holder.find(name);
  return at == holder.end() ? "0" : at->second;
}

long number(const Holder& holder, const std::string& name) {
  return std::strtol(word(holder, name).c_str(), nullptr, 10);
}

/// The holder for messages: "process 71 on node7, Slurm job 12".
std::string description(const Holder& holder) {
  if (!holder.contains("host")) return "a process that has just begun";
  const std::string job = word(holder, "slurm_job");
  return "process " + word(holder, "pid") + " on " + word(holder, "host") + (job == "0" ? "" : ", Slurm job " + job);
}

bool is_alive(const Holder& holder) {
  const pid_t process = pid_t(number(holder, "pid"));
  return process > 0 && (kill(process, 0) == 0 || errno == EPERM);
}

/// Whether the run that wrote the file has ended, where the file exists and nobody holds the lock.
bool is_over(const Holder& then, const Holder& now, bool locks_work) {
  if (then.empty()) return true;
  if (word(then, "boot") == word(now, "boot")) return locks_work || !is_alive(then);
  const std::string job = word(now, "slurm_job");
  return job != "0" && job == word(then, "slurm_job") && number(now, "slurm_restart") > number(then, "slurm_restart");
}

enum class Locking { locked, held_by_another, not_supported };

/// Tries to lock. The lock belongs to the process, not to the open file: forked children do not hold it after its end.
Locking try_to_lock(int file) {
  struct flock whole_file = {};
  whole_file.l_type = F_WRLCK;
  whole_file.l_whence = SEEK_SET;
  if (fcntl(file, F_SETLK, &whole_file) == 0) return Locking::locked;
  return errno == EACCES || errno == EAGAIN ? Locking::held_by_another : Locking::not_supported;
}

/// Takes the output over. Throws where another run uses it.
void take(int file, const std::string& path, const std::string& output, Locking locking) {
  const Holder then = read_holder(file);
  const Holder now = this_process();
  if (locking == Locking::held_by_another) {
    throw InputError(output + ": another run is at work here: " + description(then) +
                     "; wait for its end, or give another output");
  }
  if (!is_over(then, now, locking == Locking::locked)) {
    throw InputError(output + ": another run may still be at work here: " + description(then) +
                     ", and this machine cannot tell whether it has ended; if it has, remove " + path);
  }
  if (write_holder(file, now)) return;
  const int reason = errno;
  unlink(path.c_str());  // it is ours, and empty
  throw EnvironmentError("cannot write " + path + ": " + std::generic_category().message(reason));
}

/// Opens the lock file. Errors name the output and its folder: the user does not know of the lock.
FileDescriptor opened(const std::string& path, const std::string& output) {
  const std::string parent = std::filesystem::path(path).parent_path();
  const std::string folder = parent.empty() ? "." : parent;
  std::error_code error;
  if (std::filesystem::exists(folder, error) && !std::filesystem::is_directory(folder, error))
    throw InputError("cannot write " + output + ": " + folder + " is a file; give another output");
  if (access(folder.c_str(), W_OK | X_OK) == 0) return open_own_file(path, O_RDWR);
  const int reason = errno;
  throw EnvironmentError("cannot write " + output + ": the folder " + folder + ": " +
                         std::generic_category().message(reason) + "; give another output");
}

}  // namespace

OutputLock::OutputLock(const std::string& path, const std::string& output)
    : path_(path),
      file_(opened(path, output)),
      owner_(getpid()) {
  Locking locking = try_to_lock(file_.number());
  // We may have locked a file that its holder has just removed.
  while (locking != Locking::held_by_another && !leads_to(AT_FDCWD, path, file_)) {
    file_ = open_own_file(path, O_RDWR);
    locking = try_to_lock(file_.number());
  }
  take(file_.number(), path, output, locking);
  leftover_.emplace(path);
}

OutputLock::~OutputLock() {
  if (getpid() != owner_) return;
  if (leads_to(AT_FDCWD, path_, file_)) unlink(path_.c_str());  // else it is another run's
}

void remove_stale_lock(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return;
  try {
    const OutputLock taken_over(path, path);
  } catch (const InputError&) {
  } catch (const EnvironmentError&) {
  }
}

std::string holder_of_lock(const std::string& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct flock whole_file = {};
  whole_file.l_type = F_WRLCK;
  whole_file.l_whence = SEEK_SET;
  const bool held = file.is_open() && fcntl(file.number(), F_GETLK, &whole_file) == 0 && whole_file.l_type != F_UNLCK;
  return held ? description(read_holder(file.number())) : "";
}

std::string folder_lock_path(const std::string& folder) { return std::filesystem::path(folder) / "run.lock"; }

}  // namespace tessera
