// Remembers the files that this process has read: an input file is never removed because it has the temporary name of
// an output.
#pragma once

#include <sys/stat.h>

namespace tessera {

/// Notes a file as read. `status`: of the open file, from fstat(2). Several threads may call it and was_read().
void note_as_read(const struct stat& status);

/// Whether this file was noted as read and has not changed since.
bool was_read(const struct stat& status);

}  // namespace tessera
