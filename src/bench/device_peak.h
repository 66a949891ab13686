// What the devices can do at most for the work of PAD distances, measured with kernels that do nothing else.
#pragma once

#include <string>

namespace tessera::bench {

/// A step is what one element of a PAD costs: a subtraction, its magnitude, the larger of it and of what was found so
/// far. In registers only. The figures of several devices are added.
struct DevicePeak {
  double float_steps_per_s = 0;  // elements of 4 bytes
  double byte_steps_per_s = 0;   // elements of 1 byte
  double read_bytes_per_s = 0;   // from memory, of a buffer beyond most caches
};

/// `quick`: a buffer of 16 MB instead of 256 MB, and a tenth of the time.
DevicePeak measure_device_peak(const std::string& devices_use, bool quick);

}  // namespace tessera::bench
