// Union-find: sets of numbers that are joined step by step.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace tessera {

class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(std::size_t(count)) { std::iota(parent_.begin(), parent_.end(), 0); }

  int root(int i) {
    while (parent_[std::size_t(i)] != i) i = parent_[std::size_t(i)] = parent_[std::size_t(parent_[std::size_t(i)])];
    return i;
  }

  /// Joins two sets, given by their roots. The first root stays the root.
  void join(int root, int other_root) { parent_[std::size_t(other_root)] = root; }

 private:
  std::vector<int> parent_;
};

}  // namespace tessera
