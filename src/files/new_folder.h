// A folder of files that belong together: all of them are written, or none stays.
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
  std::string name;  // in the folder, or in a folder in it
  std::vector<std::uint8_t> bytes;
};

/// Makes the folder, or takes one that is there and empty, and keeps other runs away from it. While nothing is in it, it
/// goes with the object, or where a signal ends the process.
class NewFolder {
 public:
  /// Throws InputError where the folder holds something or another run is at work in it; EnvironmentError.
  explicit NewFolder(const std::string& folder);

  /// All of them, or none: then what `check_stop`, which is called before each, has thrown, or EnvironmentError.
  void write(const std::vector<NewFile>& files, const StopCheck& check_stop);

 private:
  std::string folder_;
  OutputFolder made_;
  OutputLock lock_;
};

}  // namespace tessera
