// Large buffers of a CPU are in huge pages, and given back.
#include "worker/device_memory.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "worker/opencl_devices.h"

namespace tessera::worker {
namespace {

constexpr std::size_t kLarge = std::size_t(64) << 20;

/// Of this process, kB.
std::size_t all_of(const std::string& file, const std::string& key) {
  std::ifstream in(file);
  std::size_t sum = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(key + ":")) sum += std::stoul(line.substr(key.size() + 1));
  }
  return sum;
}

bool system_has_huge_pages() {
  std::ifstream in("/sys/kernel/mm/transparent_hugepage/enabled");
  std::string line;
  return std::getline(in, line) && line.find("[never]") == std::string::npos;
}

struct Device {
  cl::Device device = opencl_devices().front();
  cl::Context context{device};
  cl::CommandQueue queue{context, device};
};

TEST(DeviceMemory, OfLargeBuffersIsInHugePages) {
  const Device on;
  if (!(on.device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU)) GTEST_SKIP() << "the first device is no CPU";
  if (!system_has_huge_pages()) GTEST_SKIP() << "this system has no huge pages";
  const std::size_t before = all_of("/proc/self/smaps", "AnonHugePages");
  const cl::Buffer buffer = make_device_buffer(on.context, on.device, kLarge);
  const std::vector<std::uint8_t> content(kLarge, 7);
  on.queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, kLarge, content.data());
  EXPECT_GE(all_of("/proc/self/smaps", "AnonHugePages") - before, kLarge / 1024 / 2);
}

/// Whoever gives it up, what was posted still ends; and then the memory is free.
TEST(DeviceMemory, IsFreeWhenNothingUsesItAnyMore) {
  const Device on;
  const std::vector<std::uint8_t> content(kLarge, 7);
  std::vector<std::uint8_t> found(kLarge);
  for (int i = 0; i < 40; ++i) {
    cl::Buffer buffer = make_device_buffer(on.context, on.device, kLarge);
    on.queue.enqueueWriteBuffer(buffer, CL_FALSE, 0, kLarge, content.data());
    on.queue.enqueueReadBuffer(buffer, CL_FALSE, 0, kLarge, found.data());
    buffer = cl::Buffer();
    on.queue.finish();
    ASSERT_EQ(found, content);
    found.assign(kLarge, 0);
  }
  EXPECT_LT(all_of("/proc/self/status", "VmRSS"), 20 * kLarge / 1024) << "half of all";
}

}  // namespace
}  // namespace tessera::worker
