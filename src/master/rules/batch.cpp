#include "master/rules/batch.h"

#include <algorithm>

#include "core/settings/tuning.h"

namespace tessera::master {
namespace {

constexpr int kCell_nodes = 8;

int cells(int nodes) { return (nodes + kCell_nodes - 1) / kCell_nodes; }

/// The cells that overlap a window of the field.
Window cells_of(const Window& w) { return {w.x0 / kCell_nodes, w.y0 / kCell_nodes, cells(w.x1), cells(w.y1)}; }

}  // namespace

Batch::Batch(const PeriodicGrid& grid, const CollageSettings& settings)
    : grid_(grid),
      clearance_px_(int(kBatchClearance * settings.pieces.max_scale_px)),
      least_part_(settings.colour ? kBatchWorthInPicture : kBatchWorth),
      taken_(cells(grid.nodes().x1), cells(grid.nodes().y1), 0) {}

void Batch::add(const Window& touched, const Window& stamped, float worth) {
  if (!is_open()) first_worth_ = worth;
  touched_.push_back(touched);
  stamped_.push_back(stamped);
  take(touched.grown(clearance_px_));
}

void Batch::end() {
  touched_.clear();
  stamped_.clear();
  std::fill(taken_.data().begin(), taken_.data().end(), std::uint8_t(0));
}

/// Calls row(y, first, last) for the cells of each row of the window and its images, until one call is true.
template <class Row>
bool Batch::any_row(const Window& window, Row row) const {
  for (const Window& part : grid_.images(window, grid_.nodes())) {
    const Window in_cells = cells_of(part);
    for (int y = in_cells.y0; y < in_cells.y1; ++y) {
      if (row(y, in_cells.x0, in_cells.x1)) return true;
    }
  }
  return false;
}

void Batch::take(const Window& window) {
  any_row(window, [&](int y, int x0, int x1) {
    std::fill(taken_.row(y) + x0, taken_.row(y) + x1, std::uint8_t(1));
    return false;
  });
}

bool Batch::has_room_for(const Window& candidate) const {
  return !any_row(candidate, [&](int y, int x0, int x1) {
    return std::find(taken_.row(y) + x0, taken_.row(y) + x1, 1) != taken_.row(y) + x1;
  });
}

bool Batch::touches(const Window& candidate) const {
  return std::any_of(touched_.begin(), touched_.end(),
                     [&](const Window& touched) { return grid_.overlap(touched, candidate); });
}

bool Batch::set_taken(const std::vector<std::uint8_t>& taken) {
  if (taken.size() != taken_.data().size()) return false;
  std::copy(taken.begin(), taken.end(), taken_.data().begin());
  return true;
}

}  // namespace tessera::master
