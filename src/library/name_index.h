// Names in sorted order, so that a pattern is compared only with names that begin like it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace tessera {

/// Whether the text can select more than one name, because it has wild cards.
bool is_pattern(const std::string& glob);

/// A place is the position of a name in the list that the index was made of; a name may occur several times.
class NameIndex {
 public:
  /// `other_names` were left out of the list. A pattern that is identical with one of them means that name, and matches
  /// nothing in the list.
  explicit NameIndex(std::vector<std::string> names, const std::vector<std::string>& other_names = {});

  const std::vector<std::string>& names() const { return names_; }

  /// The first place of exactly this name, or of a name that is displayed like it (printable_utf8).
  std::optional<std::uint32_t> find(const std::string& name) const;

  /// The places, ascending, of the names that match the pattern (name_globs.h). Where a name is identical with the pattern,
  /// or is displayed like it (printable_utf8), only this name is meant: "logo [final]" selects itself, and no "logo f".
  std::vector<std::uint32_t> matching(const std::string& glob) const;

  /// The places, by name, of all names that could match the pattern: those of an identical name; otherwise those that
  /// begin like the pattern up to its first wild card.
  std::span<const std::uint32_t> candidates(const std::string& glob) const;

 private:
  std::span<const std::uint32_t> named(const std::string& name) const;

  std::vector<std::string> names_;
  std::vector<std::uint32_t> in_order_;                      // by name; equal names by place
  std::set<std::string> other_names_;                        // only those that look like patterns
  std::map<std::string, std::vector<std::uint32_t>> shown_;  // places of names that are displayed in another form
};

}  // namespace tessera
