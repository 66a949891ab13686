#include "worker/device_group.h"

#include <algorithm>
#include <cstdlib>

#include "core/matching/composite_matcher.h"
#include "worker/device_speed.h"
#include "worker/devices/opencl_devices.h"
#include "worker/opencl_matcher.h"

namespace tessera::worker {

void limit_cpu_threads(int threads) {
  constexpr int keep_users_choice = 0;
  setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(std::max(1, threads)).c_str(), keep_users_choice);
}

std::vector<DevicePart> device_parts(const std::string& devices_use, const MatchingContext& context,
                                     const ShapeRange& shapes, const DeviceNeeds& needs, const DeviceShare& share,
                                     const BetweenLaunches& between_launches) {
  std::vector<cl::Device> devices = chosen_devices(devices_use, share);
  devices.resize(std::clamp<std::size_t>(shapes.size(), 1, devices.size()));
  std::vector<double> speeds(devices.size(), 1);
  if (shapes.size() > devices.size()) speeds = device_speeds(devices, context.pad, between_launches);
  const std::vector<DeviceRoom> rooms = rooms_of(devices, share.per_worker > 0 ? 1 : share.workers, share.workers);
  std::vector<DevicePart> parts;
  for (const ShapeRange& part : parts_that_fit(shapes, speeds, rooms, context, needs)) {
    parts.push_back({devices[parts.size()], part});
  }
  return parts;
}

std::vector<DeviceDescription> describe(const std::vector<DevicePart>& parts) {
  std::vector<DeviceDescription> descriptions;
  for (const DevicePart& part : parts) {
    descriptions.push_back(describe(part.device));
    descriptions.back().shapes = part.shapes.end - part.shapes.begin;
  }
  return descriptions;
}

std::unique_ptr<Matcher> make_device_matcher(const std::vector<DevicePart>& parts, const MatchingContext& context,
                                             const std::shared_ptr<const ModelSource>& models,
                                             const BetweenLaunches& between_launches) {
  std::vector<std::unique_ptr<Matcher>> matchers;
  for (const DevicePart& part : parts) {
    matchers.push_back(std::make_unique<OpenCLMatcher>(part.device, context, part.shapes, models, between_launches));
  }
  if (matchers.size() == 1) return std::move(matchers.front());
  return std::make_unique<CompositeMatcher>(std::move(matchers));
}

std::unique_ptr<Matcher> make_device_matcher(const std::string& devices_use, const MatchingContext& context,
                                             const ShapeRange& shapes,
                                             const std::shared_ptr<const ModelSource>& models) {
  const DeviceNeeds needs{.reads_models = models->supports_random_access()};
  return make_device_matcher(device_parts(devices_use, context, shapes, needs), context, models);
}

void compile_kernels(const std::string& devices_use, const MatchingContext& context) {
  const std::vector<ShapeModel> none;
  make_device_matcher(devices_use, context, {}, given(none));
}

}  // namespace tessera::worker
