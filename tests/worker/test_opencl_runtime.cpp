// Work that is too much for one launch is divided, and every work item runs once.
#include "worker/devices/opencl_runtime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "worker/devices/opencl_devices.h"

namespace tessera::worker {
namespace test_opencl_runtime {

constexpr const char* kCountVisits =
    "kernel void count_visits(uint width, global uint* visits) {\n"
    "  const size_t x = get_global_id(0);\n"
    "  if (x < width) atomic_inc(visits + get_global_id(1) * width + x);\n"
    "}\n";

/// How many launches there were; every work item must have run once.
int launches_for(const WorkSize& size) {
  int launches = 0;
  const DeviceSession session(opencl_devices().front(), kCountVisits, "-cl-std=CL1.2", [&] { ++launches; });
  cl::Kernel kernel = session.kernel("count_visits");
  DeviceBuffer<std::uint32_t> visits(session);
  visits.clear(size.x * size.y);
  launch(session, kernel, size, std::uint32_t(size.x), visits);
  const std::vector<std::uint32_t> found = visits.read(size.x * size.y);
  EXPECT_TRUE(std::all_of(found.begin(), found.end(), [](std::uint32_t count) { return count == 1; }));
  return launches;
}

TEST(Launch, OfLittleWorkIsOne) {
  EXPECT_EQ(launches_for({1, 1, 1}), 1);
  EXPECT_EQ(launches_for({64, 232, 16}), 1);
  EXPECT_EQ(launches_for({kMostWorkItems, 1, 16}), 1);
}

TEST(Launch, OfMuchWorkIsDividedByRows) {
  EXPECT_EQ(launches_for({60, 3 * kMostWorkItems / 64, 16}), 3);  // 64 columns in groups of 16
  EXPECT_EQ(launches_for({60, 3 * kMostWorkItems / 64 + 1, 16}), 4);
}

TEST(Launch, OfLongRowsIsDividedWithinThem) {
  EXPECT_EQ(launches_for({kMostWorkItems + 1, 2, 16}), 4);
  EXPECT_EQ(launches_for({2 * kMostWorkItems + 5, 1, 24}), 3);  // the limit is no multiple of the group
}

/// Kernels with faults, for checked_kernels_test.sh alone: they show that its tools find them.
class Faulty : public testing::Test {
 protected:
  static constexpr std::size_t kPlaces = 1024;  // 4 KB: PoCL makes buffers larger, up to the next 128 bytes

  void SetUp() override {
    if (!std::getenv("TESSERA_TEST_FAULTY")) GTEST_SKIP() << "runs where faults are looked for";
  }

  static void run(const std::string& body, std::size_t items) {
    const std::string source = "kernel void faulty(uint n, global uint* place) {\n" + body + "\n}\n";
    const DeviceSession session(opencl_devices().front(), source, "-cl-std=CL1.2 -cl-opt-disable");
    cl::Kernel kernel = session.kernel("faulty");
    DeviceBuffer<std::uint32_t> place(session);
    place.reserve(kPlaces);
    launch(session, kernel, {items, 1, 1}, std::uint32_t(kPlaces), place);
    place.read(1);
  }
};

/// The first place beyond: farther away may be another living block, which hides the fault.
TEST_F(Faulty, ReadsBeyondItsBuffer) { run("place[0] = place[n];", 1); }

TEST_F(Faulty, DecidesByWhatNobodyWrote) { run("if (place[7] > 3) place[0] = 1;", 1); }

TEST_F(Faulty, TwoItemsWriteTheSamePlace) { run("for (uint i = 0; i < 100000; ++i) place[0] += 1;", 64); }

/// Of the test's variants, whose surroundings must have an effect.
TEST(Launch, KnowsTheGroupsThatTheDeviceAllows) {
  const char* const most = std::getenv("POCL_MAX_WORK_GROUP_SIZE");
  if (!most) GTEST_SKIP() << "runs where groups are limited";
  EXPECT_EQ(opencl_devices().front().getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>(), std::size_t(std::atoi(most)));
}

/// Where the device allows groups of 8 only, it gets none (tests/worker/CMakeLists.txt).
TEST(Launch, AKernelThatNeedsGroupsGetsThemAndNoOthers) {
  const cl::Device device = opencl_devices().front();
  const DeviceSession session(device,
                              "kernel __attribute__((reqd_work_group_size(16, 1, 1))) void sizes(global uint* size) {\n"
                              "  size[get_global_id(0)] = get_local_size(0);\n"
                              "}\n",
                              "-cl-std=CL1.2");
  cl::Kernel kernel = session.kernel("sizes");
  DeviceBuffer<std::uint32_t> size(session);
  size.clear(48);
  EXPECT_THROW(launch(session, kernel, {48, 1, 8}, size), std::logic_error);
  if (device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>() < 16) {
    EXPECT_THROW(launch(session, kernel, {48, 1, 16}, size), EnvironmentError);
  } else {
    launch(session, kernel, {48, 1, 16}, size);
    EXPECT_EQ(size.read(48), std::vector<std::uint32_t>(48, 16));
  }
}

TEST(Launch, OfManyRowsKeepsWithinAGrid) {
  EXPECT_EQ(launches_for({1, kMostRows, 1}), 1);
  EXPECT_EQ(launches_for({1, kMostRows + 1, 1}), 2);
}

}  // namespace test_opencl_runtime
}  // namespace tessera::worker
