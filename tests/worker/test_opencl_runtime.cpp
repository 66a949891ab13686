// Work that is too large for one launch is divided, and every work item runs once.
// Arguments must have the names and types of the kernel's parameters.
#include "worker/devices/device_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <ostream>
#include <string>

#include "core/settings/tuning.h"
#include "records.h"
#include "worker/devices/kernel_options.h"
#include "worker/devices/opencl_devices.h"

namespace tessera::worker {

void PrintTo(const KernelParameter& parameter, std::ostream* out) { *out << parameter.type << " " << parameter.name; }

namespace test_opencl_runtime {

constexpr const char* kCountVisits =
    "kernel void count_visits(uint width, global uint* visits) {\n"
    "  const size_t x = get_global_id(0);\n"
    "  if (x < width) atomic_inc(visits + get_global_id(1) * width + x);\n"
    "}\n";

/// The number of launches. Every work item must have run once.
int launches_for(const WorkSize& size) {
  int launches = 0;
  const DeviceSession session(opencl_devices().front(), kCountVisits, "-cl-std=CL1.2", [&] { ++launches; });
  DeviceBuffer<std::uint32_t> visits(session);
  visits.clear(size.x * size.y);
  DeviceKernel(session, "count_visits").launch(size, {{"width", std::uint32_t(size.x)}, {"visits", visits}});
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
  EXPECT_EQ(launches_for({60, 3 * kMostWorkItems / 64, 16}), 3);  // 64 columns, in groups of 16
  EXPECT_EQ(launches_for({60, 3 * kMostWorkItems / 64 + 1, 16}), 4);
}

TEST(Launch, OfLongRowsIsDividedWithinThem) {
  EXPECT_EQ(launches_for({kMostWorkItems + 1, 2, 16}), 4);
  EXPECT_EQ(launches_for({2 * kMostWorkItems + 5, 1, 24}), 3);  // the limit is not a multiple of the group
}

/// Faulty kernels for checked_kernels_test.sh alone. They show that its tools find the faults.
class Faulty : public testing::Test {
 protected:
  static constexpr std::size_t kPlaces = 1024;  // 4 KB: PoCL rounds buffers up to a multiple of 128 bytes

  void SetUp() override {
    if (!std::getenv("TESSERA_TEST_FAULTY")) GTEST_SKIP() << "runs where faults are looked for";
  }

  static void run(const std::string& body, std::size_t items) {
    const std::string source = "kernel void faulty(uint n, global uint* place) {\n" + body + "\n}\n";
    const DeviceSession session(opencl_devices().front(), source, "-cl-std=CL1.2 -cl-opt-disable");
    DeviceBuffer<std::uint32_t> place(session);
    place.reserve(kPlaces);
    DeviceKernel(session, "faulty").launch({items, 1, 1}, {{"n", std::uint32_t(kPlaces)}, {"place", place}});
    place.read(1);
  }
};

/// Reads the first place beyond the buffer. A place farther away may belong to another live block, which would hide the fault.
TEST_F(Faulty, ReadsBeyondItsBuffer) { run("place[0] = place[n];", 1); }

TEST_F(Faulty, DecidesByWhatNobodyWrote) { run("if (place[7] > 3) place[0] = 1;", 1); }

TEST_F(Faulty, TwoItemsWriteTheSamePlace) { run("for (uint i = 0; i < 100000; ++i) place[0] += 1;", 64); }

/// Checks that the environments of the test's variants have an effect.
TEST(Launch, KnowsTheGroupsThatTheDeviceAllows) {
  const char* const most = std::getenv("POCL_MAX_WORK_GROUP_SIZE");
  if (!most) GTEST_SKIP() << "runs where groups are limited";
  EXPECT_EQ(opencl_devices().front().getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>(), std::size_t(std::atoi(most)));
}

/// If the device allows only groups of 8, the kernel gets none (tests/worker/CMakeLists.txt).
TEST(Launch, AKernelThatNeedsGroupsGetsThemAndNoOthers) {
  const cl::Device device = opencl_devices().front();
  const DeviceSession session(device,
                              "kernel __attribute__((reqd_work_group_size(16, 1, 1))) void sizes(global uint* size) {\n"
                              "  size[get_global_id(0)] = get_local_size(0);\n"
                              "}\n",
                              "-cl-std=CL1.2");
  DeviceKernel kernel(session, "sizes");
  DeviceBuffer<std::uint32_t> size(session);
  size.clear(48);
  EXPECT_THROW(kernel.launch({48, 1, 8}, {{"size", size}}), std::logic_error);
  if (device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>() < 16) {
    EXPECT_THROW(kernel.launch({48, 1, 16}, {{"size", size}}), EnvironmentError);
  } else {
    kernel.launch({48, 1, 16}, {{"size", size}});
    EXPECT_EQ(size.read(48), std::vector<std::uint32_t>(48, 16));
  }
}

TEST(Launch, OfManyRowsKeepsWithinAGrid) {
  EXPECT_EQ(launches_for({1, kMostRows, 1}), 1);
  EXPECT_EQ(launches_for({1, kMostRows + 1, 1}), 2);
}

/// A kernel with parameters of several types, and arguments for them.
class Arguments : public testing::Test {
 protected:
  using Launch = std::function<void(DeviceKernel& kernel)>;

  /// The message of the std::logic_error that the launch throws; empty if it throws none.
  std::string refusal(const Launch& launch) {
    DeviceKernel kernel(session_, "named");
    try {
      launch(kernel);
    } catch (const std::logic_error& error) {
      return error.what();
    }
    return "";
  }

  static constexpr const char* kNamed =
      "typedef struct PairRecord { uint sample, source, distance; } PairRecord;\n"
      "kernel void named(constant PairRecord* pairs, uint count, global const float* lengths, uint capacity,\n"
      "                  global const uchar* rows) {}\n";

  const DeviceSession session_{opencl_devices().front(), kNamed, "-cl-std=CL1.2"};
  const DeviceBuffer<PairRecord> pairs_{session_, {{}}};
  const DeviceBuffer<float> lengths_{session_, {1}};
  const DeviceBuffer<std::uint8_t> rows_{session_, {1}};
};

TEST_F(Arguments, OfTheKernelsNamesAndTypesAreTaken) {
  EXPECT_EQ(
      refusal([&](DeviceKernel& kernel) {
        kernel.launch({1}, {{"pairs", pairs_}, {"count", 1}, {"lengths", lengths_}, {"capacity", 1}, {"rows", rows_}});
        session_.wait_for_launches();  // a driver must not end while a kernel runs
      }),
      "");
}

TEST_F(Arguments, OfAnotherNameAreRefused) {
  EXPECT_EQ(
      refusal([&](DeviceKernel& kernel) {
        kernel.launch({1}, {{"pairs", pairs_}, {"count", 1}, {"widths", lengths_}, {"capacity", 1}, {"rows", rows_}});
      }),
      "named gets \"float* widths\" where it has \"float* lengths\"");
}

TEST_F(Arguments, InAnotherOrderAreRefused) {
  EXPECT_EQ(
      refusal([&](DeviceKernel& kernel) {
        kernel.launch({1}, {{"pairs", pairs_}, {"capacity", 1}, {"lengths", lengths_}, {"count", 1}, {"rows", rows_}});
      }),
      "named gets \"uint capacity\" where it has \"uint count\"");
}

TEST_F(Arguments, OfAnotherTypeAreRefused) {
  EXPECT_EQ(refusal([&](DeviceKernel& kernel) {
              kernel.launch(
                  {1},
                  {{"pairs", pairs_}, {"count", lengths_}, {"lengths", lengths_}, {"capacity", 1}, {"rows", rows_}});
            }),
            "named gets \"float* count\" where it has \"uint count\"");
  EXPECT_EQ(
      refusal([&](DeviceKernel& kernel) {
        kernel.launch({1}, {{"pairs", rows_}, {"count", 1}, {"lengths", lengths_}, {"capacity", 1}, {"rows", rows_}});
      }),
      "named gets \"uchar* pairs\" where it has \"PairRecord* pairs\"");
}

TEST_F(Arguments, OfAnotherNumberAreRefused) {
  EXPECT_EQ(refusal([&](DeviceKernel& kernel) {
              kernel.launch({1}, {{"pairs", pairs_}, {"count", 1}});
            }),
            "named gets 2 arguments and has 5 parameters");
}

/// The parameters of a kernel as the driver describes them.
std::vector<KernelParameter> told_parameters(const cl::Kernel& kernel) {
  const auto text = [](std::string told) { return told.substr(0, told.find('\0')); };
  std::vector<KernelParameter> parameters;
  for (cl_uint index = 0; index < kernel.getInfo<CL_KERNEL_NUM_ARGS>(); ++index) {
    parameters.push_back(
        {text(kernel.getArgInfo<CL_KERNEL_ARG_TYPE_NAME>(index)), text(kernel.getArgInfo<CL_KERNEL_ARG_NAME>(index))});
  }
  return parameters;
}

/// Other drivers may write types differently.
TEST(KernelParameters, AreThoseThatPoclTellsOfEachKernel) {
  const cl::Device device = opencl_devices().front();
  if (describe(device).platform != "Portable Computing Language") GTEST_SKIP() << "another driver";
  const std::string options = kernel_options(kMaxPadLevels, DockingLanes::vectors) + " -cl-kernel-arg-info";
  const DeviceSession session(device, kernel_source, options);
  std::vector<cl::Kernel> kernels;
  cl::Program(session.program()).createKernels(&kernels);
  EXPECT_GE(kernels.size(), 7u);
  for (const cl::Kernel& kernel : kernels) {
    const std::string name = kernel.getInfo<CL_KERNEL_FUNCTION_NAME>();
    EXPECT_EQ(kernel_parameters(kernel_source, name), told_parameters(kernel)) << name;
  }
}

TEST(KernelParameters, HaveNoQualifiers) {
  const std::string source =
      "void other(int a) {}\n"
      "kernel void one(global const PairRecord* pairs,\n                uint count) {}\n"
      "kernel void none() {}\n";
  EXPECT_EQ(kernel_parameters(source, "one"),
            (std::vector<KernelParameter>{{"PairRecord*", "pairs"}, {"uint", "count"}}));
  EXPECT_TRUE(kernel_parameters(source, "none").empty());
  EXPECT_THROW(kernel_parameters(source, "two"), std::logic_error);
}

TEST(KernelTypeNames, AreThoseOfOpenCL) {
  EXPECT_EQ(kernel_type_name(typeid(std::uint16_t)), "ushort");
  EXPECT_EQ(kernel_type_name(typeid(SampleRecord)), "SampleRecord");
  EXPECT_THROW(kernel_type_name(typeid(long double)), std::logic_error);
}

}  // namespace test_opencl_runtime
}  // namespace tessera::worker
