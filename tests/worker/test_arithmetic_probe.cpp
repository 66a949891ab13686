// Hard operands, whose results are near the middle between two floats: they are as near as intended.
// A device that rounds differently is reported and refused.
#include "worker/devices/arithmetic_probe.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <stdexcept>

#include "worker/devices/opencl_devices.h"

namespace tessera::worker {
namespace test_arithmetic_probe {

float number(std::uint32_t bits) { return std::bit_cast<float>(bits); }

std::vector<std::uint32_t> expected_of(const std::vector<ArithmeticProbe>& probes) {
  std::vector<std::uint32_t> results;
  for (const ArithmeticProbe& probe : probes) results.push_back(probe.expected);
  return results;
}

/// The distance of the exact result from the middle between two floats, in units of the distance between floats.
double from_the_middle(double exact, float rounded) {
  const double distance = std::nextafter(rounded, INFINITY) - double(rounded);
  return std::abs(std::abs(exact - double(rounded)) / distance - 0.5);
}

/// A device whose compiler replaces `part` of the kernels' source by `instead`.
DeviceSession careless_session(const std::string& part, const std::string& instead) {
  std::string source = kernel_source;
  const std::size_t at = source.find(part);
  if (at == std::string::npos) throw std::logic_error(part + " does not stand in the kernels");
  source.replace(at, part.size(), instead);
  return DeviceSession(opencl_devices().front(), source, kernel_options(5, DockingLanes::items));
}

std::string wrong_on(const DeviceSession& session) {
  const std::vector<ArithmeticProbe> probes = arithmetic_probes();
  return wrong_arithmetic(probes, probe_results(session, probes));
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(ArithmeticProbes, QuotientsAndRootsAreHard) {
  int hard_quotients = 0;
  int hard_roots = 0;
  for (const ArithmeticProbe& probe : arithmetic_probes()) {
    const double a = number(probe.record.a);
    const double b = number(probe.record.b);
    if (probe.record.operation == kProbeQuotient && from_the_middle(a / b, number(probe.expected)) < 0x1p-20) {
      ++hard_quotients;
    }
    if (probe.record.operation == kProbeRoot && from_the_middle(std::sqrt(a), number(probe.expected)) < 0x1p-14) {
      ++hard_roots;
    }
  }
  EXPECT_EQ(hard_quotients, 256);
  EXPECT_GE(hard_roots, 256);
}

/// Half of the hard cases are rounded up and half down, so a division that errs in one direction is noticed.
TEST(ArithmeticProbes, LieOnBothSidesOfTheMiddle) {
  int up = 0;
  int down = 0;
  for (const ArithmeticProbe& probe : arithmetic_probes()) {
    if (probe.record.operation != kProbeQuotient || probe.record.a < 0x00800000) continue;
    const double exact = double(number(probe.record.a)) / number(probe.record.b);
    (double(number(probe.expected)) > exact ? up : down) += 1;
  }
  EXPECT_GE(up, 100);
  EXPECT_GE(down, 100);
}

TEST(ArithmeticProbes, AFusedMultiplyAddWouldGiveOtherBits) {
  for (const ArithmeticProbe& probe : arithmetic_probes()) {
    const float c = number(probe.record.c);
    const bool sum = probe.record.operation == kProbeProductAndSum;
    if (!sum && probe.record.operation != kProbeProductAndDifference) continue;
    const float fused = std::fma(number(probe.record.a), number(probe.record.b), sum ? c : -c);
    EXPECT_NE(std::bit_cast<std::uint32_t>(fused), probe.expected);
  }
}

TEST(WrongArithmetic, IsNothingWhereAllBitsAreRight) {
  const std::vector<ArithmeticProbe> probes = arithmetic_probes();
  EXPECT_EQ(wrong_arithmetic(probes, expected_of(probes)), "");
}

TEST(WrongArithmetic, EachOperationIsNamedByItself) {
  const std::vector<ArithmeticProbe> probes = arithmetic_probes();
  for (std::size_t i = 0; i < probes.size(); i += 7) {
    std::vector<std::uint32_t> results = expected_of(probes);
    results[i] ^= 1;
    const std::string wrong = wrong_arithmetic(probes, results);
    EXPECT_TRUE(has(wrong, "(1 of ")) << wrong;
    EXPECT_FALSE(has(wrong, "), ")) << "only one kind: " << wrong;
  }
}

TEST(CheckArithmetic, ThisMachinesDevicesComputeRight) {
  for (const cl::Device& device : opencl_devices()) {
    for (const DockingLanes lanes : {DockingLanes::vectors, DockingLanes::items}) {
      const DeviceSession session(device, kernel_source, kernel_options(5, lanes));
      EXPECT_NO_THROW(check_arithmetic(session));
    }
  }
}

/// Each case replaces an operation of the kernel by what a compiler for speed could make of it.
TEST(CheckArithmetic, EachCarelessnessIsSeen) {
  const auto seen = [](const char* part, const char* instead) { return wrong_on(careless_session(part, instead)); };
  EXPECT_TRUE(has(seen("as_uint(a * b + c)", "as_uint(fma(a, b, c))"), "(fused multiply-add) ("));
  EXPECT_TRUE(has(seen("as_uint(a * b - c)", "as_uint(fma(a, b, -c))"), "(fused multiply-add) ("));
  EXPECT_TRUE(has(seen("as_uint(a / b)", "as_uint(a * (1 / b))"), "divisions ("));
  EXPECT_TRUE(has(seen("as_uint(sqrt(a))", "as_uint(a * (1 / sqrt(a)))"), "square roots ("));
  EXPECT_TRUE(has(seen("as_uint(a + b + c)", "as_uint(a + (b + c))"), "sums ("));
  EXPECT_TRUE(has(seen("as_uint((float)probe.a)", "as_uint(convert_float_rtz(probe.a))"), "conversions of numbers ("));
  EXPECT_TRUE(has(seen("(uint)(int)a", "(uint)convert_int_rtn(a)"), "conversions of numbers ("));
  EXPECT_TRUE(has(seen("as_uint(a * b)", "fabs(a * b) < 0x1p-126f ? as_uint(a * b) & 0x80000000u : as_uint(a * b)"),
                  "products that are denormal numbers ("));
}

TEST(CheckArithmetic, WhatComputesOtherwiseIsRefusedWithItsName) {
  const DeviceSession session = careless_session("as_uint(a * b + c)", "as_uint(fma(a, b, c))");
  try {
    check_arithmetic(session);
    ADD_FAILURE() << "it was accepted";
  } catch (const EnvironmentError& error) {
    EXPECT_TRUE(has(error.what(), session.name())) << error.what();
    EXPECT_TRUE(has(error.what(), "fused multiply-add")) << error.what();
    EXPECT_TRUE(has(error.what(), "devices.use")) << error.what();
  }
}

}  // namespace test_arithmetic_probe
}  // namespace tessera::worker
