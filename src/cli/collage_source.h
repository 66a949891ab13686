// Tells apart what tessera collage can be given: a job, a folder of drawings, or a library.
#pragma once

#include <string>

namespace tessera::cli {

enum class CollageSource { job, drawings, library };

/// The kind of the path, found from its type and its first bytes. Throws InputError, with the right command, for the
/// folder of a result and for a picture; also where nothing is there and the name is not that of a job (.toml).
CollageSource collage_source(const std::string& path);

}  // namespace tessera::cli
