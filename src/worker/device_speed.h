// How fast the devices of a rank are, where they differ, so that each gets as much of the library as it searches in the
// same time. It never decides anything about the picture.
#pragma once

#include <vector>

#include "core/pad/pad.h"
#include "worker/devices/opencl_runtime.h"

namespace tessera::worker {

/// Whether some are of another kind than others: by name or by number of compute units.
bool devices_differ(const std::vector<cl::Device>& devices);

/// Small matching tasks a second on each device, one after the other: some hundred milliseconds in all, where the
/// kernels are in the cache on disk. 1 for each without measuring where the devices do not differ. `pad`: of the job,
/// whose kernels are measured. `between_launches` may throw to give it up.
std::vector<double> device_speeds(const std::vector<cl::Device>& devices, const PadParameters& pad,
                                  const BetweenLaunches& between_launches = {});

}  // namespace tessera::worker
