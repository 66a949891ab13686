#include "core/ranks/worker_tree.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

namespace tessera {

TreePlace place_in_tree(int rank, int size, int fan_out) {
  if (rank < 0 || rank >= size || fan_out < 1) throw std::logic_error("there is no such place in a tree of ranks");
  TreePlace place;
  int node = 0;
  int begin = 1;  // the ranks below `node` are [begin, end)
  int end = size;
  for (;;) {
    const int below = end - begin;
    const int branches = std::min(fan_out, below);
    const auto first_of = [&](int branch) { return begin + int(std::int64_t(below) * branch / branches); };
    if (node == rank) {
      for (int branch = 0; branch < branches; ++branch) place.children.push_back(first_of(branch + 1) - 1);
      return place;
    }
    int branch = 0;
    while (first_of(branch + 1) <= rank) ++branch;
    const int first = first_of(branch);
    place.parent = node;
    node = first_of(branch + 1) - 1;
    begin = first;
    end = node;
  }
}

}  // namespace tessera
