// What a job's tables say about shapes and regions, by name, becomes what the algorithm knows, by index.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"
#include "job/pieces/named_shape.h"

namespace tessera {

/// Whether the job prefers a style.
bool wishes_style(const Job& job);

/// Whether resolve_wishes needs the names of the shapes, and their sizes.
bool has_shape_wishes(const Job& job);

/// Sets wishes and the whole range of sizes in the job's settings. `shapes`: of the library, in its order; `other_names`
/// were left out of it (NameIndex). Throws
/// InputError where a table names a shape or a region that there is not, two regions are alike, all shapes are to fit
/// into several regions, pieces of an earlier result are to be free in several, or a drawn size is wished for that is
/// unknown or not allowed.
void resolve_wishes(const std::vector<NamedShape>& shapes, Job& job, const std::vector<std::string>& other_names = {});

}  // namespace tessera
