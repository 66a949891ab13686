// File names in a job that a command writes.
#pragma once

#include <string>

namespace tessera {

/// The name of a file for a job: relative to the job's folder, or unchanged where it is absolute. Works on the names
/// only and follows no links. Throws InputError where the name is not UTF-8, as the text of a job must be.
std::string path_in_job(const std::string& path, const std::string& job);

/// The path of a file that is written beside a job and has its name: wall_sizes.png beside wall.toml.
std::string path_beside_job(const std::string& job, const std::string& ending);

}  // namespace tessera
