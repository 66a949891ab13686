// Resolves what a job's tables say about shapes and regions by name into what the algorithm uses, by index.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"
#include "job/pieces/named_shape.h"

namespace tessera {

/// Whether the job prefers a style.
bool wishes_style(const Job& job);

/// Whether resolve_wishes needs the names and sizes of the shapes.
bool has_shape_wishes(const Job& job);

/// Sets the wishes and the whole range of sizes in the job's settings. `shapes`: those of the library, in its order;
/// `other_names` were left out of it (NameIndex). Throws InputError where
/// - a table names a shape or a region that does not exist, or two regions have the same name or colour,
/// - pieces.fit = "all" is given with several regions, or free pieces of an earlier result are,
/// - a drawn size is wished for that is unknown or not allowed.
void resolve_wishes(const std::vector<NamedShape>& shapes, Job& job, const std::vector<std::string>& other_names = {});

}  // namespace tessera
