// A folder of files that belong together: either all of them are written, or none stays.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/stop.h"
#include "files/output_folder.h"
#include "files/output_lock.h"

namespace tessera {

struct NewFile {
  std::string name;  // relative to the folder; may lie in a subfolder
  std::vector<std::uint8_t> bytes;
};

/// Makes the folder, or takes an existing empty one, and locks it against other runs. The destructor, or a signal that
/// ends the process, removes it while it is empty.
class NewFolder {
 public:
  /// Throws InputError where the folder is not empty or another run is at work in it; EnvironmentError where it cannot
  /// be made.
  explicit NewFolder(const std::string& folder);

  /// Writes all files. Where that fails it removes them and throws EnvironmentError, or what `check_stop` has thrown;
  /// it calls `check_stop` before each file.
  void write(const std::vector<NewFile>& files, const StopCheck& check_stop);

 private:
  std::string folder_;
  OutputFolder made_;
  OutputLock lock_;
};

}  // namespace tessera
