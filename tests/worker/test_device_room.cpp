// The number of shapes that fit on a device, and the division of a library among devices that cannot hold all of it.
#include "worker/device_room.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "worker/devices/opencl_devices.h"
#include "worker/shard/shard.h"

namespace tessera::worker {
namespace test_device_room {

constexpr std::uint64_t kPlenty = std::uint64_t(1) << 40;
constexpr std::uint32_t kShapes = 20'000;

const MatchingContext& context() {
  static const MatchingContext made = make_matching_context(CollageSettings(), kShapes);
  return made;
}

std::vector<std::uint32_t> sizes(const std::vector<double>& speeds, const std::vector<DeviceRoom>& rooms,
                                 const DeviceNeeds& needs = {}) {
  std::vector<std::uint32_t> sizes;
  std::uint32_t end = 7;
  for (const ShapeRange& part : parts_that_fit({7, 7 + kShapes}, speeds, rooms, context(), needs)) {
    EXPECT_EQ(part.begin, end);
    end = part.end;
    sizes.push_back(part.size());
  }
  EXPECT_EQ(end, 7 + kShapes);
  return sizes;
}

TEST(ShapesThatFit, AreAsManyAsTheMemoryHolds) {
  const std::uint64_t memory = device_bytes(context(), 5000, {});
  EXPECT_EQ(shapes_that_fit({"", memory, kPlenty}, context(), {}, kShapes), 5000u);
  EXPECT_EQ(shapes_that_fit({"", memory - 1, kPlenty}, context(), {}, kShapes), 4999u);
  EXPECT_EQ(shapes_that_fit({"", kPlenty, kPlenty}, context(), {}, kShapes), kShapes);
  EXPECT_EQ(shapes_that_fit({"", 0, kPlenty}, context(), {}, kShapes), 0u);
}

TEST(ShapesThatFit, AreNoMoreThanTheLargestBufferHolds) {
  const std::uint64_t buffer = shard_bytes(context(), 5000, true).largest_buffer;
  const std::size_t most = shapes_that_fit({"", kPlenty, buffer}, context(), {}, kShapes);
  EXPECT_GE(most, 5000u);
  EXPECT_LE(shard_bytes(context(), most, true).largest_buffer, buffer);
  EXPECT_GT(shard_bytes(context(), most + 1, true).largest_buffer, buffer);
}

TEST(ShapesThatFit, LeaveRoomForTheField) {
  const DeviceNeeds large{.field_nodes = 1e8};
  EXPECT_EQ(device_bytes(context(), 5000, large) - device_bytes(context(), 5000, {}), 400'000'000u);
  EXPECT_LT(shapes_that_fit({"", 600'000'000, kPlenty}, context(), large, kShapes),
            shapes_that_fit({"", 600'000'000, kPlenty}, context(), {}, kShapes));
}

TEST(PartsThatFit, AreBySpeedWhereThereIsRoom) {
  EXPECT_EQ(sizes({3, 1}, {{"a", kPlenty, kPlenty}, {"b", kPlenty, kPlenty}}), (std::vector{15'000u, 5'000u}));
}

/// A fast device with little memory beside a slow one with much.
TEST(PartsThatFit, WhatADeviceCannotHoldGoesToTheOthers) {
  const std::uint64_t little = device_bytes(context(), 2000, {});
  EXPECT_EQ(sizes({3, 1}, {{"fast", little, kPlenty}, {"slow", kPlenty, kPlenty}}), (std::vector{2'000u, 18'000u}));
}

TEST(PartsThatFit, WhereAllOfThemHoldTooLittleItIsSaid) {
  const std::uint64_t little = device_bytes(context(), 2000, {});
  try {
    sizes({3, 1}, {{"fast", little, kPlenty}, {"slow", little, kPlenty}});
    FAIL() << "20,000 shapes had room for 4,000";
  } catch (const EnvironmentError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("20000 shapes of the library do not fit into their memory; there is room for 2000 on \"fast\""),
              text.npos)
        << text;
    EXPECT_NE(text.find("2000 on \"slow\""), text.npos) << text;
    EXPECT_NE(text.find("give the job more ranks, nodes or devices"), text.npos) << text;
  }
}

TEST(RoomsOf, DevicesThatAreTheHostShareItsMemory) {
  const cl::Device cpu = opencl_devices().front();
  if (!(cpu.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU)) GTEST_SKIP() << "the first device is no CPU";
  const std::vector<DeviceRoom> alone = rooms_of({cpu}, 1, 1);
  const std::vector<DeviceRoom> two = rooms_of({cpu, cpu}, 1, 3);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_LT(alone[0].memory_bytes, cpu.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>());
  EXPECT_NEAR(double(two[1].memory_bytes), double(alone[0].memory_bytes) / 6, 2);
  EXPECT_EQ(two[1].buffer_bytes, cpu.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>());
}

}  // namespace test_device_room
}  // namespace tessera::worker
