// The version of this program, for messages, records and comparing ranks. The values are in a source file that every
// build writes again (cmake/WriteVersion.cmake). It is a library of its own, tessera_version, so that a commit relinks
// only the programs that use it.
#pragma once

namespace tessera {

/// "0.1.0", the project's version.
const char* program_version();

/// The first 12 digits of the git commit that was built, with "-dirty" if files differed from it; "unknown" if the
/// program was built outside a git repository.
const char* program_commit();

}  // namespace tessera
