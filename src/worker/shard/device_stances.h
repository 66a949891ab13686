// Holds the stances on a device: which shapes may stand at the moment, and in which poses.
#pragma once

#include "core/matching/stances.h"
#include "worker/devices/opencl_runtime.h"
#include "worker/shard/shard.h"

namespace tessera::worker {

class DeviceStances {
 public:
  explicit DeviceStances(const DeviceSession& session);

  /// Writes the table to the device. `shapes`: the shapes of the device's shard.
  void write(const StanceTable& table, const ShapeRange& shapes);

  const DeviceBuffer<StanceRecord>& stances() const { return stances_; }
  /// The lists of stances, by class.
  const DeviceBuffer<StanceListRecord>& lists() const { return lists_; }
  const DeviceBuffer<std::uint32_t>& shape_class() const { return shape_class_; }
  /// The shapes of the whole library that may stand. Empty where all of them may.
  const DeviceBuffer<std::uint32_t>& open_shapes() const { return open_shapes_; }
  std::uint32_t open_count() const { return open_count_; }
  bool all_open() const { return all_open_; }

 private:
  DeviceBuffer<StanceRecord> stances_;
  DeviceBuffer<StanceListRecord> lists_;
  DeviceBuffer<std::uint32_t> shape_class_;
  DeviceBuffer<std::uint32_t> open_shapes_;
  std::uint32_t open_count_ = 0;
  bool all_open_ = true;
};

}  // namespace tessera::worker
