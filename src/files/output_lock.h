// A lock on an output, so that one run at a time writes it. The system frees the lock when its process ends; a small
// file says who holds it. It works on one machine, and across machines where their file system shares locks.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "files/file_descriptor.h"
#include "files/leftover_file.h"

namespace tessera {

class OutputLock {
 public:
  /// `path`: the file of the lock. It is removed at the end, also where a library ends the process by exit(3).
  /// `output`: the locked output, for messages. Throws InputError, which names the other run's process and machine,
  /// where another run is at work. The same where a run on another machine ended without removing the file, unless it
  /// was this Slurm job before it was queued again. Throws EnvironmentError where the file cannot be written or is not
  /// our own (own_file.h).
  OutputLock(const std::string& path, const std::string& output);
  ~OutputLock();
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;

 private:
  std::string path_;
  FileDescriptor file_;
  pid_t owner_;                           // a forked child has a copy of this object, but not the lock
  std::optional<LeftoverFile> leftover_;  // set once we hold the lock
};

/// Removes the file of a lock whose process has ended. Does nothing where there is no file, or where its run may still
/// be at work.
void remove_stale_lock(const std::string& path);

/// The holder of the lock file, "process 71 on node7"; empty where nobody holds it. A process that may hold the lock
/// itself must not call it: the system frees a process' lock as soon as the process closes the file once.
std::string holder_of_lock(const std::string& path);

/// The path of the lock file of a result folder or a campaign folder.
std::string folder_lock_path(const std::string& folder);

}  // namespace tessera
