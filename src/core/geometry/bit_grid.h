// A set of grid nodes, one bit each, for operations on 64 nodes at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/grid.h"

namespace tessera {

class BitGrid {
 public:
  BitGrid(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  bool test(int x, int y) const { return (row(y)[x >> 6] >> (x & 63) & 1) != 0; }
  /// Sets nodes [x0, x1) of row y.
  void set_run(int y, int x0, int x1);
  void set(const Window& window);
  /// Whether any node of the window is in the set.
  bool any(const Window& window) const;

  /// Node x is bit x & 63 of word x >> 6; bits beyond the width are zero.
  int words() const { return words_; }
  std::uint64_t* row(int y) { return bits_.data() + std::size_t(y) * words_; }
  const std::uint64_t* row(int y) const { return bits_.data() + std::size_t(y) * words_; }

 private:
  int width_;
  int height_;
  int words_;  // words in a row
  std::vector<std::uint64_t> bits_;
};

/// The nodes of `window` whose value lies above the threshold; node (0, 0) of the result is the window's first node.
BitGrid nodes_above(const Grid<float>& field, const Window& window, float threshold);

/// All nodes with a node of `set` at a squared distance of at most `squared_radius` nodes².
BitGrid dilated_by_disc(const BitGrid& set, float squared_radius);

}  // namespace tessera
