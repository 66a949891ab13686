#include "worker/devices/kernel_cache.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>

namespace tessera::worker {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPoclVariable = "POCL_CACHE_DIR";
constexpr const char* kCudaVariable = "CUDA_CACHE_PATH";

/// A folder that is removed with its content when the process ends.
class PrivateFolder {
 public:
  PrivateFolder() = default;
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  ~PrivateFolder() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }
  /// The folder's path, made by the first call. Empty where no place can be written.
  const fs::path& get() {
    const char* const temporary = std::getenv("TMPDIR");
    for (const char* const place : {temporary, "/tmp", "/dev/shm"}) {
      if (!place || !folder_.empty()) continue;
      std::string name = std::string(place) + "/tessera-kernels-XXXXXX";
      if (mkdtemp(name.data())) folder_ = name;
    }
    return folder_;
  }

 private:
  fs::path folder_;
};

bool can_be_written(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  return !failed && access(folder.c_str(), W_OK | X_OK) == 0;
}

/// The folder that all ranks of this user share on this node. Empty where somebody else owns a folder of that name.
std::optional<fs::path> folder_of_node() {
  const char* const temporary = std::getenv("TMPDIR");
  const fs::path folder =
      fs::path(temporary && *temporary ? temporary : "/tmp") / ("tessera-kernels-" + std::to_string(getuid()));
  mkdir(folder.c_str(), S_IRWXU);  // it may be there already
  struct stat found = {};
  const bool ours = lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == geteuid() &&
                    (found.st_mode & (S_IWGRP | S_IWOTH)) == 0;
  if (!ours || !can_be_written(folder)) return std::nullopt;
  return folder;
}

/// The folder that the user chose for a driver, otherwise one in the node's folder.
std::optional<fs::path> lasting_folder(const char* variable, const char* name) {
  const char* const chosen = std::getenv(variable);
  if (chosen && *chosen && can_be_written(chosen)) return chosen;
  const std::optional<fs::path> of_node = folder_of_node();
  if (!of_node || !can_be_written(*of_node / name)) return std::nullopt;
  return *of_node / name;
}

constexpr int kReplaces = 1;

}  // namespace

KernelCache choose_kernel_cache() {
  static PrivateFolder private_folder;
  if (const auto cuda = lasting_folder(kCudaVariable, "cuda")) {
    setenv(kCudaVariable, cuda->c_str(), kReplaces);
  } else {
    setenv("CUDA_CACHE_DISABLE", "1", kReplaces);
  }
  KernelCache cache;
  const auto pocl = lasting_folder(kPoclVariable, "pocl");
  cache.kept = pocl.has_value();
  cache.pocl = pocl ? *pocl : private_folder.get();
  if (!cache.pocl.empty()) setenv(kPoclVariable, cache.pocl.c_str(), kReplaces);
  return cache;
}

const KernelCache& kernel_cache() {
  static const KernelCache cache = choose_kernel_cache();
  return cache;
}

std::string kernel_cache_text(const KernelCache& cache) {
  if (cache.kept) return "Compiled kernels are kept in " + cache.pocl.string() + ".";
  return "Compiled kernels are not kept, so that every process compiles them again: neither the folder that "
         "POCL_CACHE_DIR names nor TMPDIR (/tmp) can be written.";
}

}  // namespace tessera::worker
