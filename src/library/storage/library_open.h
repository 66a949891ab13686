// The first look at an untrusted library file: is it one, and of this program's version?
#pragma once

#include <string>

#include "core/pad/pad.h"
#include "library/hdf5/hdf5_handles.h"

namespace tessera {

/// What to do about a library of another version; appended to messages.
inline constexpr char kBuildAgain[] = "; build it again with tessera library build";

/// Opens the file for reading. Throws InputError where there is no such file or it is not HDF5, Hdf5Error where it is
/// damaged.
Hdf5Handle open_library(const std::string& path);

/// Checks format and version and gives the PAD parameters. Throws Hdf5Error.
PadParameters read_library_header(hid_t file);

}  // namespace tessera
