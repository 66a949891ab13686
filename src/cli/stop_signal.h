// Ctrl-C, and the SIGTERM that mpirun and Slurm send: ends the collage with what is placed so far.
#pragma once

namespace tessera::cli {

/// From now on SIGINT and SIGTERM only set a flag, however often they come (mpirun sends both).
void install_stop_handlers();

/// A signal came since.
bool stop_signalled();

}  // namespace tessera::cli
