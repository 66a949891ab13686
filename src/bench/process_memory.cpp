#include "bench/process_memory.h"

#include <malloc.h>

#include <fstream>
#include <string>

namespace tessera::bench {

void reset_peak_memory() {
  malloc_trim(0);  // memory that is already free must not count
  std::ofstream("/proc/self/clear_refs") << "5";
}

std::uint64_t peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kib = 0;
    if (word == "VmHWM:" && status >> kib) return kib * 1024;
  }
  return 0;
}

}  // namespace tessera::bench
