// Computes how much of a library an OpenCL device can hold.
#pragma once

#include <CL/opencl.hpp>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/matching/matching_context.h"
#include "core/shape/shape_id.h"

namespace tessera::worker {

/// The needs of a matcher on a device, beside its part of the library.
struct DeviceNeeds {
  bool reads_models = true;  // it reads single models from the library's file; false: it holds all of them
  double field_nodes = 0;    // of the free field
};

/// Upper bound, in bytes, of the list of pairs on a device that searches so many shapes; the list of dockings has the same
/// bound.
std::size_t list_bytes(std::size_t shapes);

/// The bytes that so many shapes take on a device, with all that matching needs beside them.
std::size_t device_bytes(const MatchingContext& context, std::size_t shapes, const DeviceNeeds& needs);

struct DeviceRoom {
  std::string name;
  std::uint64_t memory_bytes = 0;  // for this rank
  std::uint64_t buffer_bytes = 0;  // largest single buffer
};

/// The room on each of a worker's devices; `workers` workers of its node use each device. All workers of the node and all
/// devices that are CPUs share the host's memory.
std::vector<DeviceRoom> rooms_of(const std::vector<cl::Device>& devices, int workers, int workers_of_node);

/// The number of shapes that fit into a device; `most` at most.
std::size_t shapes_that_fit(const DeviceRoom& room, const MatchingContext& context, const DeviceNeeds& needs,
                            std::size_t most);

/// Divides `shapes` into parts that devices of these speeds search in the same time. No part is larger than its device can
/// hold. Throws EnvironmentError where the devices together cannot hold all shapes.
std::vector<ShapeRange> parts_that_fit(const ShapeRange& shapes, const std::vector<double>& speeds,
                                       const std::vector<DeviceRoom>& rooms, const MatchingContext& context,
                                       const DeviceNeeds& needs);

}  // namespace tessera::worker
