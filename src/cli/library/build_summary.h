// The text at the end of `tessera library build`.
#pragma once

#include <string>

#include "library/library_builder.h"

namespace tessera::cli {

/// The files that were merged, left out or skipped: their number and first names for each reason. Empty where all files
/// were used; otherwise whole lines.
std::string build_summary(const LibraryBuildReport& report);

/// The number of files by outcome: "9 files: 5 shapes, 1 merged with these, 3 skipped".
std::string build_counts(const LibraryBuildReport& report);

}  // namespace tessera::cli
