// Where OpenCL's drivers keep the kernels that they compiled. Their own choice is the home folder. On a cluster all
// nodes share it: it is slow, and ranks of several nodes would write the same files there.
#pragma once

#include <filesystem>
#include <string>

namespace tessera::worker {

struct KernelCache {
  std::filesystem::path pocl;  // empty: nobody found a folder that can be written, PoCL tries the home folder
  bool kept = true;            // for the next process
};

/// Sets the drivers' variables (POCL_CACHE_DIR, CUDA_CACHE_PATH) for this process. What the user set stays where that
/// folder can be written. Otherwise kernels lie in $TMPDIR/tessera-kernels-UID, /tmp where TMPDIR is not set. Where that
/// is not ours, PoCL gets a folder that is removed when the process ends, and CUDA compiles in memory.
KernelCache choose_kernel_cache();

/// As choose_kernel_cache(), which it calls once, before the first call of OpenCL.
const KernelCache& kernel_cache();

/// For `tessera devices`: one sentence.
std::string kernel_cache_text(const KernelCache& cache);

}  // namespace tessera::worker
