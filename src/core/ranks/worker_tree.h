// The tree in which ranks ask each other, with the master at its root. So no rank sends or joins more than a few
// messages for a question, however many workers there are.
#pragma once

#include <vector>

namespace tessera {

/// The largest number of ranks that one rank asks directly. Simulated for 512 workers (docs/scaling.md): 4 to 16 differ
/// little.
inline constexpr int kFanOut = 8;

struct TreePlace {
  int parent = -1;            // the rank that asks this rank; -1 for rank 0
  std::vector<int> children;  // ascending
};

/// The place of `rank` among ranks 0 to size - 1. A worker and all ranks below it have successive numbers, the worker
/// the last one. So their parts of the library form one range, and a node's ranks mostly form one branch.
TreePlace place_in_tree(int rank, int size, int fan_out = kFanOut);

}  // namespace tessera
