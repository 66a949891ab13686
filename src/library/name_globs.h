// A choice of shapes by their names.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "library/name_index.h"

namespace tessera {

/// Patterns as the shell knows them: * any characters, ? one, [abc] one of these, \ the next as it is. They tell case
/// and are compared with the whole name. A name that is the pattern letter by letter wins over the names that the
/// pattern is of (NameIndex::matching).
struct NameGlobs {
  std::vector<std::string> include;  // empty: all names
  std::vector<std::string> exclude;  // of the included ones

  bool empty() const { return include.empty() && exclude.empty(); }
};

/// "include: ..." or "exclude: ..."; who knows where the patterns come from says so.
class NamesNotFound : public InputError {
 public:
  NamesNotFound(const std::string& list, const std::string& reason)
      : InputError(list + ": " + reason),
        reason_(reason) {}

  /// Without the list's name.
  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

/// The places, ascending, of the names of `library` that are chosen. Throws NamesNotFound where a pattern of `include`
/// matches no name, and tells names that are near it, or where nothing is left.
std::vector<std::uint32_t> chosen_names(const NameIndex& names, const NameGlobs& globs, const std::string& library);

}  // namespace tessera
