// Refinement and measuring on a device (kernels/refinement.cl, docking_terms.cl).
#pragma once

#include "worker/devices/device_kernel.h"
#include "worker/shard/device_library.h"

namespace tessera::worker {

class RefineStage {
 public:
  explicit RefineStage(DeviceLibrary& library);

  /// Posts the refinement. Throws std::out_of_range for a docking whose shape is not in the shard.
  void post(const std::vector<Docking>& dockings);
  std::vector<RefinedDocking> take();
  void post_measure(const std::vector<Docking>& dockings);
  std::vector<DockingTerms> take_measure();

 private:
  std::uint32_t upload(const std::vector<Docking>& dockings);

  DeviceLibrary* library_;
  DeviceKernel refine_dockings_;
  DeviceKernel measure_dockings_;
  std::vector<Docking> posted_;
  DeviceBuffer<DockingRecord> dockings_;
  DeviceBuffer<RefinedRecord> refined_;
  std::size_t measured_ = 0;
  DeviceBuffer<TermsRecord> terms_;
};

}  // namespace tessera::worker
