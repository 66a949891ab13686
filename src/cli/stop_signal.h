// Ctrl-C, the SIGTERM that mpirun and Slurm send, and SIGUSR2, which Slurm sends on demand some time before the end:
// ends the collage with a checkpoint and what is placed so far.
#pragma once

namespace tessera::cli {

/// From now on SIGINT, SIGTERM and SIGUSR2 only set a flag, however often they come (mpirun sends both).
void install_stop_handlers();

/// A signal came since.
bool stop_signalled();

}  // namespace tessera::cli
