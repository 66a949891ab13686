// Large buffers on a CPU use huge pages, and are freed.
#include "worker/devices/device_memory.h"

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "worker/devices/opencl_devices.h"

namespace tessera::worker {
namespace test_device_memory {

constexpr std::size_t kLarge = std::size_t(64) << 20;

/// The resident memory of this process, in kB.
std::size_t resident_kb() {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("VmRSS:")) return std::stoul(line.substr(6));
  }
  return 0;
}

/// The flags of the mapping that holds an address ("hg": huge pages were requested).
std::string flags_of_mapping(const void* address) {
  std::ifstream in("/proc/self/smaps");
  bool holds = false;
  for (std::string line; std::getline(in, line);) {
    std::uintptr_t begin = 0;
    std::uintptr_t end = 0;
    if (std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR " ", &begin, &end) == 2) {
      holds = reinterpret_cast<std::uintptr_t>(address) >= begin && reinterpret_cast<std::uintptr_t>(address) < end;
    }
    if (holds && line.starts_with("VmFlags:")) return line + " ";
  }
  return {};
}

struct Device {
  cl::Device device = opencl_devices().front();
  cl::Context context{device};
  cl::CommandQueue queue{context, device};
};

TEST(DeviceMemory, OfLargeBuffersIsInHugePages) {
  const Device on;
  if (!(on.device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU)) GTEST_SKIP() << "the first device is no CPU";
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) GTEST_SKIP() << "this system has no huge pages";
  const cl::Buffer large = make_device_buffer(on.context, on.device, kLarge);
  const void* const memory = large.getInfo<CL_MEM_HOST_PTR>();
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % (2 << 20), 0u);
  EXPECT_NE(flags_of_mapping(memory).find(" hg "), std::string::npos) << flags_of_mapping(memory);
  EXPECT_EQ(make_device_buffer(on.context, on.device, 1000).getInfo<CL_MEM_HOST_PTR>(), nullptr);
}

/// If a caller gives up, the posted work still ends, and then the memory is freed.
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
  EXPECT_LT(resident_kb(), 20 * kLarge / 1024) << "half of all";
}

}  // namespace test_device_memory
}  // namespace tessera::worker
