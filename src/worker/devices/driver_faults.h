// Common reasons why a device's driver does not work, in words: containers often lack the file that names its OpenCL
// library, the library itself, or the driver's compiler.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tessera::worker {

/// Faults in the OpenCL loader's list of drivers (OCL_ICD_VENDORS, else /etc/OpenCL/vendors), one sentence each. A fault
/// is: a listed library that cannot be loaded; a well-known driver's library that could be loaded but is not listed; a card
/// in the machine without its maker's OpenCL library. `devices`: the folder of the system's devices.
std::vector<std::string> driver_list_faults(const std::filesystem::path& devices = "/dev");

/// Says why a device did not compile the kernels. `log`: the compiler's log. It is empty where NVIDIA's compiler is
/// missing; the text then says what may help. `code`: OpenCL's error code.
std::string compiler_fault(const std::string& log, int code);

}  // namespace tessera::worker
