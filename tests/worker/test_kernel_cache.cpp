// The folder for compiled kernels: the user's choice, the node's own folder, or none.
#include "worker/devices/kernel_cache.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace tessera::worker {
namespace test_kernel_cache {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

/// Every test has its own TMPDIR and starts without the drivers' variables.
class KernelCacheTest : public testing::Test {
 protected:
  KernelCacheTest() {
    std::filesystem::create_directory(folder_);
    setenv("TMPDIR", folder_.c_str(), 1);
    for (const char* const name : {"POCL_CACHE_DIR", "CUDA_CACHE_PATH", "CUDA_CACHE_DISABLE"}) unsetenv(name);
  }
  ~KernelCacheTest() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path of_node() const { return folder_ / ("tessera-kernels-" + std::to_string(getuid())); }

  const std::filesystem::path folder_ = "/tmp/tessera_kernel_cache_" + std::to_string(getpid());
};

TEST_F(KernelCacheTest, LiesOnTheNodesOwnDisk) {
  const KernelCache cache = choose_kernel_cache();
  EXPECT_TRUE(cache.kept);
  EXPECT_EQ(cache.pocl, of_node() / "pocl");
  EXPECT_EQ(variable("POCL_CACHE_DIR"), of_node() / "pocl");
  EXPECT_EQ(variable("CUDA_CACHE_PATH"), of_node() / "cuda");
  EXPECT_EQ(variable("CUDA_CACHE_DISABLE"), "");
  struct stat made = {};
  ASSERT_EQ(stat(of_node().c_str(), &made), 0);
  EXPECT_EQ(made.st_mode & 0777, 0700u);
}

TEST_F(KernelCacheTest, IsWhereTheUserSays) {
  setenv("POCL_CACHE_DIR", (folder_ / "mine").c_str(), 1);
  EXPECT_EQ(choose_kernel_cache().pocl, folder_ / "mine");
  EXPECT_EQ(variable("POCL_CACHE_DIR"), folder_ / "mine");
  EXPECT_EQ(variable("CUDA_CACHE_PATH"), of_node() / "cuda");
}

TEST_F(KernelCacheTest, LeavesAFolderThatCannotBeWritten) {
  setenv("POCL_CACHE_DIR", "/dev/null/cache", 1);
  EXPECT_EQ(choose_kernel_cache().pocl, of_node() / "pocl");
}

TEST_F(KernelCacheTest, IsNoFolderOfSomebodyElse) {
  const std::filesystem::path elsewhere = folder_ / "elsewhere";
  std::filesystem::create_directory(elsewhere);
  std::filesystem::create_directory_symlink(elsewhere, of_node());
  const KernelCache cache = choose_kernel_cache();
  EXPECT_FALSE(cache.kept);
  EXPECT_EQ(variable("CUDA_CACHE_DISABLE"), "1");
  EXPECT_TRUE(std::filesystem::is_directory(cache.pocl)) << cache.pocl;
  EXPECT_TRUE(std::filesystem::is_empty(elsewhere));
  std::filesystem::remove(of_node());
  std::filesystem::create_directory(of_node());
  unsetenv("POCL_CACHE_DIR");
  chmod(of_node().c_str(), 0777);  // any user could put kernels there
  EXPECT_FALSE(choose_kernel_cache().kept);
}

}  // namespace test_kernel_cache
}  // namespace tessera::worker
