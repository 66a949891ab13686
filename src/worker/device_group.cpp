#include "worker/device_group.h"

#include <algorithm>
#include <cstdlib>

#include "core/composite_matcher.h"
#include "core/partition.h"
#include "worker/opencl_devices.h"
#include "worker/opencl_matcher.h"

namespace tessera::worker {
namespace {

std::uint64_t sample_count(const ShapeModel& model) {
  std::uint64_t count = 0;
  for (const ModelLevel& level : model.levels) count += level.samples.size();
  return count;
}

std::vector<ShapeRange> parts_of(const std::vector<ShapeModel>& models, std::size_t devices) {
  std::vector<std::uint64_t> weights;
  for (const ShapeModel& model : models) weights.push_back(sample_count(model));
  return balanced_ranges(weights, int(std::clamp<std::size_t>(models.size(), 1, devices)));
}

}  // namespace

void limit_cpu_threads(int threads) {
  constexpr int keep_users_choice = 0;
  setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(std::max(1, threads)).c_str(), keep_users_choice);
}

std::unique_ptr<Matcher> make_device_matcher(const std::string& devices_use, const MatchingContext& context,
                                             std::uint32_t first_shape, std::vector<ShapeModel> models) {
  const std::vector<cl::Device> devices = chosen_devices(devices_use);
  const std::vector<ShapeRange> ranges = parts_of(models, devices.size());
  std::vector<std::unique_ptr<Matcher>> parts;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const std::vector<ShapeModel> own(std::make_move_iterator(models.begin() + ranges[i].begin),
                                      std::make_move_iterator(models.begin() + ranges[i].end));
    parts.push_back(std::make_unique<OpenCLMatcher>(devices[i], context, first_shape + ranges[i].begin, own));
  }
  if (parts.size() == 1) return std::move(parts.front());
  return std::make_unique<CompositeMatcher>(std::move(parts));
}

}  // namespace tessera::worker
