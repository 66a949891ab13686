// Docking on a device (kernels/docking.cl, shortlist.cl): from pairs and from random draws to each target sample's
// shortlist.
#pragma once

#include "worker/pair_stage.h"

namespace tessera::worker {

class DockStage {
 public:
  DockStage(const DeviceLibrary& library, PairStage& pairs);

  /// `samples`: the records of the request's. Where all bin limits are zero, no pairs are made.
  void post(const DockRequest& request, std::vector<SampleRecord> samples);
  DockReply take();

 private:
  struct Part;  // of a request: samples [first, end)
  void post_part(const Part& part);
  void dock_pairs(const Part& part);
  void dock_tangents(const Part& part);
  std::uint32_t samples_at_a_time() const;

  const DeviceLibrary* library_;
  PairStage* pairs_;
  cl::Kernel dock_pairs_;
  cl::Kernel dock_tangents_;
  cl::Kernel keep_shortlist_;
  DeviceBuffer<DockingRecord> paired_;
  DeviceBuffer<float> paired_keys_;
  DeviceBuffer<DockingRecord> tangent_;
  DeviceBuffer<float> tangent_keys_;
  DeviceBuffer<DockingRecord> shortlists_;
  DeviceBuffer<std::uint32_t> shortlist_counts_;
  DeviceBuffer<std::uint32_t> evaluated_;
  std::uint32_t samples_ = 0;
  std::uint32_t draws_ = 0;
  bool with_pairs_ = false;
};

}  // namespace tessera::worker
