// A choice of shapes by their names.
#pragma once

#include <string>
#include <vector>

namespace tessera::io {

/// Patterns as the shell knows them: * any characters, ? one, [abc] one of these, \ the next as it is. They tell case
/// and are compared with the whole name.
struct NameGlobs {
  std::vector<std::string> include;  // empty: all names
  std::vector<std::string> exclude;  // of the included ones

  bool empty() const { return include.empty() && exclude.empty(); }
};

/// Which of the names are chosen. Throws InputError where a pattern of `include` matches no name, and tells names that
/// are near it, or where nothing is left.
std::vector<bool> chosen_names(const std::vector<std::string>& names, const NameGlobs& globs);

}  // namespace tessera::io
