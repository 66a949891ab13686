// The text that `tessera library build` ends with.
#pragma once

#include <string>

#include "io/library/library_builder.h"

namespace tessera::cli {

/// What was merged and left out, and a table of the reasons why files were skipped: how many, and the first names.
/// Empty where nothing of the kind happened; otherwise whole lines.
std::string build_summary(const io::LibraryBuildReport& report);

}  // namespace tessera::cli
