// What a program asks of the disk, in its order: for the tests of what must be on the disk before what. The functions
// fsync, renameat and linkat of the whole test program are those of recorded_disk.cpp.
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace tessera::test {

/// While it lives, all flushes, renames and hard links of this program are recorded. One at a time.
class RecordedDisk {
 public:
  RecordedDisk();
  ~RecordedDisk();
  RecordedDisk(const RecordedDisk&) = delete;
  RecordedDisk& operator=(const RecordedDisk&) = delete;

  /// "flush a.txt.tmp (3 bytes)", "flush folder", "link a b", "rename a.txt.tmp a.txt": names without their folders,
  /// and the size at the moment of the flush.
  const std::vector<std::string>& steps() const { return steps_; }

  /// Every flush of a file fails from now on, with the reason ENOSPC: a disk that finds out late that it is full.
  void fail_flushes() { flushes_fail_ = true; }

  /// By any thread.
  void record(const std::string& step) {
    const std::lock_guard lock(mutex_);
    steps_.push_back(step);
  }
  bool flushes_fail() const { return flushes_fail_; }

 private:
  std::mutex mutex_;
  std::vector<std::string> steps_;
  bool flushes_fail_ = false;
};

}  // namespace tessera::test
