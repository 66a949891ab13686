// What a job's tables say about shapes and regions, by name, becomes what the algorithm knows, by index.
#pragma once

#include <string>
#include <vector>

#include "io/job/job_file.h"

namespace tessera::io {

/// Whether resolve_wishes needs the names of the shapes.
bool has_shape_wishes(const Job& job);

/// Sets wishes and the whole range of sizes in the job's settings. `shape_names`: of the library, in its order. Throws
/// InputError where a table names a shape or a region that there is not, two regions are alike, or all shapes are to fit
/// into several regions.
void resolve_wishes(const std::vector<std::string>& shape_names, Job& job);

}  // namespace tessera::io
