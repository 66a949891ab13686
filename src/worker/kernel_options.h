// How the kernels are compiled. Everything that may change from job to job stands in MatchRecord instead, so that a
// device compiles once and for all.
#pragma once

#include <cstdint>
#include <string>

namespace tessera::worker {

/// All files of kernels/, joined (made by cmake/EmbedKernels.cmake).
extern const char* const kernel_source;

/// Random draws of a work item (kernels/docking.cl).
inline constexpr std::uint32_t kDrawsPerItem = 8;

/// The tunables of core under the same names, and what makes devices compute as IEEE 754 says.
std::string kernel_options(int pad_levels);

}  // namespace tessera::worker
