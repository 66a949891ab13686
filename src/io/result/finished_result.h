// Whether a folder already holds what a job would give.
#pragma once

#include <string>

#include "io/job/job_file.h"

namespace tessera::io {

/// `dir` has every file of a collage of exactly this job, and it was not ended early by a signal.
bool holds_finished_result(const std::string& dir, const Job& job);

}  // namespace tessera::io
