// The OpenCL devices of this machine, and which of them a worker uses (job keys devices.use, devices.per_worker).
#pragma once

#include <CL/opencl.hpp>
#include <string>
#include <vector>

#include "core/ranks/rank_site.h"
#include "worker/devices/kernel_options.h"

namespace tessera::worker {

/// All devices, platform by platform as `clinfo -l` lists them. Throws EnvironmentError that says what may help where
/// there are none.
std::vector<cl::Device> opencl_devices();

/// Describes a device for records and lists.
DeviceDescription describe(const cl::Device& device);

/// How dockings are best handled on the device.
DockingLanes lanes_for(const cl::Device& device);

/// One of the workers of a node. Each takes `per_worker` devices of its own; 0: each takes all.
struct DeviceShare {
  int worker = 0;  // among the node's workers
  int workers = 1;
  int per_worker = 0;
};

/// Which of the node's `devices` are this worker's. Throws InputError where there are too few.
std::vector<std::size_t> own_devices(std::size_t devices, const DeviceShare& share);

/// `use`: "all", "cpu", "gpu" or indices into opencl_devices() like "0,2"; of these devices the worker's share. Throws
/// EnvironmentError where the machine has no device of that kind, InputError for anything else that does not fit; both
/// say which devices there are. `option`: what `use` was given to, for the messages; empty: the job key devices.use.
std::vector<cl::Device> chosen_devices(const std::string& use, const DeviceShare& share = {},
                                       const std::string& option = {});

}  // namespace tessera::worker
