// Whether a device computes floats as IEEE 754 says: found by what it computes, not by what it reports. The same bytes
// on all devices need the same rounding on all devices.
#pragma once

#include <string>
#include <vector>

#include "records.h"
#include "worker/devices/opencl_runtime.h"

namespace tessera::worker {

/// An operation, and the bits that it must give.
struct ArithmeticProbe {
  ProbeRecord record;
  std::uint32_t expected = 0;
};

/// Operands that show a difference. Random ones hardly ever do: a quotient that lies within 2^-20 of a half between
/// two floats is rounded wrongly by a division that is almost right.
std::vector<ArithmeticProbe> arithmetic_probes();

/// What the results show to be computed differently, in words: "divisions (12 of 256)", or several of these; empty where all
/// bits are the expected ones. `results` has as many numbers as `probes`.
std::string wrong_arithmetic(const std::vector<ArithmeticProbe>& probes, const std::vector<std::uint32_t>& results);

/// Runs the probes on the device, by the kernel probe_arithmetic of the session's program. Gives the results' bits.
std::vector<std::uint32_t> probe_results(const DeviceSession& session, const std::vector<ArithmeticProbe>& probes);

/// Throws EnvironmentError that names the device, what it computes differently, and what can be done.
void check_arithmetic(const DeviceSession& session);

}  // namespace tessera::worker
