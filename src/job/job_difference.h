// How two jobs differ, for messages: what a checkpoint or a result was made with, and what is asked for now.
#pragma once

#include <functional>
#include <string>

#include "job/job_keys.h"

namespace tessera {

/// "; KEY: then A, now B" for each key that `counts` and has another value, of lists what came and went, and which
/// tables have other rows. Empty where there is none.
std::string job_differences(const Job& then, const Job& now, const std::function<bool(const JobKey&)>& counts);

}  // namespace tessera
