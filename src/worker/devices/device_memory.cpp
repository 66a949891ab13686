#include "worker/devices/device_memory.h"

#include <sys/mman.h>

#include <cstdint>
#include <memory>

namespace tessera::worker {
namespace {

constexpr std::size_t kHugePage = std::size_t(2) << 20;
constexpr std::size_t kLargeBuffer = 8 * kHugePage;

/// Memory that is mapped for one buffer and given back as a whole, whatever malloc keeps.
class HugePages {
 public:
  explicit HugePages(std::size_t bytes)
      : bytes_(bytes + 2 * kHugePage),
        memory_(mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) throw cl::Error(CL_MEM_OBJECT_ALLOCATION_FAILURE, "mmap");
    madvise(memory_, bytes_, MADV_HUGEPAGE);  // small pages do as well, but take longer
  }
  ~HugePages() { munmap(memory_, bytes_); }
  HugePages(const HugePages&) = delete;
  HugePages& operator=(const HugePages&) = delete;

  void* first_whole() const {
    return reinterpret_cast<void*>((reinterpret_cast<std::uintptr_t>(memory_) + kHugePage - 1) & ~(kHugePage - 1));
  }

 private:
  std::size_t bytes_;
  void* memory_;
};

bool has_memory_of_its_own(const cl::Device& device) {
  return !(device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) || !device.getInfo<CL_DEVICE_HOST_UNIFIED_MEMORY>();
}

}  // namespace

cl::Buffer make_device_buffer(const cl::Context& context, const cl::Device& device, std::size_t bytes) {
  if (bytes < kLargeBuffer || has_memory_of_its_own(device)) return cl::Buffer(context, CL_MEM_READ_WRITE, bytes);
  auto memory = std::make_unique<HugePages>(bytes);
  cl::Buffer buffer(context, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, bytes, memory->first_whole());
  // OpenCL commands may hold the buffer longer than the caller does.
  buffer.setDestructorCallback([](cl_mem, void* unused) { delete static_cast<HugePages*>(unused); }, memory.get());
  memory.release();
  return buffer;
}

}  // namespace tessera::worker
