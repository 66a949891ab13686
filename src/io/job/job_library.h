// The library that a job names.
#pragma once

#include "io/job/job_file.h"
#include "io/library/library_file.h"

namespace tessera::io {

/// Throws InputError that names the job, the key, the file, what is wrong with it and what is allowed.
LibraryFile open_library_of(const Job& job);

}  // namespace tessera::io
