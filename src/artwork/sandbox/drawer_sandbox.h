// Limits what a drawer (drawers.h) may do.
#pragma once

#include <cstddef>

#include "artwork/protocol/drawer_layers.h"

namespace tessera {

/// Limits this process: `bytes` of address space beyond its present size, no core dumps, no bytes written to files, few
/// descriptors. It dies with its parent's thread, and no program that it starts gets more rights. The parent sets the
/// limit on CPU time for each drawing.
void limit_process(std::size_t bytes);

/// Allows from now on only the system calls that decoding needs (others fail with ENOSYS): reading files, fonts
/// included, memory, threads. No sockets, no new process or program, no signal to others, no file opened for writing,
/// made, renamed or removed. Returns `missing` where the kernel has no seccomp.
LayerState forbid_system_calls();

}  // namespace tessera
