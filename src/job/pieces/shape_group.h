// The named groups into which a job puts its shapes, for people who edit the collage.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"

namespace tessera {

/// The `group` of each shape: from the last row of [[shapes]] that gives one for its name; empty: none. `other_names`
/// are further shapes of the library (NameIndex).
std::vector<std::string> shape_groups(const Job& job, const std::vector<std::string>& names,
                                      const std::vector<std::string>& other_names = {});

}  // namespace tessera
