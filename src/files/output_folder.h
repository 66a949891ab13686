// A folder that a command will write into. The errors say what to do: InputError where a file has the folder's name,
// otherwise EnvironmentError.
#pragma once

#include <deque>
#include <string>

#include "files/leftover_file.h"

namespace tessera {

/// Throws EnvironmentError, which names a file in `folder`, where no file with content can be made in it.
void check_takes_files(const std::string& folder);

/// Makes the folder with its parents; they stay.
void make_folder(const std::string& folder);

/// Makes the folder with its parents before the work begins, so that an output that cannot be written is found at once.
/// The destructor, or a signal that ends the process, removes the folders that it made and that are still empty.
class OutputFolder {
 public:
  /// An empty path means the current folder. Throws where the folder cannot be made or takes no files.
  explicit OutputFolder(const std::string& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  void make(const std::string& folder);

  std::deque<std::string> made_;  // each after its parent
  std::deque<LeftoverFile> leftovers_;
};

}  // namespace tessera
