// The named groups that a job puts its shapes into, for those who edit the collage.
#pragma once

#include <string>
#include <vector>

#include "io/job/job_file.h"

namespace tessera::io {

/// For each of the shapes' names the `group` of the last row of [[shapes]] that says one of it; empty: none.
std::vector<std::string> shape_groups(const Job& job, const std::vector<std::string>& names);

}  // namespace tessera::io
