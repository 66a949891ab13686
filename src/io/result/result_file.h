// Reads the files of a result: one that is not there is told apart from one that the machine cannot read.
#pragma once

#include <optional>
#include <string>

namespace tessera::io {

/// "out/animals/card.json"
std::string path_in_result(const std::string& dir, const std::string& name);

/// Whether `dir` has something of this name. Throws EnvironmentError where the system does not say.
bool is_in_result(const std::string& dir, const std::string& name);

/// The bytes of dir/name, which must be there: otherwise throws InputError. Throws EnvironmentError where it is there
/// and cannot be read, which is no reason to make the result anew.
std::string read_result_file(const std::string& dir, const std::string& name);

}  // namespace tessera::io
