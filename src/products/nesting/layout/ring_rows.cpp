#include "products/nesting/layout/ring_rows.h"

#include <numeric>

namespace tessera {

RingRows::RingRows(const NestRing& ring) : ring_(&ring), box_(box_of(ring)) {
  constexpr std::size_t kSidesPerRow = 2, kMostRowsPerSide = 8;
  // Long sides lie in many rows; with fewer rows less is stored.
  for (std::size_t rows = std::max<std::size_t>(1, ring.size() / kSidesPerRow);; rows = (rows + 1) / 2) {
    divide(rows);
    const std::size_t stored = std::accumulate(begins_.begin(), begins_.end(), std::size_t(0));
    if (rows == 1 || stored <= kMostRowsPerSide * ring.size()) break;
  }
  fill();
}

std::size_t RingRows::row_of(double y) const {
  const double row = row_height_ > 0 ? (y - box_.low.y) / row_height_ : 0;
  return std::size_t(std::clamp(row, 0.0, double(rows() - 1)));
}

std::pair<std::size_t, std::size_t> RingRows::rows_of_side(std::size_t side) const {
  const double a = from(side).y, b = to(side).y;
  return {row_of(std::min(a, b)), row_of(std::max(a, b))};
}

/// Counts in begins_[i + 1] the sides in row i.
void RingRows::divide(std::size_t rows) {
  row_height_ = box_.height() / double(rows);
  begins_.assign(rows + 1, 0);
  for (std::size_t side = 0; side < ring_->size(); ++side) {
    const auto [first, last] = rows_of_side(side);
    for (std::size_t row = first; row <= last; ++row) ++begins_[row + 1];
  }
}

void RingRows::fill() {
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  sides_.resize(begins_.back());
  std::vector<std::size_t> next = begins_;
  for (std::size_t side = 0; side < ring_->size(); ++side) {
    const auto [first, last] = rows_of_side(side);
    for (std::size_t row = first; row <= last; ++row) sides_[next[row]++] = std::uint32_t(side);
  }
}

bool RingRows::contains(NestPoint p) const {
  if (!(p.y >= box_.low.y && p.y <= box_.high.y)) return false;
  bool inside = false;
  const std::size_t row = row_of(p.y);
  for (std::size_t at = begins_[row]; at < begins_[row + 1]; ++at) {
    const NestPoint a = to(sides_[at]), b = from(sides_[at]);
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) + a.x) inside = !inside;
  }
  return inside;
}

}  // namespace tessera
