#include "worker/devices/device_kernel.h"

#include <cxxabi.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <memory>
#include <stdexcept>

namespace tessera::worker {
namespace {

struct NumberName {
  const std::type_info* type;
  const char* name;
};

const std::array kNumberNames = {
    NumberName{&typeid(std::uint8_t), "uchar"},   NumberName{&typeid(std::int16_t), "short"},
    NumberName{&typeid(std::uint16_t), "ushort"}, NumberName{&typeid(std::uint32_t), "uint"},
    NumberName{&typeid(std::uint64_t), "ulong"},  NumberName{&typeid(float), "float"}};

/// A type's name with its namespaces: "tessera::worker::PairRecord".
std::string qualified_name(const std::type_info& type) {
  const std::unique_ptr<char, decltype(&std::free)> name(abi::__cxa_demangle(type.name(), nullptr, nullptr, nullptr),
                                                         &std::free);
  return name ? name.get() : type.name();
}

std::string quoted(const KernelParameter& parameter) { return '"' + parameter.type + " " + parameter.name + '"'; }

}  // namespace

std::string kernel_type_name(const std::type_info& type) {
  for (const NumberName& number : kNumberNames) {
    if (*number.type == type) return number.name;
  }
  const std::string name = qualified_name(type);
  const std::size_t end_of_namespace = name.rfind("::");
  if (end_of_namespace == std::string::npos) throw std::logic_error("no kernel takes numbers of the type " + name);
  return name.substr(end_of_namespace + 2);
}

const std::string& KernelArgument::type_of_number() {
  static const std::string type = kernel_type_name(typeid(std::uint32_t));
  return type;
}

void KernelArgument::set(cl::Kernel& kernel, cl_uint index) const {
  if (buffer_) {
    kernel.setArg(index, *buffer_);
  } else {
    kernel.setArg(index, value_);
  }
}

DeviceKernel::DeviceKernel(const DeviceSession& session, const char* name) : session_(&session), name_(name) {
  checked(session.name(), [&] {
    kernel_ = cl::Kernel(session.program(), name);
    parameters_ = kernel_parameters(session.program().getInfo<CL_PROGRAM_SOURCE>(), name_);
  });
}

void DeviceKernel::check(std::initializer_list<KernelArgument> arguments) const {
  if (arguments.size() != parameters_.size()) {
    throw std::logic_error(name_ + " gets " + std::to_string(arguments.size()) + " arguments and has " +
                           std::to_string(parameters_.size()) + " parameters");
  }
  auto wanted = parameters_.begin();
  for (const KernelArgument& argument : arguments) {
    if (argument.parameter() != *wanted) {
      throw std::logic_error(name_ + " gets " + quoted(argument.parameter()) + " where it has " + quoted(*wanted));
    }
    ++wanted;
  }
}

/// The group size that the device allows for this kernel: the kernel may need many registers, or the device has a limit.
std::size_t DeviceKernel::allowed_group(std::size_t wished) const {
  const cl::Device& device = session_->device();
  const std::size_t most = std::max<std::size_t>(1, kernel_.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device));
  const std::size_t needed = kernel_.getWorkGroupInfo<CL_KERNEL_COMPILE_WORK_GROUP_SIZE>(device)[0];
  if (needed == 0) return std::min(wished, most);
  if (needed != wished) throw std::logic_error(name_ + ": launched in groups of another size than it needs");
  if (needed > most) {
    throw EnvironmentError("OpenCL device \"" + session_->name() + "\": " + name_ + " needs work groups of " +
                           std::to_string(needed) + ", and the device allows " + std::to_string(most));
  }
  return needed;
}

void DeviceKernel::enqueue(const WorkSize& size) {
  const std::size_t group = allowed_group(size.group);
  const std::size_t x = (size.x + group - 1) / group * group;
  if (std::max(x, size.y) > std::numeric_limits<std::uint32_t>::max()) {
    throw std::logic_error(name_ + ": more work than 32-bit indices count");
  }
  const std::size_t columns = std::min(x, kMostWorkItems / group * group);
  const std::size_t rows = std::clamp<std::size_t>(kMostWorkItems / columns, 1, kMostRows);
  for (std::size_t first_row = 0; first_row < size.y; first_row += rows) {
    for (std::size_t first_column = 0; first_column < x; first_column += columns) {
      const cl::NDRange part(std::min(columns, x - first_column), std::min(rows, size.y - first_row));
      cl::Event launched;
      session_->queue().enqueueNDRangeKernel(kernel_, cl::NDRange(first_column, first_row), part, cl::NDRange(group, 1),
                                             nullptr, &launched);
      session_->add_launch(std::move(launched));
    }
  }
}

void DeviceKernel::launch(const WorkSize& size, std::initializer_list<KernelArgument> arguments) {
  if (size.x == 0 || size.y == 0) return;
  check(arguments);
  checked(session_->name(), [&] {
    cl_uint index = 0;
    for (const KernelArgument& argument : arguments) argument.set(kernel_, index++);
    enqueue(size);
  });
}

}  // namespace tessera::worker
