// How many cores this process may use.
#pragma once

namespace tessera {

/// The cores that the allocation leaves to this process (its affinity: taskset, Slurm, containers' CPU sets), 1 at
/// least; fewer than the machine has where it shares it.
int available_cores();

}  // namespace tessera
