// Precision and recall, where an answer is given only if a measure of the best shape reaches a threshold.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tessera::bench {

/// The best shape for one query.
struct Verdict {
  double measure = 0;  // quality of the answer; larger is better
  bool told = false;   // whether there is an answer
  bool right = false;
  bool known = false;  // whether the library has the shape of the query
};

/// The counts for the threshold `least`: answers below it become "unknown".
struct PrecisionRecall {
  double least = 0;
  std::size_t right = 0;  // answers
  std::size_t given = 0;  // answers
  std::size_t known = 0;  // queries

  /// Right answers divided by given answers; 1 where none was given.
  double precision() const { return given == 0 ? 1 : double(right) / double(given); }
  /// Right answers divided by queries of known shapes; 1 where there are no such queries.
  double recall() const { return known == 0 ? 1 : double(right) / double(known); }
  /// The harmonic mean of both (van Rijsbergen 1979); 0 where no answer is right.
  double f1() const {
    const std::size_t all = given + known;
    return all == 0 ? 0 : 2 * double(right) / double(all);
  }
};

PrecisionRecall precision_recall(std::span<const Verdict> verdicts, double least);

/// The threshold with the largest F1; the highest of equals. It is the measure of one of the verdicts.
PrecisionRecall best_threshold(std::span<const Verdict> verdicts);

}  // namespace tessera::bench
