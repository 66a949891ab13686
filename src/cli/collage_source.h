// What tessera collage is given: a job, or drawings for a first collage.
#pragma once

#include <string>

namespace tessera::cli {

enum class CollageSource { job, drawings, library };

/// What the path is, by its kind and its first bytes. Throws InputError, with the command that is right, where it is the
/// folder of a result or a picture.
CollageSource collage_source(const std::string& path);

}  // namespace tessera::cli
