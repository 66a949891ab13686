// The options with which kernels are compiled. All that may change from job to job is in MatchRecord instead, so that a
// device compiles the kernels only once.
#pragma once

#include <cstdint>
#include <string>

namespace tessera::worker {

/// All files of kernels/, joined by cmake/EmbedKernels.cmake.
extern const char* const kernel_source;

/// The way in which the 16 lanes of a docking (kernels/lanes.cl) are computed: by one work item in vectors, which suits CPUs, or by 16
/// work items of a group, which suits GPUs. Both give the same bits.
enum class DockingLanes { vectors, items };

/// The number of work items for one docking.
std::uint32_t items_of_docking(DockingLanes lanes);

/// The number of random draws for one work item (kernels/docking.cl). A CPU loads the data of several draws before it uses
/// any of them.
std::uint32_t draws_per_item(DockingLanes lanes);

/// The compiler options: core's tunables under the same names, and the switches for arithmetic as IEEE 754 says.
std::string kernel_options(int pad_levels, DockingLanes lanes);

}  // namespace tessera::worker
