#include "worker/devices/opencl_runtime.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "core/base/process_limits.h"
#include "worker/devices/driver_faults.h"

namespace tessera::worker {
namespace {

/// What a user can do something about; the numbers are those of CL/cl.h.
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

/// What the kernel may have on this device: it may need more registers, or the device allows less.
std::size_t allowed_group(const DeviceSession& session, const cl::Kernel& kernel, std::size_t wished) {
  const std::size_t most =
      std::max<std::size_t>(1, kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(session.device()));
  const std::size_t needed = kernel.getWorkGroupInfo<CL_KERNEL_COMPILE_WORK_GROUP_SIZE>(session.device())[0];
  if (needed == 0) return std::min(wished, most);
  const std::string name = kernel.getInfo<CL_KERNEL_FUNCTION_NAME>();
  if (needed != wished) throw std::logic_error(name + ": launched in groups of another size than it needs");
  if (needed > most) {
    throw EnvironmentError("OpenCL device \"" + session.name() + "\": " + name + " needs work groups of " +
                           std::to_string(needed) + ", and the device allows " + std::to_string(most));
  }
  return needed;
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

cl::Kernel DeviceSession::kernel(const char* name) const {
  return checked(name_, [&] { return cl::Kernel(program_, name); });
}

void DeviceSession::flush() const {
  checked(name_, [&] { queue_.flush(); });
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
    if (status < CL_COMPLETE) return true;  // it failed: wait_for_launches says how
    launches_.pop_front();
    if (between_launches_) between_launches_();
  }
  return true;
}

void set_argument(cl::Kernel& kernel, cl_uint index, std::uint32_t value) { kernel.setArg(index, value); }

void enqueue(const DeviceSession& session, cl::Kernel& kernel, const WorkSize& size, cl_uint arguments) {
  if (kernel.getInfo<CL_KERNEL_NUM_ARGS>() != arguments) {
    throw std::logic_error(kernel.getInfo<CL_KERNEL_FUNCTION_NAME>() + ": wrong number of arguments");
  }
  const std::size_t group = allowed_group(session, kernel, size.group);
  const std::size_t x = (size.x + group - 1) / group * group;
  if (std::max(x, size.y) > std::numeric_limits<std::uint32_t>::max()) {
    throw std::logic_error(kernel.getInfo<CL_KERNEL_FUNCTION_NAME>() + ": more work than 32-bit indices count");
  }
  const std::size_t columns = std::min(x, kMostWorkItems / group * group);
  const std::size_t rows = std::clamp<std::size_t>(kMostWorkItems / columns, 1, kMostRows);
  for (std::size_t first_row = 0; first_row < size.y; first_row += rows) {
    for (std::size_t first_column = 0; first_column < x; first_column += columns) {
      const cl::NDRange part(std::min(columns, x - first_column), std::min(rows, size.y - first_row));
      cl::Event launched;
      session.queue().enqueueNDRangeKernel(kernel, cl::NDRange(first_column, first_row), part, cl::NDRange(group, 1),
                                           nullptr, &launched);
      session.add_launch(std::move(launched));
    }
  }
}

}  // namespace tessera::worker
