// The OpenCL devices of this machine, and which of them a worker uses (job keys devices.use, devices.per_worker).
#pragma once

#include <CL/opencl.hpp>
#include <string>
#include <vector>

#include "core/ranks/rank_site.h"
#include "worker/devices/kernel_options.h"

namespace tessera::worker {

/// All devices, platform by platform, as `clinfo -l` lists them. Where there are none, throws EnvironmentError that says
/// what may help.
std::vector<cl::Device> opencl_devices();

/// Describes a device for records and lists.
DeviceDescription describe(const cl::Device& device);

/// The best way for the device to compute the lanes of a docking.
DockingLanes lanes_for(const cl::Device& device);

/// A worker's share of its node's devices. Each worker takes `per_worker` devices of its own; 0: each takes all devices.
struct DeviceShare {
  int worker = 0;  // among the node's workers
  int workers = 1;
  int per_worker = 0;
};

/// The indices of this worker's devices among the node's `devices`. Throws InputError where there are too few.
std::vector<std::size_t> own_devices(std::size_t devices, const DeviceShare& share);

/// The worker's share of the devices that `use` names: "all", "cpu", "gpu" or indices into opencl_devices() like "0,2".
/// Throws EnvironmentError where the machine has no device of that kind, InputError where `use` is wrong in another way;
/// both say which devices there are. `option`: the command's option that gave `use`, for messages; empty: the job key
/// devices.use.
std::vector<cl::Device> chosen_devices(const std::string& use, const DeviceShare& share = {},
                                       const std::string& option = {});

}  // namespace tessera::worker
