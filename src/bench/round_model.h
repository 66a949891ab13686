// A model of the costs of a round, for any number of workers and shapes, from measured runs.
//
// A stage's time is a sum of parts. Each part grows with something known: the shapes of a worker (every pair is
// tested), its share of the dockings (a fixed number over the whole library), the workers that the master asks itself,
// or nothing. The measured runs give the size of each part: by least squares with no part below zero.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/scaling_case.h"

namespace tessera::bench {

/// Coefficients >= 0 with which features * coefficients comes nearest to `values`; rows of `features` are observations.
std::vector<double> fit_non_negative(const std::vector<std::vector<double>>& features,
                                     const std::vector<double>& values);

struct Load {
  int workers = 1;
  std::uint64_t shapes = 0;
  double samples = 0;  // number of matched samples
};

/// The clock for times of measured runs: wall-clock time, or time without the time that other programs took
/// (ScalingCase::undisturbed_s).
enum class Clock { wall, processor };

/// A mean round. Seconds and bytes are for each request and worker, unless noted otherwise.
struct RoundCosts {
  int workers = 1;
  int counts = 1;       // requests of that kind; dock, refine and measure are requested once
  double master_s = 0;  // a round: merge, objective, other
  double ahead_s = 0;   // a round: work while the workers dock
  double ask_s = 0;     // the master, for each worker that it sends a request to; the field's patch counts, too
  double join_s = 0;    // the master, for each answer
  double field_s = 0;
  double count_s = 0;
  double dock_s = 0;
  double refine_s = 0;
  double measure_s = 0;
  double messages_s = 0;  // a worker, for each request
  double notice_s = 0;    // from the arrival of a message until the sleeping rank notices it
  double imbalance = 0;   // fraction by which a worker's times differ
  double field_bytes = 0;
  double request_bytes = 0;  // count and dock
  double reply_bytes = 0;
  double refine_request_bytes = 0;
  double refine_reply_bytes = 0;

  int questions() const { return counts + 3; }
};

class RoundModel {
 public:
  /// `cases` must not be empty.
  RoundModel(std::vector<ScalingCase> cases, Clock clock);

  /// The costs with as many samples as in the measured loops.
  RoundCosts costs(int workers, std::uint64_t shapes) const;
  /// Pieces that a round places, the median of the cases.
  double pieces_of_a_round() const { return pieces_of_a_round_; }
  /// The cases, with the times of the model's clock.
  const std::vector<ScalingCase>& cases() const { return cases_; }

 private:
  using Figure = double (*)(const ScalingCase&);
  using Features = std::vector<double> (*)(const Load&);
  struct Part {
    Features features;
    std::vector<double> coefficients;
    double at(const Load& job) const;
  };
  Part fit(Figure figure, Features features) const;

  std::vector<ScalingCase> cases_;  // with the times of the clock
  double pieces_of_a_round_ = 1;
  double samples_ = 0;
  double notice_s_ = 0;
  double imbalance_ = 0;
  double counts_ = 1;
  Part master_, count_, dock_, refine_, measure_, field_, messages_, ahead_, field_bytes_, to_worker_, from_worker_;
};

}  // namespace tessera::bench
