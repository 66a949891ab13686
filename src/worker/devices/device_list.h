// What `tessera devices` prints.
#pragma once

#include <string>

namespace tessera::worker {

/// This machine's OpenCL platforms and devices, with the numbers that devices.use takes, and what a job uses that has
/// no section [devices]. Throws EnvironmentError that says what may help where there are no devices.
std::string device_list();

}  // namespace tessera::worker
