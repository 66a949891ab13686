// Sorts the sides of a polygon into rows of equal height, so that a query at one place looks only at the sides of its row.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// Refers to a ring, which must outlive it. Side i goes from point i - 1 to point i, side 0 from the last point.
class RingRows {
 public:
  explicit RingRows(const NestRing& ring);

  const NestRing& ring() const { return *ring_; }
  const NestBox& box() const { return box_; }
  NestPoint from(std::size_t side) const { return (*ring_)[side > 0 ? side - 1 : ring_->size() - 1]; }
  NestPoint to(std::size_t side) const { return (*ring_)[side]; }

  /// See tessera::contains().
  bool contains(NestPoint p) const;

  /// Calls visit(side) for each side whose bounding box meets the window; for some sides more than once.
  template <class Visit>
  void visit_sides(const NestBox& window, Visit visit) const {
    if (window.high.y < box_.low.y || window.low.y > box_.high.y) return;
    for (std::size_t at = begins_[row_of(window.low.y)]; at < begins_[row_of(window.high.y) + 1]; ++at) {
      const NestPoint a = from(sides_[at]), b = to(sides_[at]);
      if (std::max(a.x, b.x) >= window.low.x && std::min(a.x, b.x) <= window.high.x &&
          std::max(a.y, b.y) >= window.low.y && std::min(a.y, b.y) <= window.high.y)
        visit(std::size_t(sides_[at]));
    }
  }

 private:
  std::size_t rows() const { return begins_.size() - 1; }
  /// The row of y. It never falls where y grows. Places beyond the ring belong to the first or last row.
  std::size_t row_of(double y) const;
  std::pair<std::size_t, std::size_t> rows_of_side(std::size_t side) const;
  void divide(std::size_t rows);
  void fill();

  const NestRing* ring_;
  NestBox box_;
  double row_height_ = 0;
  std::vector<std::size_t> begins_;  // of each row: its first side in sides_; at the end, the number of sides
  std::vector<std::uint32_t> sides_;
};

}  // namespace tessera
