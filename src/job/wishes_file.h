// The table of wishes beside a library (library.wishes): rows of [[shapes]], written in a spreadsheet.
#pragma once

#include "job/job_file.h"

namespace tessera {

/// Inserts the rows of the file Job::wishes before the job's own [[shapes]], notes their places in the file, and
/// empties the path: job.toml of the result is then complete without the file. Throws InputError that names file, line,
/// column, what was found and what is allowed.
void add_wishes_of_file(Job& job);

}  // namespace tessera
