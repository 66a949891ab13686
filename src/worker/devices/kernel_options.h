// How the kernels are compiled. Everything that may change from job to job stands in MatchRecord instead, so that a
// device compiles once and for all.
#pragma once

#include <cstdint>
#include <string>

namespace tessera::worker {

/// All files of kernels/, joined (made by cmake/EmbedKernels.cmake).
extern const char* const kernel_source;

/// Who has the 16 lanes of a docking (kernels/lanes.cl): one work item, in vectors, as suits CPUs; or 16 work items of a
/// group have one each, as suits GPUs. Both give the same bits.
enum class DockingLanes { vectors, items };

/// Work items of a docking.
std::uint32_t items_of_docking(DockingLanes lanes);

/// Random draws of a work item (kernels/docking.cl): a CPU asks for what several of them need before it uses any of it.
std::uint32_t draws_per_item(DockingLanes lanes);

/// The tunables of core under the same names, and what makes devices compute as IEEE 754 says.
std::string kernel_options(int pad_levels, DockingLanes lanes);

}  // namespace tessera::worker
