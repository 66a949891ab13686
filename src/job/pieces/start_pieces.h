// The pieces of an earlier result from which a collage starts (start.pieces). The file may be foreign and edited.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"
#include "job/pieces/named_shape.h"
#include "library/storage/shape_library.h"

namespace tessera {

/// The file of start.pieces: the file itself, or pieces.geojson in that folder. Empty: none.
std::string start_file(const Job& job);

/// Adds the pieces of that file behind the pieces that the job gives (Wishes::given), locked ones first. Pieces that
/// the job gives already are left out; pieces to be removed go into StartSpec::removed. `shapes`: those of the library,
/// in its order. Throws InputError that names the file, the feature, what was found and what is allowed.
void add_start_pieces(const std::vector<NamedShape>& shapes, Job& job);

/// Throws InputError where that file lies in the folder that the run writes: the run would replace it.
void check_start_is_elsewhere(const Job& job, const std::string& folder);

}  // namespace tessera
