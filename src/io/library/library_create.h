// The beginning of a library file: the file itself, its attributes and groups.
#pragma once

#include <string>

#include "core/pad/pad.h"
#include "io/library/hdf5_handles.h"

namespace tessera::io {

/// Creates temporary_path(path), for the library that is to become `path`. Throws EnvironmentError where that cannot
/// be, Hdf5Error where HDF5 fails.
Hdf5Handle create_library_file(const std::string& path);

/// Writes format, version and PAD parameters, and makes the groups; those of the smoothing levels get their parameters.
/// Throws Hdf5Error.
void write_library_header(hid_t file, const PadParameters& pad);

}  // namespace tessera::io
