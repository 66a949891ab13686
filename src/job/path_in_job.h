// Names of files in a job that a command writes.
#pragma once

#include <string>

namespace tessera {

/// The name of a file as a job has it: relative to the job's folder, or as it is where it begins at the root. Works on names
/// alone: links are not followed. Throws InputError where the name is not UTF-8, as a job's text must be.
std::string path_in_job(const std::string& path, const std::string& job);

}  // namespace tessera
