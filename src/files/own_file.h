// Files that the program opens repeatedly in a folder that others may write to: run.log, locks.
#pragma once

#include <string>

#include "files/file_descriptor.h"

namespace tessera {

/// Opens `path` with the flags of open(2) (O_RDWR, O_WRONLY, O_APPEND); creates the file where there is none. Does not
/// follow links and does not block. Refuses a file with a second name (hard link), which may be a file of the user
/// elsewhere. A file that has just lost its only name is accepted. Throws EnvironmentError that says what was found.
FileDescriptor open_own_file(const std::string& path, int flags);

}  // namespace tessera
