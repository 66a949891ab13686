// The table of wishes beside a library (library.wishes): rows of [[shapes]], written in a spreadsheet.
#pragma once

#include "job/job_file.h"

namespace tessera {

/// Puts the rows of Job::wishes before those of the job's [[shapes]], remembers their places, and empties the path:
/// from then on they are the job's own, and its job.toml is whole without the file. Throws InputError that names file,
/// line, column, what was found and what is allowed.
void add_wishes_of_file(Job& job);

}  // namespace tessera
