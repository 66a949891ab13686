// A rank's part of the library on the OpenCL devices that its job names, as one matcher.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/matcher.h"

namespace tessera::worker {

/// CPU devices use at most so many threads, for ranks that share a node's cores, unless the user chose a number
/// (POCL_MAX_PTHREAD_COUNT). Only before the first call of OpenCL.
void limit_cpu_threads(int threads);

/// `models[i]` is library shape first_shape + i. They are divided among the devices by their samples; with fewer shapes
/// than devices the first devices are used. `devices_use`: job key devices.use. Throws InputError or EnvironmentError
/// where the devices are not there (opencl_devices.h) or fail.
std::unique_ptr<Matcher> make_device_matcher(const std::string& devices_use, const MatchingContext& context,
                                             std::uint32_t first_shape, std::vector<ShapeModel> models);

}  // namespace tessera::worker
