// The folders in which OpenCL's drivers keep compiled kernels. Drivers choose the home folder by themselves. All nodes of a
// cluster share it: it is slow, and ranks of several nodes would write the same files there.
#pragma once

#include <filesystem>
#include <string>

namespace tessera::worker {

struct KernelCache {
  std::filesystem::path pocl;  // empty: no folder can be written, PoCL tries the home folder
  bool kept = true;            // kernels are kept for the next process
};

/// Sets the drivers' variables (POCL_CACHE_DIR, CUDA_CACHE_PATH) for this process. A folder that the user set stays where
/// it can be written. Otherwise kernels lie in $TMPDIR/tessera-kernels-UID (/tmp where TMPDIR is not set). Where that
/// folder belongs to somebody else, PoCL gets a folder that is removed when the process ends, and CUDA compiles in memory.
KernelCache choose_kernel_cache();

/// The result of choose_kernel_cache(), which is called once, before the first call of OpenCL.
const KernelCache& kernel_cache();

/// One sentence about the cache for `tessera devices`.
std::string kernel_cache_text(const KernelCache& cache);

}  // namespace tessera::worker
