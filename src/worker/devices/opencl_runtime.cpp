#include "worker/devices/opencl_runtime.h"

#include "core/base/process_limits.h"
#include "worker/devices/driver_faults.h"

namespace tessera::worker {
namespace {

/// The meaning of error codes that a user can do something about; the numbers are those of CL/cl.h.
std::string meaning(cl_int code) {
  switch (code) {
    case CL_DEVICE_NOT_AVAILABLE: return " (the device is not available)";
    case CL_MEM_OBJECT_ALLOCATION_FAILURE:
    case CL_OUT_OF_RESOURCES:
    case CL_OUT_OF_HOST_MEMORY: return " (out of memory: use more ranks or devices)";
    case CL_INVALID_BUFFER_SIZE: return " (more than the device holds in one buffer: use more ranks or devices)";
    default: return "";
  }
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

}  // namespace

EnvironmentError opencl_error(const cl::Error& error, const std::string& device) {
  return EnvironmentError("OpenCL device \"" + device + "\": " + error.what() + " failed with code " +
                          std::to_string(error.err()) + meaning(error.err()));
}

DeviceSession::DeviceSession(const cl::Device& device, const std::string& source, const std::string& build_options,
                             BetweenLaunches between_launches)
    : device_(device),
      name_(device.getInfo<CL_DEVICE_NAME>()),
      between_launches_(std::move(between_launches)) {
  checked(name_, [&] {
    compute_units_ = device_.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    context_ = cl::Context(device_);
    queue_ = cl::CommandQueue(context_, device_);
    program_ = cl::Program(context_, source);
    try {
      program_.build(build_options.c_str());
    } catch (const cl::BuildError& error) {
      const std::string log = program_.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device_);
      throw EnvironmentError("OpenCL device \"" + name_ + "\" cannot compile the kernels: " +
                             one_line(compiler_fault(log, error.err())) + process_limits());
    }
  });
}

void DeviceSession::flush() const {
  checked(name_, [&] { queue_.flush(); });
}

void DeviceSession::finish() const {
  checked(name_, [&] { queue_.finish(); });
}

void DeviceSession::wait_for_launches() const {
  while (!launches_.empty()) {
    checked(name_, [&] { launches_.front().wait(); });
    launches_.pop_front();
    if (between_launches_) between_launches_();
  }
}

bool DeviceSession::launches_are_done() const {
  while (!launches_.empty()) {
    const cl_int status =
        checked(name_, [&] { return launches_.front().getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>(); });
    if (status > CL_COMPLETE) return false;
    if (status < CL_COMPLETE) return true;  // it failed: wait_for_launches() reports it
    launches_.pop_front();
    if (between_launches_) between_launches_();
  }
  return true;
}

}  // namespace tessera::worker
