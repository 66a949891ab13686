// Counts and names the pieces that a finished collage lacks, and says why, as far as that can be known.
#pragma once

#include <string>
#include <vector>

#include "master/collage_loop.h"
#include "result/missing_shape.h"
#include "run/collage_input.h"
#include "run/collage_problem.h"
#include "run/refined_result.h"

namespace tessera {

/// The shapes that a finished collage lacks. Empty for an unfinished collage, which may still get them.
std::vector<MissingShape> missing_shapes(const CanvasProblem& problem, const master::CollageResult& result);

/// Says why the collage is empty, or which of `missing` found no place, and what helps. Empty where nothing is missing and
/// for a run that may go on. `refined`: the result whose pieces it began with; null: none.
std::string unplaced_warning(const CollageInput& input, const master::CollageResult& result,
                             const std::vector<MissingShape>& missing, const RefinedResult* refined);

/// Names the regions in which no piece lies, and says what helps. Empty where there are none, and for an empty collage.
std::string empty_regions_warning(const CanvasProblem& problem, const master::CollageResult& result);

/// Names shapes that fit nowhere on the canvas, because of a size or rotation of their own ([[shapes]], or as drawn), and
/// says what helps. Shapes that the job counts are in unplaced_warning(). Empty where there are none, and for an empty
/// collage.
std::string never_fitting_warning(const CanvasProblem& problem, const master::CollageResult& result);

}  // namespace tessera
