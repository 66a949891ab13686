// Silhouettes that nobody can tell apart: either of them counts as found.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bench/blocking/silhouettes.h"

namespace tessera::bench {

class Twins {
 public:
  /// Every silhouette is its own twin alone.
  Twins() = default;
  /// The pairs of a text, two names a line; '#' begins a comment, and what follows the names is not looked at. Names that
  /// no silhouette has are passed over. Throws InputError, which names `path` and the line, where a line has one name.
  Twins(const std::string& text, const std::string& path, const std::vector<Silhouette>& silhouettes);

  bool are_twins(std::size_t a, std::size_t b) const { return a == b || pairs_.contains({a, b}); }
  /// How many pairs there are.
  std::size_t size() const { return pairs_.size() / 2; }

 private:
  std::set<std::pair<std::size_t, std::size_t>> pairs_;  // both ways
};

/// Throws InputError where the file cannot be read, too.
Twins read_twins(const std::string& path, const std::vector<Silhouette>& silhouettes);

}  // namespace tessera::bench
