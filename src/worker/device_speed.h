// The speeds of a rank's devices, where the devices differ: each then gets as many shapes as it searches in the same time.
// The speeds never change the picture.
#pragma once

#include <vector>

#include "core/pad/pad.h"
#include "worker/devices/opencl_runtime.h"

namespace tessera::worker {

/// Whether the devices differ in name or in number of compute units.
bool devices_differ(const std::vector<cl::Device>& devices);

/// Small matching tasks a second on each device, measured one device after the other. That takes some hundred milliseconds
/// in all, where the kernels are in the cache on disk. Equal devices get 1 each and are not measured. `pad`: the parameters
/// of the job, whose kernels are measured. `between_launches` may throw to give up.
std::vector<double> device_speeds(const std::vector<cl::Device>& devices, const PadParameters& pad,
                                  const BetweenLaunches& between_launches = {});

}  // namespace tessera::worker
