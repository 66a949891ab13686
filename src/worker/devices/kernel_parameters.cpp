#include "worker/devices/kernel_parameters.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace tessera::worker {
namespace {

constexpr std::array<std::string_view, 3> kQualifiers = {"constant", "global", "const"};

/// Reads one declaration: "global const float* lengths" gives {"float*", "lengths"}.
KernelParameter parameter_of(const std::string& declaration) {
  KernelParameter parameter;
  std::istringstream words(declaration);
  for (std::string word; words >> word;) {
    if (std::find(kQualifiers.begin(), kQualifiers.end(), word) != kQualifiers.end()) continue;
    parameter.type += parameter.name;
    parameter.name = word;
  }
  return parameter;
}

}  // namespace

std::vector<KernelParameter> kernel_parameters(const std::string& source, const std::string& kernel) {
  const std::string head = "void " + kernel + "(";
  const std::size_t head_at = source.find(head);
  if (head_at == std::string::npos) throw std::logic_error("no kernel " + kernel + " in its program's source");
  const std::size_t begin = head_at + head.size();
  std::istringstream declarations(source.substr(begin, source.find(')', begin) - begin));
  std::vector<KernelParameter> parameters;
  for (std::string declaration; std::getline(declarations, declaration, ',');) {
    parameters.push_back(parameter_of(declaration));
  }
  return parameters;
}

}  // namespace tessera::worker
