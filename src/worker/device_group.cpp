#include "worker/device_group.h"

#include <algorithm>
#include <cstdlib>

#include "core/matching/composite_matcher.h"
#include "core/ranks/partition.h"
#include "worker/opencl_devices.h"
#include "worker/opencl_matcher.h"

namespace tessera::worker {

void limit_cpu_threads(int threads) {
  constexpr int keep_users_choice = 0;
  setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(std::max(1, threads)).c_str(), keep_users_choice);
}

std::unique_ptr<Matcher> make_device_matcher(const std::string& devices_use, const MatchingContext& context,
                                             const ShapeRange& shapes, std::shared_ptr<const ModelSource> models,
                                             const DeviceShare& share, const BetweenLaunches& between_launches) {
  const std::vector<cl::Device> devices = chosen_devices(devices_use, share);
  const std::size_t count = shapes.end - shapes.begin;
  const std::vector<std::uint64_t> weights(count, 1);
  const int used = int(std::clamp<std::size_t>(count, 1, devices.size()));
  std::vector<std::unique_ptr<Matcher>> parts;
  for (const ShapeRange& part : balanced_ranges(weights, used)) {
    const ShapeRange own{shapes.begin + part.begin, shapes.begin + part.end};
    parts.push_back(std::make_unique<OpenCLMatcher>(devices[parts.size()], context, own, models, between_launches));
  }
  if (parts.size() == 1) return std::move(parts.front());
  return std::make_unique<CompositeMatcher>(std::move(parts));
}

void compile_kernels(const std::string& devices_use, const MatchingContext& context) {
  const std::vector<ShapeModel> none;
  make_device_matcher(devices_use, context, {}, given(none));
}

}  // namespace tessera::worker
