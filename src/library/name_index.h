// Names in order, so that a pattern is compared only with those that begin as it does.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace tessera {

/// Whether a text that selects names says more than one name.
bool is_pattern(const std::string& glob);

/// Places are those in the list that it was made of; a name may stand there several times.
class NameIndex {
 public:
  /// `other_names` were left out of the list: a pattern that is one of them letter by letter means that one, not those
  /// in the list that it would be of.
  explicit NameIndex(std::vector<std::string> names, const std::vector<std::string>& other_names = {});

  const std::vector<std::string>& names() const { return names_; }

  /// The first place of exactly this name, or of the one that is shown so (printable_utf8).
  std::optional<std::uint32_t> find(const std::string& name) const;

  /// The places, ascending, of the names that the pattern (name_globs.h) is of. Where there is a name that is the
  /// pattern letter by letter, or is shown so (printable_utf8), it is that name that was meant: "logo [final]" selects
  /// itself, and no "logo f".
  std::vector<std::uint32_t> matching(const std::string& glob) const;

  /// The places, by name, of all that the pattern may be of: those of this very name; where no name is the same, those
  /// that begin as it does up to its first wild card.
  std::span<const std::uint32_t> candidates(const std::string& glob) const;

 private:
  std::span<const std::uint32_t> named(const std::string& name) const;

  std::vector<std::string> names_;
  std::vector<std::uint32_t> in_order_;                      // by name; of equal ones by place
  std::set<std::string> other_names_;                        // those that look like patterns
  std::map<std::string, std::vector<std::uint32_t>> shown_;  // places of names that are shown as others
};

}  // namespace tessera
