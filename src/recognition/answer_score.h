// The score of an answer: it tells whether the library has the query's shape at all.
#pragma once

#include "core/geometry/polygon.h"
#include "core/recognition/recognition.h"

namespace tessera {

/// How much of query and shape follow one another, and how closely (CurveMatch::score): 0 to about 1; a shape and itself
/// have 1. Both similarity and score take the length that the shape follows, weighted by closeness. The similarity divides
/// it by the query's length, the score by the geometric mean of the query's and the shape's lengths. So a query of which a
/// fence or another shape is a part may have a low similarity and a good score. For a small piece of boundary that fits on
/// some large shape it is the other way round. `outline`: of the answer, in the shape frame.
double answer_score(const Recognition& answer, const Outline& outline);

}  // namespace tessera
