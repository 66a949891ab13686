// The private state of the public class Library.
#pragma once

#include <string>
#include <vector>

#include "library/storage/library_file.h"
#include "tessera/matching/library.h"

namespace tessera::matching {

struct Library::State {
  LibraryFile file;
  std::vector<std::string> names;
};

}  // namespace tessera::matching
