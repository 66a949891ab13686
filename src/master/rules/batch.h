// A batch: the pieces that are placed before candidates are matched and measured again. Each is the best candidate of its
// surroundings and stands far from the others, so that it would have been chosen soon, at the same place. Without batches a
// canvas would need as many rounds as it has pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/periodic_grid.h"
#include "core/settings/settings.h"

namespace tessera::master {

class Batch {
 public:
  /// `grid`: of the free field; it outlives the batch.
  Batch(const PeriodicGrid& grid, const CollageSettings& settings);

  /// Adds a piece that was placed. It changed the nodes `stamped` of the free field, and the terms of candidates whose
  /// windows overlap `touched`. The worth of the first piece decides which others may join.
  void add(const Window& touched, const Window& stamped, float worth);
  /// Keeps a candidate out until it is measured again, and with it all worse ones that overlap its window.
  void hold_back(const Window& candidate) { take(candidate); }
  void end();

  bool is_open() const { return !touched_.empty(); }
  std::size_t pieces() const { return touched_.size(); }
  float first_worth() const { return first_worth_; }
  const std::vector<Window>& touched() const { return touched_; }
  const std::vector<Window>& stamped() const { return stamped_; }

  /// The least worth of a candidate that may join. What is worth little waits for neighbours that it may fit better.
  float least_worth() const { return is_open() ? least_part_ * first_worth_ : 0; }
  /// Whether a candidate with this window may join: no piece is near, and no better candidate waits there.
  bool has_room_for(const Window& candidate) const;
  /// Whether a piece touches the candidate with this window, so that it has to be measured again.
  bool touches(const Window& candidate) const;

  /// The places that are taken, for checkpoints: a number for each cell, row by row.
  const std::vector<std::uint8_t>& taken() const { return taken_.data(); }
  /// Sets them. Returns false where there are not as many cells.
  bool set_taken(const std::vector<std::uint8_t>& taken);

 private:
  void take(const Window& window);
  template <class Row>
  bool any_row(const Window& window, Row row) const;

  const PeriodicGrid& grid_;
  int clearance_px_;
  float least_part_;  // of the first piece's worth
  std::vector<Window> touched_;
  std::vector<Window> stamped_;
  float first_worth_ = 0;
  Grid<std::uint8_t> taken_;  // cells of the field where nothing may join; images of a period are taken with it
};

}  // namespace tessera::master
