// A choice of shapes by their names.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace tessera::io {

/// Patterns as the shell knows them: * any characters, ? one, [abc] one of these, \ the next as it is. They tell case
/// and are compared with the whole name.
struct NameGlobs {
  std::vector<std::string> include;  // empty: all names
  std::vector<std::string> exclude;  // of the included ones

  bool empty() const { return include.empty() && exclude.empty(); }
};

/// "include: ..." or "exclude: ..."; who knows where the patterns come from says so.
class NamesNotFound : public InputError {
 public:
  using InputError::InputError;
};

/// Whether one of the patterns is this name's.
bool matches_any(const std::vector<std::string>& globs, const std::string& name);

/// Which of the names of `library` are chosen. Throws NamesNotFound where a pattern of `include` matches no name, and
/// tells names that are near it, or where nothing is left.
std::vector<bool> chosen_names(const std::vector<std::string>& names, const NameGlobs& globs,
                               const std::string& library);

}  // namespace tessera::io
