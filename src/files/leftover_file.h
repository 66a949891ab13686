// Files that must not stay when a signal, or exit() within a library, ends the process: locks, and files with a
// temporary name. At every other end their owners remove them.
#pragma once

#include <string>

namespace tessera {

/// While it lives, remove_leftover_files() removes this file, or this folder if it is empty. The object itself neither
/// creates nor removes anything.
class LeftoverFile {
 public:
  explicit LeftoverFile(const std::string& path);
  ~LeftoverFile();
  LeftoverFile(const LeftoverFile&) = delete;
  LeftoverFile& operator=(const LeftoverFile&) = delete;

 private:
  int slot_ = -1;  // in the table; -1: the table is full, or the path too long
};

/// Removes the files, then the empty folders, of all living LeftoverFile objects. A signal handler may call it.
void remove_leftover_files();

}  // namespace tessera
