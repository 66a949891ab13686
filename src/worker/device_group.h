// A rank's part of the library on the OpenCL devices that its job names, as one matcher.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/matching/matching_context.h"
#include "core/matching/model_source.h"
#include "worker/opencl_devices.h"
#include "worker/opencl_runtime.h"

namespace tessera::worker {

/// Lets CPU devices use at most so many threads, for ranks that share a node's cores, unless the user chose a number
/// (POCL_MAX_PTHREAD_COUNT). To be called before the first call of OpenCL.
void limit_cpu_threads(int threads);

/// Joins the devices that the job names. Every shape has the same number of samples, so that all devices get the same
/// number of shapes, give or take one; with fewer shapes than devices the first devices are used. `devices_use`: job
/// key devices.use. Throws InputError or EnvironmentError where the devices are not there (opencl_devices.h) or fail.
/// `between_launches` may throw to give a question up; the matcher must not be asked again then.
std::unique_ptr<Matcher> make_device_matcher(const std::string& devices_use, const MatchingContext& context,
                                             const ShapeRange& shapes, std::shared_ptr<const ModelSource> models,
                                             const DeviceShare& share = {},
                                             const BetweenLaunches& between_launches = {});

/// Compiles the kernels for the job's devices where they are not in the cache on disk.
void compile_kernels(const std::string& devices_use, const MatchingContext& context);

}  // namespace tessera::worker
