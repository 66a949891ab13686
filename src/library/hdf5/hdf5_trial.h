// HDF5 1.10 does not survive every forged file: where the metadata carry valid checksums but make no sense, it may read
// or write where it must not. So a foreign file is taken apart in a child process first.
#pragma once

#include <functional>

namespace tessera {

/// Runs `read` in a child of 20 s of CPU time at most, which shares nothing with this process. What `read` throws does
/// not matter here: it is thrown again when the caller reads. Throws Hdf5Error where the child crashes or takes too
/// long, EnvironmentError where the system gives no child.
void try_in_child(const std::function<void()>& read);

}  // namespace tessera
