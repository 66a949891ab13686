// What is said of pictures of which a part is read alone.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"

namespace tessera {

/// Names the files that are animations or have several pages, of which the first picture is used. Empty where there is
/// none. What is no picture, or cannot be read, is passed over: whoever uses it says so.
std::string first_picture_warning(const std::vector<std::string>& files);

/// The same of all files that a job's keys name.
std::string first_picture_warning(const Job& job);

}  // namespace tessera
