// The named groups that a job puts its shapes into, for those who edit the collage.
#pragma once

#include <string>

#include "io/job/job_file.h"

namespace tessera::io {

/// The `group` of the last row of [[shapes]] that says one of shapes with this name; empty: none.
std::string shape_group(const Job& job, const std::string& shape_name);

}  // namespace tessera::io
