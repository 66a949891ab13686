// What a folder already holds, compared with what a job would give.
#pragma once

#include <optional>
#include <string>

#include "io/job/job_file.h"

namespace tessera::io {

/// The job whose finished collage `dir` holds: every file is there, and no signal or time limit ended it early. Nothing
/// where there is none, or none that this version of the program reads.
std::optional<Job> job_of_finished_result(const std::string& dir);

/// Whether `dir` holds the finished result of `job`. Throws InputError with the keys that differ where it holds that of
/// another job, which would be lost.
bool is_finished_result_of(const std::string& dir, const Job& job);

/// "; KEY: then A, now B" for each key that makes the result of `now` another one than that of `then`. Empty where they
/// are the same.
std::string result_differences(const Job& then, const Job& now);

}  // namespace tessera::io
