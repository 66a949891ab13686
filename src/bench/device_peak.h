// The most that the devices can do for PAD distances, measured with kernels that do nothing else.
#pragma once

#include <string>

namespace tessera::bench {

/// Steps each second; a step is the work for one element of a PAD: a subtraction, its magnitude, and a maximum. In
/// registers only. The figures of several devices are added.
struct DevicePeak {
  double float_steps_per_s = 0;  // elements of 4 bytes
  double byte_steps_per_s = 0;   // elements of 1 byte
  double read_bytes_per_s = 0;   // from memory, of a buffer larger than most caches
};

/// Measures the devices. `quick`: a buffer of 16 MB instead of 256 MB, and a tenth of the time.
DevicePeak measure_device_peak(const std::string& devices_use, bool quick);

}  // namespace tessera::bench
