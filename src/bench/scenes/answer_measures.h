// Measures for the quality of the best answer to a query: a small value means that the library does not have the shape.
#pragma once

#include <vector>

#include "bench/blocking/pad_recogniser.h"
#include "bench/blocking/twins.h"

namespace tessera::bench {

/// The measures; all are 0 where there is no answer.
struct AnswerMeasures {
  double similarity = 0;  // Recognition::similarity: weighted length of the match / query's length
  double margin = 0;      // similarity minus that of the next answer that is no twin of the best one
  double score = 0;       // answer_score(): the same length / geometric mean of both lengths
};

/// `found`: the answers, the best first.
AnswerMeasures answer_measures(const std::vector<Recognition>& found, const SilhouetteLibrary& library,
                               const Twins& twins);

}  // namespace tessera::bench
