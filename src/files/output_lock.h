// One run at a time writes an output: a lock that the system takes back from a process that is gone, with a small file
// that says whose it is. It holds on one machine, and across machines where their file system has locks for all of
// them.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "files/file_descriptor.h"
#include "files/leftover_file.h"

namespace tessera {

class OutputLock {
 public:
  /// `path`: the file of the lock, removed at the end, also where a library ends the process by exit(3); `output`: what
  /// it protects, for messages. Throws InputError that names the other run's process and machine where one is at work,
  /// and also where a run of another machine is gone without a word, unless it is this Slurm job before it was queued
  /// again. Throws EnvironmentError where the file cannot be written, or is none that is our own (own_file.h).
  OutputLock(const std::string& path, const std::string& output);
  ~OutputLock();
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;

 private:
  std::string path_;
  FileDescriptor file_;
  pid_t owner_;                           // a child process has a copy of this object, but not the lock
  std::optional<LeftoverFile> leftover_;  // from when the lock is ours
};

/// Removes the file of a lock whose process is gone. Nothing where there is none, or where its run may still be at work.
void remove_stale_lock(const std::string& path);

/// "process 71 on node7", which holds the lock of this file; empty where none does. Not for who may hold it itself: the
/// system takes a process' lock back as soon as it closes the file once.
std::string holder_of_lock(const std::string& path);

/// The file of the lock of a result's folder, or of a campaign's.
std::string folder_lock_path(const std::string& folder);

}  // namespace tessera
