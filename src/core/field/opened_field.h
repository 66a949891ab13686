// The free region without the parts that are too narrow for a piece. The target curve is traced on it, and it tells
// where target samples are useful.
#pragma once

#include <cstdint>
#include <vector>

#include "core/field/free_field.h"

namespace tessera {

class OpenedField {
 public:
  OpenedField(const FreeField& free, const PieceSettings& pieces);

  /// Recomputes everything that depends on the nodes of these windows, on the rank's threads. Returns the windows of the
  /// result that may have changed, one for each.
  std::vector<Window> update(const FreeField& free, const std::vector<Window>& changed);

  const PeriodicGrid& grid() const { return grid_; }
  /// The free field opened by discs of opening_radius_px: positive where such a disc fits over the node. It is valid at
  /// grid().with_next_nodes().
  const Grid<float>& contour() const { return contour_; }
  /// Whether a disc of reachable_radius_px fits over the node or touches it.
  bool reachable(int x, int y) const { return reachable_(grid_.column(x), grid_.row(y)) != 0; }

 private:
  void update_part(const Grid<float>& distance, const Window& part);
  void open(const Grid<float>& distance, const Window& window);
  void mark_reachable(const Grid<float>& distance, const Window& window);

  PeriodicGrid grid_;
  float opening_px_;
  float reachable_px_;
  Grid<float> contour_;
  Grid<std::uint8_t> reachable_;
  Grid<float> to_middle_;  // distance of each node of the largest drawn disc to its middle
};

}  // namespace tessera
