// A batch: the pieces that are placed before candidates are matched and measured again. The first one is the best
// candidate. The others are worth nearly as much and stand far from all earlier ones, so that they would have been chosen
// soon, at the same place. Without batches a canvas would need as many rounds as it has pieces.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/geometry/periodic_grid.h"
#include "core/settings/settings.h"
#include "core/settings/tuning.h"

namespace tessera::master {

class Batch {
 public:
  /// `grid`: of the free field; it outlives the batch.
  Batch(const PeriodicGrid& grid, const PieceSettings& pieces)
      : grid_(grid),
        clearance_px_(int(kBatchClearance * pieces.max_scale_px)) {}

  /// Adds a piece that was placed. It changed the nodes `stamped` of the free field, and the terms of candidates whose
  /// windows overlap `touched`. The worth of the first piece decides which others may join.
  void add(const Window& touched, const Window& stamped, float worth) {
    if (!is_open()) first_worth_ = worth;
    touched_.push_back(touched);
    stamped_.push_back(stamped);
  }
  void end() {
    touched_.clear();
    stamped_.clear();
  }

  bool is_open() const { return !touched_.empty(); }
  std::size_t pieces() const { return touched_.size(); }
  float first_worth() const { return first_worth_; }
  const std::vector<Window>& touched() const { return touched_; }
  const std::vector<Window>& stamped() const { return stamped_; }

  /// The least worth of a candidate that may join.
  float least_worth() const { return is_open() ? kBatchWorth * first_worth_ : 0; }
  /// Whether a candidate with this window stands too near to join.
  bool is_near(const Window& candidate) const { return any_overlaps(candidate.grown(clearance_px_)); }
  /// Whether a piece touches the candidate with this window, so that it has to be measured again.
  bool touches(const Window& candidate) const { return any_overlaps(candidate); }

 private:
  bool any_overlaps(const Window& window) const {
    return std::any_of(touched_.begin(), touched_.end(),
                       [&](const Window& touched) { return grid_.overlap(touched, window); });
  }

  const PeriodicGrid& grid_;
  int clearance_px_;
  std::vector<Window> touched_;
  std::vector<Window> stamped_;
  float first_worth_ = 0;
};

}  // namespace tessera::master
