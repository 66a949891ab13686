// Estimates of what a job will need on a cluster, made before it runs: pure formulas over the job. Their constants were
// measured (see plan_estimate.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/settings/settings.h"

namespace tessera {

/// The input of the formulas.
struct PlanInput {
  CollageSettings settings;
  double canvas_px2 = 0;                     // area to be filled
  double canvas_nodes = 0;                   // width times height
  double picture_px2 = 0;                    // of collage.png
  std::size_t shapes = 0;                    // of the library, with mirror images
  std::vector<std::uint32_t> drawings = {};  // ShapeLibrary::drawings; empty: no mirror images
  bool reads = true;                         // workers read models from the file; false: they hold all of them
  bool host_devices = true;                  // the workers' OpenCL devices use the host's memory (CPUs)
  int ranks = 1;                             // a master and workers; one rank is both
  int nodes = 1;
};

struct PlanEstimate {
  int workers = 1;
  int ranks_per_node = 1;  // on the fullest node
  int workers_per_node = 1;
  std::size_t levels = 0;  // smoothing levels in use
  std::uint64_t pads_per_shape = 0;
  std::size_t shapes_per_worker = 0;
  double pieces = 0;
  double device_bytes = 0;          // a worker's part of the library, the field and the buffers of matching
  double largest_buffer_bytes = 0;  // the largest single one of these
  double worker_bytes = 0;          // host memory
  double master_bytes = 0;
  double node_bytes = 0;   // of the node with the master
  double filling_s = 0;    // the workers compute at the same time
  double improving_s = 0;  // likewise
  double beside_s = 0;     // start, loading, files
  double total_s = 0;      // sum of the three times above
  double checkpoint_bytes = 0;
};

PlanEstimate estimate(const PlanInput& input);

}  // namespace tessera
