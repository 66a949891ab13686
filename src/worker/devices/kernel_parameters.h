// The parameters of a kernel, read from its source. Drivers report them only for programs that are built with
// -cl-kernel-arg-info, and each driver writes types in its own way.
#pragma once

#include <string>
#include <vector>

namespace tessera::worker {

struct KernelParameter {
  std::string type;  // without address space and qualifiers: "uint", "PairRecord*"
  std::string name;

  friend bool operator==(const KernelParameter&, const KernelParameter&) = default;
};

/// The parameters in the order of the source. The source is OpenCL C with one function of the name `kernel`, without
/// comments or macros among its parameters. Throws std::logic_error where there is no such function.
std::vector<KernelParameter> kernel_parameters(const std::string& source, const std::string& kernel);

}  // namespace tessera::worker
