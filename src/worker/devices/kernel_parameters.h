// The parameters of a kernel, read from its source. Drivers tell them only of programs that are built with
// -cl-kernel-arg-info, and each writes types in its own way.
#pragma once

#include <string>
#include <vector>

namespace tessera::worker {

struct KernelParameter {
  std::string type;  // without address space and qualifiers: "uint", "PairRecord*"
  std::string name;

  friend bool operator==(const KernelParameter&, const KernelParameter&) = default;
};

/// In the order of the source, which is OpenCL C with one function of the name `kernel` and no comments or macros among its
/// parameters. Throws std::logic_error where there is no such function.
std::vector<KernelParameter> kernel_parameters(const std::string& source, const std::string& kernel);

}  // namespace tessera::worker
