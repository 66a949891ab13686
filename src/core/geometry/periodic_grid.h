// The nodes of a grid that holds one period of a plane and a rim of its images around it. A window, wherever it lies,
// stands for all of its images. A grid that does not repeat is one period without a rim.
#pragma once

#include <vector>

#include "core/geometry/grid.h"
#include "core/geometry/period.h"

namespace tessera {

/// A periodic grid; nodes are 1 px apart.
class PeriodicGrid {
 public:
  PeriodicGrid() = default;
  explicit PeriodicGrid(const Window& nodes) : nodes_(nodes), one_period_(nodes) {}
  /// `one_period` has the size of the period in directions that repeat, and the size of `nodes` in the others.
  PeriodicGrid(const Window& nodes, const Window& one_period, const Period& period)
      : nodes_(nodes),
        one_period_(one_period),
        period_(period) {}

  const Window& nodes() const { return nodes_; }
  const Window& one_period() const { return one_period_; }
  const Period& period() const { return period_; }
  /// One period and, in directions that repeat, the next column and row: the far ends of the period's edges.
  Window with_next_nodes() const {
    return {one_period_.x0, one_period_.y0, one_period_.x1 + (period_.x_px > 0), one_period_.y1 + (period_.y_px > 0)};
  }

  /// Column and row of a node's image in the one period.
  int column(int x) const { return image(x, period_.x_px, one_period_.x0); }
  int row(int y) const { return image(y, period_.y_px, one_period_.y0); }

  /// The window, cut off where the grid ends without repeating.
  Window clipped(const Window& window) const;
  /// The parts of the window's images that lie in `bounds`; they cover that area, and none is empty.
  std::vector<Window> images(const Window& window, const Window& bounds) const;
  /// Whether some image of one window overlaps the other window.
  bool overlap(const Window& a, const Window& b) const;
  /// The smallest window that contains `a` and the image of `b` nearest to `a`.
  Window united(const Window& a, const Window& b) const;

  /// Copies the values of the one period in `window` to all images in `bounds`.
  template <class T>
  void spread(Grid<T>& values, const Window& window, const Window& bounds) const;

 private:
  static int image(int at, int period, int begin) {
    if (period == 0) return at;
    const int offset = (at - begin) % period;
    return begin + (offset < 0 ? offset + period : offset);
  }

  Window nodes_;
  Window one_period_;
  Period period_;
};

template <class T>
void PeriodicGrid::spread(Grid<T>& values, const Window& window, const Window& bounds) const {
  if (!period_.repeats()) return;
  for (const Window& part : images(window, bounds)) {
    for (int y = part.y0; y < part.y1; ++y) {
      const int from_y = row(y);
      for (int x = part.x0; x < part.x1;) {
        const int from_x = column(x);
        const int count = std::min(part.x1 - x, one_period_.x1 - from_x);
        if (from_x != x || from_y != y) std::copy_n(values.row(from_y) + from_x, count, values.row(y) + x);
        x += count;
      }
    }
  }
}

}  // namespace tessera
