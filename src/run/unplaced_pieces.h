// The pieces that a finished collage lacks: counted, named, and why as far as that can be known.
#pragma once

#include <string>
#include <vector>

#include "master/collage_loop.h"
#include "result/missing_shape.h"
#include "run/collage_input.h"
#include "run/collage_problem.h"
#include "run/refined_result.h"

namespace tessera {

/// Of a finished collage; empty of an unfinished one, which may still get them.
std::vector<MissingShape> missing_shapes(const CanvasProblem& problem, const master::CollageResult& result);

/// Why the collage is empty, or which of `missing` found no place, and what helps. Empty where nothing is missing, and
/// where the run may still go on. `refined`: from whose pieces it began; null: none.
std::string unplaced_warning(const CollageInput& input, const master::CollageResult& result,
                             const std::vector<MissingShape>& missing, const RefinedResult* refined);

/// Names the regions in which no piece lies, and says what helps. Empty where there are none, and of an empty collage.
std::string empty_regions_warning(const CanvasProblem& problem, const master::CollageResult& result);

/// Names the shapes that fit nowhere on the canvas in a size or rotation of their own ([[shapes]], or as drawn), so that
/// none of them stands, and says what helps; those that the job counts are told elsewhere. Empty where there are no
/// such shapes, and for an empty collage.
std::string never_fitting_warning(const CanvasProblem& problem, const master::CollageResult& result);

}  // namespace tessera
