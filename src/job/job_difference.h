// Differences between two jobs, for messages: the job of a checkpoint or result, and the job asked for now.
#pragma once

#include <functional>
#include <string>

#include "job/job_keys.h"

namespace tessera {

/// "; KEY: then A, now B" for each key with another value for which `counts` is true. For lists it says what was added
/// and removed, for tables which have other rows. Empty where there is no difference.
std::string job_differences(const Job& then, const Job& now, const std::function<bool(const JobKey&)>& counts);

}  // namespace tessera
