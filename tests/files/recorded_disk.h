// Records the program's requests to the disk in order, for tests of what must be on the disk first.
// The test program takes fsync, renameat and linkat from recorded_disk.cpp.
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace tessera::test {

/// While an object of this class lives, it records all flushes, renames and hard links of this program. Only one may live at a time.
class RecordedDisk {
 public:
  RecordedDisk();
  ~RecordedDisk();
  RecordedDisk(const RecordedDisk&) = delete;
  RecordedDisk& operator=(const RecordedDisk&) = delete;

  /// The steps: "flush a.txt.tmp (3 bytes)", "flush folder", "link a b", "rename a.txt.tmp a.txt". Names have no folders; the size is that
  /// at the flush.
  const std::vector<std::string>& steps() const { return steps_; }

  /// Makes every later flush of a file fail with ENOSPC, as on a disk that reports late that it is full.
  void fail_flushes() { flushes_fail_ = true; }

  /// Any thread may call it.
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
