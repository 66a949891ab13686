// The part of the library that one rank matches: which shapes, read as models, on the devices of the job.
#pragma once

#include <memory>
#include <vector>

#include "core/matcher.h"
#include "io/job/job_file.h"
#include "io/library/library_file.h"

namespace tessera::cli {

/// Part `part` of `parts`; every shape has as many samples, so the parts have as many shapes, give or take one.
ShapeRange library_part(std::size_t shapes, int part, int parts);

/// A few shapes at a time are read whole: the models need a twentieth of their memory.
std::vector<ShapeModel> read_models(const io::LibraryFile& library, const ShapeRange& range,
                                    const MatchingContext& context);

}  // namespace tessera::cli
