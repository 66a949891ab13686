// Faults that keep a driver from working, explained in messages.
#include "worker/devices/driver_faults.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace tessera::worker {
namespace test_driver_faults {

/// A folder of .icd files. OCL_ICD_VENDORS names it while an object of this class lives.
class DriverList : public testing::Test {
 protected:
  DriverList() {
    std::filesystem::create_directory(folder_);
    setenv("OCL_ICD_VENDORS", folder_.c_str(), 1);
  }
  ~DriverList() override {
    std::filesystem::remove_all(folder_);
    unsetenv("OCL_ICD_VENDORS");
  }
  void list(const std::string& file, const std::string& library) const {
    std::ofstream(folder_ / file) << library << "\n";
  }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("tessera_driver_list_" + std::to_string(getpid()));
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(DriverList, IsWithoutFaultsWhereItsLibrariesLoad) {
  list("good.icd", "libc.so.6");
  EXPECT_TRUE(driver_list_faults().empty());
}

TEST_F(DriverList, NamesTheFileOfALibraryThatCannotBeLoaded) {
  list("b.icd", "libmissing.so.7");
  list("a.icd", "");
  list("ignored.txt", "libmissing.so.8");
  const std::vector<std::string> faults = driver_list_faults();
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_TRUE(has(faults[0], (folder() / "a.icd").string()) && has(faults[0], "empty")) << faults[0];
  EXPECT_TRUE(has(faults[1], (folder() / "b.icd").string()) && has(faults[1], "libmissing.so.7")) << faults[1];
}

TEST_F(DriverList, MayBeASingleFileOrALibrary) {
  list("one.icd", "libmissing.so.7");
  setenv("OCL_ICD_VENDORS", (folder() / "one.icd").c_str(), 1);
  EXPECT_EQ(driver_list_faults().size(), 1u);
  setenv("OCL_ICD_VENDORS", "libmissing.so.7", 1);
  EXPECT_EQ(driver_list_faults().size(), 1u);
  setenv("OCL_ICD_VENDORS", "libc.so.6", 1);
  EXPECT_TRUE(driver_list_faults().empty());
}

TEST_F(DriverList, TellsOfACardWithoutItsLibrary) {
  list("good.icd", "libc.so.6");
  std::ofstream(folder() / "nvidiactl");
  const std::vector<std::string> faults = driver_list_faults(folder());
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_TRUE(has(faults[0], "card of NVIDIA") && has(faults[0], "libnvidia-opencl.so.1")) << faults[0];
  list("nvidia.icd", "libnvidia-opencl.so.1");  // reported once: the library of the list cannot be loaded
  EXPECT_EQ(driver_list_faults(folder()).size(), 1u);
  std::filesystem::remove(folder() / "nvidiactl");
  std::filesystem::remove(folder() / "nvidia.icd");
  EXPECT_TRUE(driver_list_faults(folder()).empty());
}

TEST(CompilerFault, IsTheLogOrWhatMayHelpWithoutOne) {
  EXPECT_EQ(compiler_fault("line 3: no such function", -11), "line 3: no such function");
  EXPECT_TRUE(has(compiler_fault(" \n", -11), "code -11")) << compiler_fault(" \n", -11);
  EXPECT_TRUE(has(compiler_fault("", -11), "libnvidia-nvvm"));
}

}  // namespace test_driver_faults
}  // namespace tessera::worker
