// Tells apart what tessera collage may be given: a job, a folder of drawings, or a library.
#pragma once

#include <string>

namespace tessera::cli {

enum class CollageSource { job, drawings, library };

/// Tells what the path is, by its kind and its first bytes. Throws InputError for the folder of a result and for a picture, with
/// the right command, and where nothing is there and the name is not that of a job (.toml).
CollageSource collage_source(const std::string& path);

}  // namespace tessera::cli
