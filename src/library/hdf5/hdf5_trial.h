// Reads foreign files in a child process first. HDF5 1.10 does not survive every forged file: where the metadata have valid
// checksums but make no sense, it may read or write where it must not.
#pragma once

#include <functional>

namespace tessera {

/// Runs `read` in a child process with at most 20 s of CPU time, which shares nothing with this process. Exceptions of
/// `read` are ignored here, because the caller reads again and gets them then. Throws Hdf5Error where the child crashes or
/// takes too long, EnvironmentError where no child can be started.
void try_in_child(const std::function<void()>& read);

}  // namespace tessera
