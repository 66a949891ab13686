// How much of a library an OpenCL device can hold.
#pragma once

#include <CL/opencl.hpp>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/matching/matching_context.h"
#include "core/shape/shape_id.h"

namespace tessera::worker {

/// What a matcher needs of a device beside its part of the library.
struct DeviceNeeds {
  bool reads_models = true;  // from the library's file, singly; else all of them are held
  double field_nodes = 0;    // of the free field
};

/// The bytes of the lists of pairs and of dockings on a device that searches so many shapes, each at most.
std::size_t list_bytes(std::size_t shapes);

/// The bytes that so many shapes take on a device with all that matching needs beside them.
std::size_t device_bytes(const MatchingContext& context, std::size_t shapes, const DeviceNeeds& needs);

struct DeviceRoom {
  std::string name;
  std::uint64_t memory_bytes = 0;  // for us
  std::uint64_t buffer_bytes = 0;  // in one buffer at most
};

/// Those of a worker's devices, of which `workers` workers of its node use each; all of the host's memory is shared by
/// all workers and by all devices that are CPUs.
std::vector<DeviceRoom> rooms_of(const std::vector<cl::Device>& devices, int workers, int workers_of_node);

/// So many shapes, `most` at most, fit into a device.
std::size_t shapes_that_fit(const DeviceRoom& room, const MatchingContext& context, const DeviceNeeds& needs,
                            std::size_t most);

/// The parts of `shapes` that devices of these speeds search in the same time, none larger than its device can hold.
/// Throws EnvironmentError where all of them cannot hold all shapes.
std::vector<ShapeRange> parts_that_fit(const ShapeRange& shapes, const std::vector<double>& speeds,
                                       const std::vector<DeviceRoom>& rooms, const MatchingContext& context,
                                       const DeviceNeeds& needs);

}  // namespace tessera::worker
