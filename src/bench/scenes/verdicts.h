// Precision and recall of answers that are given only where a measure of the best shape is large enough.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tessera::bench {

/// The best shape for one query.
struct Verdict {
  double measure = 0;  // of how good the answer is; the larger the better
  bool told = false;   // whether there is an answer at all
  bool right = false;
  bool known = false;  // whether the library has what the query shows
};

/// The counts where answers with at least this measure are given, and "unknown" else.
struct PrecisionRecall {
  double least = 0;
  std::size_t right = 0;  // answers
  std::size_t given = 0;  // answers
  std::size_t known = 0;  // queries

  /// The right ones of the answers that were given; 1 where none was given.
  double precision() const { return given == 0 ? 1 : double(right) / double(given); }
  /// The right answers to queries of known shapes; 1 where there are none of these.
  double recall() const { return known == 0 ? 1 : double(right) / double(known); }
  /// The harmonic mean of both (van Rijsbergen 1979); 0 where no answer is right.
  double f1() const {
    const std::size_t all = given + known;
    return all == 0 ? 0 : 2 * double(right) / double(all);
  }
};

PrecisionRecall precision_recall(std::span<const Verdict> verdicts, double least);

/// The threshold of the largest F1, which is the measure of one of the verdicts; the highest of equals.
PrecisionRecall best_threshold(std::span<const Verdict> verdicts);

}  // namespace tessera::bench
