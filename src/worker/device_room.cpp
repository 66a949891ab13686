#include "worker/device_room.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/ranks/partition.h"
#include "worker/opencl_matcher.h"
#include "worker/shard/shard.h"

namespace tessera::worker {
namespace {

/// Bytes of the list of pairs for each shape, measured with several samples. The list of dockings takes no more.
constexpr double kPairsOfAShape_bytes = 15e3;
/// The part of a device's memory that we use. The driver needs the rest, and on a CPU the processes do.
constexpr double kUsablePart = 0.9;

bool has_hosts_memory(const cl::Device& device) { return device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU; }

[[noreturn]] void throw_no_room(std::size_t shapes, const std::vector<DeviceRoom>& rooms,
                                const std::vector<std::size_t>& most) {
  std::string found;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    found += (i == 0 ? "" : ", ") + std::to_string(most[i]) + " on \"" + rooms[i].name + "\" (" +
             gigabytes(rooms[i].memory_bytes) + " for this rank, " + gigabytes(rooms[i].buffer_bytes) +
             " in one buffer)";
  }
  throw EnvironmentError("OpenCL devices: " + count_text(shapes, "shape") + " of the library " +
                         by_count(shapes, "does", "do") + " not fit into their memory; there is room for " + found +
                         "; give the job more ranks, nodes or devices");
}

}  // namespace

std::size_t list_bytes(std::size_t shapes) {
  return std::size_t(std::min(double(kMostGrowth * kStageBytes), double(shapes) * kPairsOfAShape_bytes));
}

std::size_t device_bytes(const MatchingContext& context, std::size_t shapes, const DeviceNeeds& needs) {
  return shard_bytes(context, shapes, needs.reads_models).device + std::size_t(needs.field_nodes * sizeof(float)) +
         2 * list_bytes(shapes);
}

std::vector<DeviceRoom> rooms_of(const std::vector<cl::Device>& devices, int workers, int workers_of_node) {
  const auto of_host = double(std::count_if(devices.begin(), devices.end(), has_hosts_memory));
  std::vector<DeviceRoom> rooms;
  for (const cl::Device& device : devices) {
    const double users = has_hosts_memory(device) ? of_host * workers_of_node : double(workers);
    const auto memory_bytes = double(device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>());
    rooms.push_back({device.getInfo<CL_DEVICE_NAME>(), std::uint64_t(kUsablePart * memory_bytes / users),
                     device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()});
  }
  return rooms;
}

std::size_t shapes_that_fit(const DeviceRoom& room, const MatchingContext& context, const DeviceNeeds& needs,
                            std::size_t most) {
  const auto fit = [&](std::size_t shapes) {
    return device_bytes(context, shapes, needs) <= room.memory_bytes &&
           shard_bytes(context, shapes, needs.reads_models).largest_buffer <= room.buffer_bytes;
  };
  if (fit(most)) return most;
  std::size_t enough = 0, too_many = most;
  while (too_many - enough > 1) {
    const std::size_t middle = std::midpoint(enough, too_many);
    (fit(middle) ? enough : too_many) = middle;
  }
  return enough;
}

std::vector<ShapeRange> parts_that_fit(const ShapeRange& shapes, const std::vector<double>& speeds,
                                       const std::vector<DeviceRoom>& rooms, const MatchingContext& context,
                                       const DeviceNeeds& needs) {
  const std::size_t count = shapes.size();
  std::vector<std::size_t> most;
  for (const DeviceRoom& room : rooms) most.push_back(shapes_that_fit(room, context, needs, count));
  if (std::accumulate(most.begin(), most.end(), std::size_t(0)) < count) throw_no_room(count, rooms, most);
  std::vector<ShapeRange> parts;
  for (const ShapeRange& part : ranges_by_speed(count, speeds, most)) {
    parts.push_back({shapes.begin + part.begin, shapes.begin + part.end});
  }
  return parts;
}

}  // namespace tessera::worker
