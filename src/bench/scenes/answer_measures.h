// Measures of how good the best answer to a query is: a small one tells a shape that the library has not.
#pragma once

#include <vector>

#include "bench/blocking/pad_recogniser.h"
#include "bench/blocking/twins.h"

namespace tessera::bench {

/// All are 0 where there is no answer.
struct AnswerMeasures {
  double similarity = 0;  // Recognition::similarity: by closeness, the followed length in parts of the query's
  double margin = 0;      // the similarity less that of the first answer that is another shape, no twin of the best one
  double score = 0;       // answer_score(): the same length in parts of the geometric mean of both lengths
};

/// `found`: the answers, the best first.
AnswerMeasures answer_measures(const std::vector<Recognition>& found, const SilhouetteLibrary& library,
                               const Twins& twins);

}  // namespace tessera::bench
