// The colours of drawn silhouettes: a built-in palette, a palette file, or a list in the job.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"

namespace tessera {

/// The names of the built-in palettes.
const std::vector<std::string>& built_in_palettes();

/// Whether the value of a colour key is a list of colours; otherwise it is one text: a word of the key, or a file.
bool is_colour_list(const std::vector<std::string>& palette);

/// The colours of `colour.palette` as "#rrggbb", each once and at least one. Throws InputError that names the job, the
/// key, the file and its line, what was found and what is allowed. Where `option` is given the message names that
/// option instead of job and key.
std::vector<std::string> load_palette(const Job& job, const std::string& option = {});

/// The colours of `library.colours`, loaded in the same way; empty where it is "all".
std::vector<std::string> load_library_colours(const Job& job);

}  // namespace tessera
