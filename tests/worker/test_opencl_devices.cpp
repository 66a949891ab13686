#include "worker/devices/opencl_devices.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "worker/device_group.h"
#include "worker/devices/device_kernel.h"

namespace tessera::worker {
namespace test_opencl_devices {

/// The message of the error when `use` chooses the devices.
template <class Error>
std::string refusal(const std::string& use) {
  try {
    chosen_devices(use);
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "devices.use = \"" << use << "\" was accepted, or refused in another way";
  return "";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count_of_kind(cl_device_type kind) {
  std::size_t count = 0;
  for (const cl::Device& device : opencl_devices()) count += (device.getInfo<CL_DEVICE_TYPE>() & kind) != 0;
  return count;
}

TEST(ChosenDevices, AllAreAll) { EXPECT_EQ(chosen_devices("all").size(), opencl_devices().size()); }

TEST(ChosenDevices, ByIndex) {
  const std::vector<cl::Device> chosen = chosen_devices("0");
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_EQ(chosen.front()(), opencl_devices().front()());
}

TEST(ChosenDevices, ByKind) {
  for (const auto& [use, kind] : {std::pair("cpu", CL_DEVICE_TYPE_CPU), std::pair("gpu", CL_DEVICE_TYPE_GPU)}) {
    if (count_of_kind(kind) > 0) {
      EXPECT_EQ(chosen_devices(use).size(), count_of_kind(kind));
    } else {
      const std::string message = refusal<EnvironmentError>(use);
      EXPECT_TRUE(has(message, use)) << message;
      EXPECT_TRUE(has(message, opencl_devices().front().getInfo<CL_DEVICE_NAME>())) << message;
    }
  }
}

TEST(OwnDevices, AllOfThemUnlessSharesAreAskedFor) {
  EXPECT_EQ(own_devices(3, {}), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(own_devices(3, {1, 2, 0}), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(OwnDevices, SharesAreNeighboursAndDoNotOverlap) {
  EXPECT_EQ(own_devices(4, {0, 2, 2}), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(own_devices(4, {1, 2, 2}), (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(own_devices(4, {2, 3, 1}), (std::vector<std::size_t>{2})) << "one is left over";
}

TEST(OwnDevices, TooFewAreRefusedWithTheCure) {
  try {
    own_devices(2, {0, 3, 1});
    FAIL() << "three workers had two devices";
  } catch (const InputError& error) {
    EXPECT_TRUE(
        has(error.what(), "devices.per_worker = 1: 3 workers of this node need 3 devices, and it has 2; allowed"))
        << error.what();
  }
}

TEST(ChosenDevices, RefusalsSayWhatThereIs) {
  for (const std::string use : {"7", "0,7", "0,0", "x", "-1", "", "0 1", "99999999999999999999", "CPU"}) {
    const std::string message = refusal<InputError>(use);
    EXPECT_TRUE(has(message, "devices.use")) << message;
    EXPECT_TRUE(has(message, "0: ")) << message;
    EXPECT_FALSE(has(message, "\n")) << message;
  }
}

TEST(ChosenDevices, RefusalsNameTheOptionThatWasGiven) {
  for (const std::string use : {"7", "x"}) {
    try {
      chosen_devices(use, {}, "--devices");
      FAIL() << use;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("--devices " + use + ": ")) << error.what();
      EXPECT_FALSE(has(error.what(), "devices.use")) << error.what();
    }
  }
}

TEST(LimitCpuThreads, LeavesTheUsersChoice) {
  setenv("POCL_MAX_PTHREAD_COUNT", "3", 1);
  limit_cpu_threads(1);
  EXPECT_STREQ(std::getenv("POCL_MAX_PTHREAD_COUNT"), "3");
  unsetenv("POCL_MAX_PTHREAD_COUNT");
  limit_cpu_threads(0);
  EXPECT_STREQ(std::getenv("POCL_MAX_PTHREAD_COUNT"), "1");
}

TEST(DeviceSession, ShowsTheCompilersMessageInOneLine) {
  try {
    DeviceSession(opencl_devices().front(), "kernel void broken() {\n  no_such_function();\n}\n", "-cl-std=CL1.2");
    FAIL() << "compiled";
  } catch (const EnvironmentError& error) {
    EXPECT_TRUE(has(error.what(), "no_such_function")) << error.what();
    EXPECT_FALSE(has(error.what(), "\n")) << error.what();
  }
}

TEST(DeviceKernel, AFailingCallNamesItselfAndTheDevice) {
  const DeviceSession session(opencl_devices().front(), "kernel void one(uint a) {}", "-cl-std=CL1.2");
  try {
    DeviceKernel(session, "two");
    FAIL() << "there is no such kernel";
  } catch (const EnvironmentError& error) {
    EXPECT_TRUE(has(error.what(), "clCreateKernel")) << error.what();
    EXPECT_TRUE(has(error.what(), session.name())) << error.what();
  }
}

/// ctest starts it with an empty folder as the list of platforms (tests/worker/CMakeLists.txt).
TEST(NoPlatform, IsOneClearLine) {
  const char* const devices = std::getenv("TESSERA_TEST_DEVICES");
  if (!devices || std::string(devices) != "0") GTEST_SKIP() << "runs where there is no platform";
  const std::string message = refusal<EnvironmentError>("all");
  EXPECT_TRUE(has(message, "pocl-opencl-icd")) << message;
}

}  // namespace test_opencl_devices
}  // namespace tessera::worker
