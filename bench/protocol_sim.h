// The protocol of master and workers (src/comm) on a cluster that SimGrid simulates: the same messages in the same
// order, with measured sizes, and time that passes instead of work.
#pragma once

#include <vector>

#include "bench/round_model.h"
#include "core/ranks/worker_tree.h"

namespace tessera::bench {

/// Hosts around a switch, a rank each. A message crosses two links.
struct Cluster {
  double latency_s = 2e-6;    // from host to host
  double bytes_per_s = 10e9;  // of a link, each way
};

/// Questions go down the tree of src/core/ranks/worker_tree.h, and the answers up.
struct Scenario {
  RoundCosts costs;
  int fan_out = kFanOut;
};

struct SimulatedRound {
  double round_s = 0;
  double master_busy_s = 0;  // of it; the rest it waits
};

/// A mean round of each scenario. Only once in a process: SimGrid's engine cannot be started again.
std::vector<SimulatedRound> simulate_rounds(const std::vector<Scenario>& scenarios, const Cluster& cluster);

}  // namespace tessera::bench
