#include "core/geometry/distance_transform.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

namespace tessera {
namespace {

/// Distance to the nearest set node of the same column; `unreached`, which exceeds every distance, in empty columns.
Grid<std::int32_t> distance_in_columns(const Grid<std::uint8_t>& set, std::int32_t unreached) {
  Grid<std::int32_t> distance(set.width(), set.height(), unreached);
  for (int y = 0; y < set.height(); ++y) {
    for (int x = 0; x < set.width(); ++x) {
      const std::int32_t from_above = y > 0 ? distance(x, y - 1) + 1 : unreached;
      distance(x, y) = set(x, y) ? 0 : std::min(from_above, unreached);
    }
  }
  for (int y = set.height() - 2; y >= 0; --y) {
    for (int x = 0; x < set.width(); ++x) distance(x, y) = std::min(distance(x, y), distance(x, y + 1) + 1);
  }
  return distance;
}

/// The parabolas (x - i)² + height[i] of one row that are lowest somewhere, from left to right.
class LowerEnvelope {
 public:
  explicit LowerEnvelope(int width) : vertex_(width), start_(width), height_(width) {}

  void build(const std::int32_t* distance) {
    const int width = int(height_.size());
    for (int x = 0; x < width; ++x) height_[x] = distance[x] * distance[x];
    last_ = -1;
    for (int x = 0; x < width; ++x) {
      while (last_ >= 0 && value(vertex_[last_], start_[last_]) > value(x, start_[last_])) --last_;
      const int start = last_ < 0 ? 0 : first_node_won(vertex_[last_], x);
      if (start >= width) continue;
      ++last_;
      vertex_[last_] = x;
      start_[last_] = start;
    }
  }

  void write_values(float* row) const {
    int x = int(height_.size());
    for (int k = last_; k >= 0; --k) {
      while (x > start_[k]) {
        --x;
        row[x] = float(value(vertex_[k], x));
      }
    }
  }

 private:
  std::int32_t value(int vertex, int x) const { return (x - vertex) * (x - vertex) + height_[vertex]; }

  /// The first node at which the parabola of `right` lies strictly below that of `left` (left < right).
  int first_node_won(int left, int right) const {
    return (right * right - left * left + height_[right] - height_[left]) / (2 * (right - left)) + 1;
  }

  std::vector<int> vertex_;
  std::vector<int> start_;
  std::vector<std::int32_t> height_;
  int last_ = -1;
};

}  // namespace

Grid<float> squared_distance_to(const Grid<std::uint8_t>& set) {
  assert(set.width() + set.height() <= 32768);
  Grid<float> squared(set.width(), set.height(), std::numeric_limits<float>::infinity());
  if (std::none_of(set.data().begin(), set.data().end(), [](std::uint8_t v) { return v != 0; })) return squared;

  const Grid<std::int32_t> in_columns = distance_in_columns(set, set.width() + set.height());
  LowerEnvelope envelope(set.width());
  for (int y = 0; y < set.height(); ++y) {
    envelope.build(in_columns.row(y));
    envelope.write_values(squared.row(y));
  }
  return squared;
}

}  // namespace tessera
