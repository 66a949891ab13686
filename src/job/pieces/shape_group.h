// The named groups that a job puts its shapes into, for those who edit the collage.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"

namespace tessera {

/// For each of the shapes' names the `group` of the last row of [[shapes]] that says one of it; empty: none.
/// `other_names` are shapes of the library, too (NameIndex).
std::vector<std::string> shape_groups(const Job& job, const std::vector<std::string>& names,
                                      const std::vector<std::string>& other_names = {});

}  // namespace tessera
