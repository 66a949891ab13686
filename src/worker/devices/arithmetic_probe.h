// Tests whether a device computes floats as IEEE 754 says, by its results and not by what it reports. All devices must
// round in the same way, so that they give the same bytes.
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

/// Operands that show a difference. Random operands hardly ever do: a division that is almost right rounds only those
/// quotients wrongly that lie within 2^-20 of the middle between two floats.
std::vector<ArithmeticProbe> arithmetic_probes();

/// The operations that the device computes differently: "divisions (12 of 256)", or several such parts. Empty where all
/// bits are the expected ones. `results` has as many numbers as `probes`.
std::string wrong_arithmetic(const std::vector<ArithmeticProbe>& probes, const std::vector<std::uint32_t>& results);

/// Runs the probes on the device, with the kernel probe_arithmetic of the session's program. Gives the bits of the results.
std::vector<std::uint32_t> probe_results(const DeviceSession& session, const std::vector<ArithmeticProbe>& probes);

/// Throws EnvironmentError where the device computes differently. The message names the device, the operations and what can
/// be done.
void check_arithmetic(const DeviceSession& session);

}  // namespace tessera::worker
