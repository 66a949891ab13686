// Which program this is, for messages, records and for comparing ranks. The values stand in a source that every build
// writes anew (cmake/WriteVersion.cmake); it is a library of its own, tessera_version, so that a commit relinks only
// what links that.
#pragma once

namespace tessera {

/// "0.1.0", the project's version.
const char* program_version();

/// The first 12 digits of the git commit that was built, with "-dirty" where files differed from it; "unknown" where
/// the program was built outside a git repository.
const char* program_commit();

}  // namespace tessera
