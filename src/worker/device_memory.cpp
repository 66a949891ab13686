#include "worker/device_memory.h"

#include <sys/mman.h>

#include <cstdlib>
#include <memory>

namespace tessera::worker {
namespace {

constexpr std::size_t kHugePage = std::size_t(2) << 20;
constexpr std::size_t kLargeBuffer = 8 * kHugePage;

struct Free {
  void operator()(void* memory) const { std::free(memory); }
};
using HostMemory = std::unique_ptr<void, Free>;

/// None where there is none left: the device then says so.
HostMemory huge_pages(std::size_t bytes) {
  const std::size_t rounded = (bytes + kHugePage - 1) / kHugePage * kHugePage;
  HostMemory memory(std::aligned_alloc(kHugePage, rounded));
  if (memory) madvise(memory.get(), rounded, MADV_HUGEPAGE);  // small pages do as well, but take longer
  return memory;
}

bool uses_own_memory(const cl::Device& device) {
  return (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) == 0 || !device.getInfo<CL_DEVICE_HOST_UNIFIED_MEMORY>();
}

}  // namespace

cl::Buffer make_device_buffer(const cl::Context& context, const cl::Device& device, std::size_t bytes) {
  HostMemory memory = bytes < kLargeBuffer || uses_own_memory(device) ? nullptr : huge_pages(bytes);
  if (!memory) return cl::Buffer(context, CL_MEM_READ_WRITE, bytes);
  cl::Buffer buffer(context, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, bytes, memory.get());
  // Commands may hold the buffer longer than we do.
  buffer.setDestructorCallback([](cl_mem, void* freed) { std::free(freed); }, memory.get());
  memory.release();
  return buffer;
}

}  // namespace tessera::worker
