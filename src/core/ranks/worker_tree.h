// Who asks whom: a tree of ranks with the master at its root, so that no rank sends or joins more than a few messages a
// question, however many workers there are.
#pragma once

#include <vector>

namespace tessera {

/// A rank asks at most so many others itself. Simulated for 512 workers (docs/scaling.md): 4 to 16 differ little.
inline constexpr int kFanOut = 8;

struct TreePlace {
  int parent = -1;            // who asks this rank; none for rank 0
  std::vector<int> children;  // ascending
};

/// The place of `rank` among ranks 0 to size - 1. A worker and all below it are neighbours, itself the last of them:
/// their parts of the library are one range, and a node's ranks are mostly one branch.
TreePlace place_in_tree(int rank, int size, int fan_out = kFanOut);

}  // namespace tessera
