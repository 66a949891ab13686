// Opens an untrusted library file: checks that it is a library of this program's version.
#pragma once

#include <string>

#include "core/pad/pad.h"
#include "library/hdf5/hdf5_handles.h"

namespace tessera {

/// Says what to do about a library of another version; messages end with it.
inline constexpr char kBuildAgain[] = "; build it again with tessera library build";

/// Opens the file for reading. Throws InputError where there is no such file or it is not HDF5, Hdf5Error where it is
/// damaged.
Hdf5Handle open_library(const std::string& path);

/// Checks format and version and returns the PAD parameters. Throws Hdf5Error.
PadParameters read_library_header(hid_t file);

}  // namespace tessera
