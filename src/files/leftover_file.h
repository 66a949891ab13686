// Files that must not stay where a signal, or exit() within a library, ends the process: locks, and what still has a
// temporary name. Their owners remove them at every other end.
#pragma once

#include <string>

namespace tessera {

/// While it lives, remove_leftover_files() removes this file, or this folder if it is empty. The object itself neither
/// makes nor removes anything.
class LeftoverFile {
 public:
  explicit LeftoverFile(const std::string& path);
  ~LeftoverFile();
  LeftoverFile(const LeftoverFile&) = delete;
  LeftoverFile& operator=(const LeftoverFile&) = delete;

 private:
  int slot_ = -1;  // of the table; -1: the table is full, or the path too long
};

/// Removes the files and then the empty folders of all LeftoverFile objects that live. A signal handler may call it.
void remove_leftover_files();

}  // namespace tessera
