// It runs once as it is, and once with two different devices (tests/worker/CMakeLists.txt).
#include "worker/device_speed.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "worker/device_group.h"
#include "worker/devices/opencl_devices.h"

namespace tessera::worker {
namespace test_device_speed {

std::vector<std::uint32_t> sizes_of(const std::vector<DevicePart>& parts) {
  std::vector<std::uint32_t> sizes;
  for (const DevicePart& part : parts) sizes.push_back(part.shapes.end - part.shapes.begin);
  return sizes;
}

TEST(DeviceSpeeds, EqualDevicesAreNotMeasured) {
  const std::vector<cl::Device> devices(3, opencl_devices().front());
  EXPECT_FALSE(devices_differ(devices));
  int launches = 0;
  EXPECT_EQ(device_speeds(devices, {}, [&] { ++launches; }), (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(launches, 0);
}

/// Divides shapes between two different devices.
class DifferentDevices : public testing::Test {
 protected:
  void SetUp() override {
    if (!devices_differ(opencl_devices())) GTEST_SKIP() << "runs where devices differ";
    ASSERT_EQ(opencl_devices().size(), 2u);
  }

  static std::vector<DevicePart> parts(std::uint32_t shapes, const BetweenLaunches& between_launches = {}) {
    const MatchingContext context = make_matching_context(CollageSettings(), 7 + shapes);
    return device_parts("all", context, {7, 7 + shapes}, {}, {}, between_launches);
  }
};

TEST_F(DifferentDevices, AreMeasured) {
  for (const double speed : device_speeds(opencl_devices(), {})) EXPECT_GT(speed, 0);
}

TEST_F(DifferentDevices, GetAllShapesBetweenThem) {
  const std::vector<DevicePart> divided = parts(1000);
  ASSERT_EQ(divided.size(), 2u);
  EXPECT_EQ(divided[0].shapes.begin, 7u);
  EXPECT_EQ(divided[0].shapes.end, divided[1].shapes.begin);
  EXPECT_EQ(divided[1].shapes.end, 1007u);
  EXPECT_EQ(describe(divided)[0].shapes, sizes_of(divided)[0]);
}

/// The first device is delayed between its launches; both devices have about equally many.
TEST_F(DifferentDevices, TheSlowerOneGetsFewerShapes) {
  int launches = 0;
  parts(1000, [&] { ++launches; });
  ASSERT_GT(launches, 10);
  int left = launches / 2;
  const std::vector<std::uint32_t> sizes = sizes_of(parts(1000, [&] {
    if (--left >= 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }));
  EXPECT_LT(sizes[0], sizes[1] / 2);
}

TEST_F(DifferentDevices, AreNotMeasuredWhereEachGetsOneShape) {
  int launches = 0;
  EXPECT_EQ(sizes_of(parts(2, [&] { ++launches; })), (std::vector<std::uint32_t>{1, 1}));
  EXPECT_EQ(launches, 0);
}

}  // namespace test_device_speed
}  // namespace tessera::worker
