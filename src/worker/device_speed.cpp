#include "worker/device_speed.h"

#include <algorithm>
#include <array>

#include "core/base/stopwatch.h"
#include "worker/opencl_matcher.h"
#include "worker/speed_task.h"

namespace tessera::worker {
namespace {

constexpr std::size_t kTimes = 3;  // the middle time counts, because other programs may use the machine

double tasks_per_s(const cl::Device& device, const SpeedTask& task, const BetweenLaunches& between_launches) {
  OpenCLMatcher matcher(device, task.context, all_of(task.models), given(task.models), between_launches);
  matcher.start_field(task.field.value.width(), task.field.value.height(), task.field.origin);
  matcher.update_field({read_patch(task.field.value, task.field.value.bounds())});
  do_speed_task(matcher, task);  // some devices compile at the first launch
  std::array<double, kTimes> times_s;
  for (double& time_s : times_s) {
    const Stopwatch watch;
    do_speed_task(matcher, task);
    time_s = watch.seconds();
  }
  std::nth_element(times_s.begin(), times_s.begin() + kTimes / 2, times_s.end());
  return 1 / times_s[kTimes / 2];
}

}  // namespace

bool devices_differ(const std::vector<cl::Device>& devices) {
  return std::any_of(devices.begin(), devices.end(), [&](const cl::Device& device) {
    const cl::Device& first = devices.front();
    return device.getInfo<CL_DEVICE_NAME>() != first.getInfo<CL_DEVICE_NAME>() ||
           device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>() != first.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
  });
}

std::vector<double> device_speeds(const std::vector<cl::Device>& devices, const PadParameters& pad,
                                  const BetweenLaunches& between_launches) {
  std::vector<double> speeds(devices.size(), 1);
  if (!devices_differ(devices)) return speeds;
  const SpeedTask task = make_speed_task(pad);
  for (std::size_t i = 0; i < devices.size(); ++i) speeds[i] = tasks_per_s(devices[i], task, between_launches);
  return speeds;
}

}  // namespace tessera::worker
