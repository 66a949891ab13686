// The library that a job names.
#pragma once

#include "io/job/job_file.h"
#include "io/library/library_file.h"

namespace tessera::io {

/// Throws InputError that names the job, the key, the file, what is wrong with it and what is allowed.
LibraryFile open_library_of(const Job& job);

/// Resolves the job's wishes by the names of the library's shapes (wish_resolution.h).
void resolve_wishes(const LibraryFile& library, Job& job);

}  // namespace tessera::io
