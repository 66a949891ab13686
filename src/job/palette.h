// The colours that silhouettes are drawn in: built in, from a palette file, or as the job lists them.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"

namespace tessera {

/// The names of the palettes that the program has.
const std::vector<std::string>& built_in_palettes();

/// What the value of a key of colours is: a list of colours; else the text alone is one of the key's words or a file.
bool is_colour_list(const std::vector<std::string>& palette);

/// The colours of `colour.palette` as "#rrggbb", each once, one at least. Throws InputError that names the job, the
/// key, the file and its line, what was found and what is allowed; with `option`, what the palette was given to, it
/// names that instead of job and key.
std::vector<std::string> load_palette(const Job& job, const std::string& option = {});

/// The same of `library.colours`; none where it is "all".
std::vector<std::string> load_library_colours(const Job& job);

}  // namespace tessera
