// Holds the picture that pieces shall show on a device, and which shapes have the colours of its places.
#pragma once

#include <vector>

#include "core/matching/matching_context.h"
#include "core/matching/near_colours.h"
#include "records.h"
#include "worker/devices/opencl_runtime.h"

namespace tessera::worker {

class DeviceColours {
 public:
  DeviceColours(const DeviceSession& session, const MatchingContext& context);

  /// Takes the shapes that may stand in this context from now on.
  void start(const MatchingContext& context);
  /// Gives each record the number of its sample's list of shapes, and puts new lists on the device.
  void assign_lists(const std::vector<TargetSample>& samples, std::vector<SampleRecord>& records);

  const NearColours& near_colours() const { return near_colours_; }
  const DeviceBuffer<ColourRecord>& record() const { return record_; }
  const DeviceBuffer<float>& texels() const { return texels_; }
  /// NearColours::all_shapes and all_bits.
  const DeviceBuffer<std::uint32_t>& near_shapes() const { return near_shapes_; }
  const DeviceBuffer<std::uint32_t>& near_bits() const { return near_bits_; }

 private:
  void write_lists();

  ColourWish wish_;
  NearColours near_colours_;
  std::size_t lists_on_device_ = 0;
  DeviceBuffer<ColourRecord> record_;
  DeviceBuffer<float> texels_;
  DeviceBuffer<std::uint32_t> near_shapes_;
  DeviceBuffer<std::uint32_t> near_bits_;
};

}  // namespace tessera::worker
