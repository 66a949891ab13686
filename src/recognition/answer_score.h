// The score of an answer: it tells whether the library has the query's shape at all.
#pragma once

#include "core/geometry/polygon.h"
#include "core/recognition/recognition.h"

namespace tessera {

/// How much of both follows one another, and how closely (CurveMatch::score): 0 to about 1, 1 of a shape and itself. The
/// similarity is the length that the shape follows, by closeness, in parts of the query's length; this is the same length
/// in parts of the geometric mean of the query's and the shape's. So a query of which a fence or another shape is a part
/// may have a low similarity and a good score, and a small piece of boundary that fits on some large shape the contrary.
/// `outline`: of the answer, shape frame.
double answer_score(const Recognition& answer, const Outline& outline);

}  // namespace tessera
