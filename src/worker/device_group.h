// One matcher for a rank's part of the library, on the OpenCL devices that its job names.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/matching/matching_context.h"
#include "core/matching/model_source.h"
#include "worker/device_room.h"
#include "worker/devices/opencl_devices.h"
#include "worker/devices/opencl_runtime.h"

namespace tessera::worker {

/// Limits CPU devices to so many threads, for ranks that share a node's cores. A number that the user chose
/// (POCL_MAX_PTHREAD_COUNT) stays. To be called before the first call of OpenCL.
void limit_cpu_threads(int threads);

/// A device with the shapes that it searches.
struct DevicePart {
  cl::Device device;
  ShapeRange shapes;
};

/// The devices that the job names, in order, each with its part of `shapes`. Equal devices get equal parts, give or take
/// one shape. Different devices get as many shapes as they search in the same time (device_speed.h), but none gets more
/// than its memory holds (device_room.h). With fewer shapes than devices only the first devices are used. `devices_use`:
/// job key devices.use. Throws InputError or EnvironmentError where the devices are missing (opencl_devices.h), fail, or
/// have too little memory for all shapes. `between_launches` may throw to give up.
std::vector<DevicePart> device_parts(const std::string& devices_use, const MatchingContext& context,
                                     const ShapeRange& shapes, const DeviceNeeds& needs, const DeviceShare& share = {},
                                     const BetweenLaunches& between_launches = {});

std::vector<DeviceDescription> describe(const std::vector<DevicePart>& parts);

/// Joins the parts to one matcher. `between_launches` may throw to give a question up; the matcher must not be asked again
/// then.
std::unique_ptr<Matcher> make_device_matcher(const std::vector<DevicePart>& parts, const MatchingContext& context,
                                             const std::shared_ptr<const ModelSource>& models,
                                             const BetweenLaunches& between_launches = {});

/// Makes the matcher of all devices that the job names.
std::unique_ptr<Matcher> make_device_matcher(const std::string& devices_use, const MatchingContext& context,
                                             const ShapeRange& shapes,
                                             const std::shared_ptr<const ModelSource>& models);

/// Compiles the kernels for the job's devices, unless the cache on disk has them.
void compile_kernels(const std::string& devices_use, const MatchingContext& context);

}  // namespace tessera::worker
