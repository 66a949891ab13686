// Warns of files with several pictures, of which only the first is used.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"

namespace tessera {

/// Names the files that are animations or have several pages. Empty where there is none. It skips files that are no
/// pictures or cannot be read: whoever uses them reports that.
std::string first_picture_warning(const std::vector<std::string>& files);

/// This warning for all files that a job's keys name.
std::string first_picture_warning(const Job& job);

}  // namespace tessera
