// What a job will need on a cluster, estimated before it is run: pure formulas over the job, with constants that were
// measured (plan_estimate.cpp says where).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/settings/settings.h"

namespace tessera {

/// What the formulas take.
struct PlanInput {
  CollageSettings settings;
  double canvas_px2 = 0;                     // to fill
  double canvas_nodes = 0;                   // width times height
  double picture_px2 = 0;                    // of collage.png
  std::size_t shapes = 0;                    // in the library, with mirror images
  std::vector<std::uint32_t> drawings = {};  // ShapeLibrary::drawings; empty: no mirror images
  bool reads = true;                         // their models from its file; else each worker holds all of its part's
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
  double device_bytes = 0;          // of a worker's part of the library, the field and what is under way
  double largest_buffer_bytes = 0;  // of these
  double worker_bytes = 0;          // host memory
  double master_bytes = 0;
  double node_bytes = 0;   // of the node with the master
  double filling_s = 0;    // with the workers side by side
  double improving_s = 0;  // likewise
  double beside_s = 0;     // start, loading, files
  double total_s = 0;      // the sum of these
  double checkpoint_bytes = 0;
};

PlanEstimate estimate(const PlanInput& input);

}  // namespace tessera
