// Docking on a device (kernels/docking.cl): makes each target sample's shortlist from its pairs and from random draws.
#pragma once

#include "worker/devices/device_kernel.h"
#include "worker/pair_stage.h"
#include "worker/shard/device_deck.h"

namespace tessera::worker {

class DockStage {
 public:
  /// `stage_bytes`: room for dockings on the device at first.
  DockStage(DeviceLibrary& library, PairStage& pairs, std::size_t stage_bytes);

  /// Posts the dockings of a request and does not wait for them. `samples`: the records of the request's samples. Where all
  /// bin limits are zero, it makes no dockings of pairs.
  void post(const DockRequest& request, std::vector<SampleRecord> samples);
  DockReply take();

 private:
  void make_room();
  void launch_pairs();
  void launch_tangents();

  DeviceLibrary* library_;
  PairStage* pairs_;
  DeviceKernel dock_pairs_;
  DeviceKernel dock_tangents_;
  DeviceDeck deck_;
  DeviceBuffer<SampleRecord> samples_;
  DeviceBuffer<PairRecord> docked_pairs_;
  DeviceBuffer<std::int16_t> pair_keypoints_;
  DeviceBuffer<DockingRecord> dockings_;
  DeviceBuffer<std::uint32_t> docking_count_;
  DeviceBuffer<std::uint32_t> evaluated_;  // by sample
  std::uint32_t docking_capacity_;
  std::uint32_t sample_count_ = 0;
  std::uint32_t pair_count_ = 0;
  std::uint32_t draws_ = 0;
  bool first_drawn_ = false;
};

}  // namespace tessera::worker
