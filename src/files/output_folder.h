// A folder that a command will write into. What is thrown here says what to do: InputError where a file is in the
// folder's way, else EnvironmentError.
#pragma once

#include <deque>
#include <string>

#include "files/leftover_file.h"

namespace tessera {

/// Throws EnvironmentError, which names a file in `folder`, where none with something in it can be made.
void check_takes_files(const std::string& folder);

/// Makes the folder with its parents, to stay.
void make_folder(const std::string& folder);

/// Makes the folder with its parents before the work begins, so that what cannot be written is found at once. Of the
/// folders that it made those that are still empty go with the object, and also where a signal ends the process.
class OutputFolder {
 public:
  /// An empty path is the current folder. Throws where it cannot be made or where no file can be made in it.
  explicit OutputFolder(const std::string& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  void make(const std::string& folder);

  std::deque<std::string> made_;  // each after the one that it lies in
  std::deque<LeftoverFile> leftovers_;
};

}  // namespace tessera
