// The files that this process has read: what somebody gives as input is not removed because it has the temporary name of
// an output.
#pragma once

#include <sys/stat.h>

namespace tessera {

/// `status`: of an open file, as fstat(2) has it. May be called by several threads at a time, as was_read().
void note_as_read(const struct stat& status);

/// Whether this file was noted, and has not changed since.
bool was_read(const struct stat& status);

}  // namespace tessera
