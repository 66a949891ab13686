// Batches of replacement trials (src/comm/teams/replacer_team.h) on a cluster that SimGrid simulates: the same windows to the
// same ranks, with measured sizes and times.
#pragma once

#include <vector>

#include "bench/replacing_case.h"
#include "core/ranks/worker_tree.h"
#include "protocol_sim.h"

namespace tessera::bench {

struct BatchScenario {
  const ReplacingCase* measured = nullptr;  // outlives it
  int workers = 1;
  int cores = 1;  // of each
  int fan_out = kFanOut;
};

struct SimulatedBatch {
  double batch_s = 0;
  double master_busy_s = 0;  // of it; the rest it waits
};

/// One batch in each scenario. Only once in a process (sim_cluster.h).
std::vector<SimulatedBatch> simulate_batches(const std::vector<BatchScenario>& scenarios, const Cluster& cluster);

}  // namespace tessera::bench
