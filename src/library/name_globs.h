// Chooses shapes by their names.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "library/name_index.h"

namespace tessera {

/// Patterns like those of a shell: * is any number of characters, ? one, [abc] one of these, \ takes the next character as
/// it is. They are case-sensitive and match the whole name. Where a name is identical with the pattern, the pattern means
/// this name alone (NameIndex::matching).
struct NameGlobs {
  std::vector<std::string> include;  // empty: all names
  std::vector<std::string> exclude;  // patterns to take out of the included names

  bool empty() const { return include.empty() && exclude.empty(); }
};

/// The message is "include: ..." or "exclude: ...". Callers that know where the patterns come from name that place.
class NamesNotFound : public InputError {
 public:
  NamesNotFound(const std::string& list, const std::string& reason)
      : InputError(list + ": " + reason),
        reason_(reason) {}

  /// The reason without the list's name.
  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

/// The places of the chosen names, ascending. Throws NamesNotFound where a pattern of `include` matches no name (it
/// suggests similar names), or where nothing is left. `library`: for messages.
std::vector<std::uint32_t> chosen_names(const NameIndex& names, const NameGlobs& globs, const std::string& library);

}  // namespace tessera
