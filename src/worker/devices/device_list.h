// The text that `tessera devices` prints.
#pragma once

#include <string>

namespace tessera::worker {

/// This machine's OpenCL platforms and devices, with the numbers for devices.use, and what a job without a section
/// [devices] uses. Where there are no devices, throws EnvironmentError that says what may help.
std::string device_list();

}  // namespace tessera::worker
