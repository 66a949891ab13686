// The text that `tessera library build` ends with.
#pragma once

#include <string>

#include "library/library_builder.h"

namespace tessera::cli {

/// What was merged and left out, and why files were skipped: for each reason how many, and the first names. Empty where
/// nothing of the kind happened; otherwise whole lines.
std::string build_summary(const LibraryBuildReport& report);

/// What became of all the files: "9 files: 5 shapes, 1 merged with these, 3 skipped".
std::string build_counts(const LibraryBuildReport& report);

}  // namespace tessera::cli
