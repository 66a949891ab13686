// A kernel on a device. Its arguments are named and checked against its parameters; large work is launched in parts.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <typeinfo>
#include <vector>

#include "worker/devices/kernel_parameters.h"
#include "worker/devices/opencl_runtime.h"

namespace tessera::worker {

/// The most work items in one launch; more work is divided, so that a stop is noticed between two launches. It takes a few
/// hundred milliseconds on two CPU cores and fills a large GPU. Kernels see global ids only.
inline constexpr std::size_t kMostWorkItems = std::size_t(1) << 20;
/// The most groups in the second dimension that GPUs allow (CUDA's limit of a grid).
inline constexpr std::size_t kMostRows = 65535;

/// The number of work items. The first dimension comes in groups of `group` items (at most kMostWorkItems), or smaller
/// groups where the device allows no more for a kernel. It is rounded up to whole groups; kernels check it. For a kernel
/// that needs groups of a certain size (reqd_work_group_size), `group` must be that size.
struct WorkSize {
  std::size_t x = 0;
  std::size_t y = 1;
  std::size_t group = 1;
};

/// The name of a C++ type in OpenCL C: "uchar" for std::uint8_t, "PairRecord" for the struct of kernels/records.h. Throws
/// std::logic_error for a number type that no kernel takes.
std::string kernel_type_name(const std::type_info& type);

/// The argument for one parameter of a kernel. The name is that of the parameter in the kernel's source.
class KernelArgument {
 public:
  KernelArgument(const char* name, std::uint32_t value) : name_(name), type_(type_of_number()), value_(value) {}
  /// The buffer must stay until the launch is posted.
  template <class T>
  KernelArgument(const char* name, const DeviceBuffer<T>& buffer)
      : name_(name),
        type_(type_of_buffer<T>()),
        buffer_(&buffer.get()) {}

  /// The parameter that this argument is for.
  KernelParameter parameter() const { return {type_, name_}; }
  void set(cl::Kernel& kernel, cl_uint index) const;

 private:
  static const std::string& type_of_number();
  template <class T>
  static const std::string& type_of_buffer() {
    static const std::string type = kernel_type_name(typeid(T)) + "*";
    return type;
  }

  const char* name_;
  const std::string& type_;
  std::uint32_t value_ = 0;
  const cl::Buffer* buffer_ = nullptr;  // null for a number
};

class DeviceKernel {
 public:
  /// Throws EnvironmentError where the session's program has no such kernel. The session must outlive the kernel.
  DeviceKernel(const DeviceSession& session, const char* name);

  /// Posts the kernel with one argument for each of its parameters, in their order. Does nothing where there is no work.
  /// Throws std::logic_error where names or types differ from those of the parameters. Throws EnvironmentError where the
  /// device does not allow the groups that the kernel needs.
  void launch(const WorkSize& size, std::initializer_list<KernelArgument> arguments);

 private:
  void check(std::initializer_list<KernelArgument> arguments) const;
  std::size_t allowed_group(std::size_t wished) const;
  void enqueue(const WorkSize& size);

  const DeviceSession* session_;
  std::string name_;
  cl::Kernel kernel_;
  std::vector<KernelParameter> parameters_;
};

}  // namespace tessera::worker
