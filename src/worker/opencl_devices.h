// The OpenCL devices of this machine, and which of them a job uses (job key devices.use).
#pragma once

#include <CL/opencl.hpp>
#include <string>
#include <vector>

namespace tessera::worker {

/// All devices, platform by platform as `clinfo -l` lists them. Throws EnvironmentError where there are none.
std::vector<cl::Device> opencl_devices();

/// `use`: "all", "cpu", "gpu" or indices into opencl_devices() like "0,2". Throws EnvironmentError where the machine
/// has no device of that kind, InputError for anything else that does not fit; both say which devices there are.
std::vector<cl::Device> chosen_devices(const std::string& use);

}  // namespace tessera::worker
