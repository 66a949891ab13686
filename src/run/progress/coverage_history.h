// How the coverage of a run rose over its time, so that its card can say whether more time pays.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace tessera {

class CoverageHistory {
 public:
  /// `seconds` do not fall from call to call; `coverage` is a fraction of the canvas; nothing: not known then.
  void add(double seconds, std::optional<double> coverage);

  /// What was covered more at the end than at nine tenths of `total_s`; negative where pieces were taken out. Nothing
  /// where one of both is not known, also as the run was resumed later, or where it is too short to tell.
  std::optional<double> gained_in_last_tenth(double total_s) const;

 private:
  struct Moment {
    double seconds;
    std::optional<double> coverage;
  };
  /// Of a long run every 2nd, 4th, .. moment is kept, and the latest.
  std::vector<Moment> moments_;
  std::size_t every_ = 1;
  std::size_t added_ = 0;
  Moment latest_{};
};

}  // namespace tessera
