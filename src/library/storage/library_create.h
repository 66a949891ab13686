// Creates a library file with its attributes and groups.
#pragma once

#include <memory>
#include <string>

#include "core/pad/pad.h"
#include "files/atomic_file.h"
#include "library/hdf5/hdf5_handles.h"

namespace tessera {

/// A library that is being written. The members are destroyed from the last to the first, so HDF5 closes the file before it
/// is removed.
struct NewLibraryFile {
  std::unique_ptr<TemporaryFile> disk;
  Hdf5Handle hdf5;
};

/// Throws EnvironmentError where the file cannot be created, Hdf5Error where HDF5 fails.
NewLibraryFile create_library_file(const std::string& path);

/// Writes format, version and PAD parameters, and makes the groups; the groups of smoothing levels get their parameters.
/// Throws Hdf5Error.
void write_library_header(hid_t file, const PadParameters& pad);

}  // namespace tessera
