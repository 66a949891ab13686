// What a drawer (drawers.h) may do.
#pragma once

#include <cstddef>

#include "artwork/protocol/drawer_layers.h"

namespace tessera {

/// Limits this process: `bytes` of address space beyond what it has now, no core dumps, no bytes written to files, few
/// descriptors; it dies with its parent's thread, and no program that it starts gets more rights. The parent sets the
/// limit on CPU time for each drawing.
void limit_process(std::size_t bytes);

/// From now on only system calls that decoding needs are answered (ENOSYS otherwise): reading files, fonts among them,
/// memory, threads. No sockets, no new process or program, no signal to others, no file opened for writing, made,
/// renamed or removed. Missing where the kernel has no seccomp.
LayerState forbid_system_calls();

}  // namespace tessera
