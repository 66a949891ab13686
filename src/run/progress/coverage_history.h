// Records how coverage rose during a run, so that the card can say whether more time pays.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "result/folder/run_record.h"

namespace tessera {

class CoverageHistory {
 public:
  /// `seconds` must not fall from call to call. `coverage`: fraction of the canvas; empty where it is not known.
  void add(double seconds, std::optional<double> coverage);

  /// The gain of coverage from nine tenths of `total_s` to the end; negative where pieces were taken out. Empty where one
  /// of the two is not known (the run may have been resumed later), or where the run is too short.
  std::optional<double> gained_in_last_tenth(double total_s) const;

  /// The known moments, at most `most`, evenly picked; the latest is one of them.
  std::vector<GrowthMoment> growth(std::size_t most) const;

 private:
  struct Moment {
    double seconds;
    std::optional<double> coverage;
  };
  /// The moments; in a long run only every 2nd, 4th, ... of them.
  std::vector<Moment> moments_;
  std::size_t every_ = 1;
  std::size_t added_ = 0;
  Moment latest_{};
};

}  // namespace tessera
