// What often keeps a device's driver from working, in words: containers lack the file that names its OpenCL library,
// the library itself, or the driver's compiler.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tessera::worker {

/// One sentence for each file of the OpenCL loader's list (OCL_ICD_VENDORS, else /etc/OpenCL/vendors) whose library
/// cannot be loaded, for each well-known driver's library that can be loaded but that no such file names, and for each
/// maker of cards that are in the machine but whose OpenCL library is not. `devices`: the folder of the system's devices.
std::vector<std::string> driver_list_faults(const std::filesystem::path& devices = "/dev");

/// Why a device did not compile the kernels. `log`: the compiler's; where it is empty, as it is where NVIDIA's compiler
/// is missing, the text says what may help. `code`: OpenCL's.
std::string compiler_fault(const std::string& log, int code);

}  // namespace tessera::worker
