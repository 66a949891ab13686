// Silhouettes that nobody can tell apart: either of them counts as found.
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "bench/blocking/silhouettes.h"

namespace tessera::bench {

class Twins {
 public:
  /// Every silhouette is its own twin alone.
  Twins() = default;
  /// The pairs of a text, two names a line; "~" before a name means the mirror image. '#' begins a comment, and what
  /// follows the names is not looked at. Names that no silhouette has are passed over. Throws InputError, which names
  /// `path` and the line, where a line has one name.
  Twins(const std::string& text, const std::string& path, const std::vector<Silhouette>& silhouettes);

  /// Whether silhouette `b`, or its mirror image where `b_mirrored`, is a twin of silhouette `a`, or `a` itself.
  bool are_twins(std::size_t a, std::size_t b, bool b_mirrored = false) const {
    return (a == b && !b_mirrored) || pairs_.contains({std::min(a, b), std::max(a, b), b_mirrored});
  }
  /// How many pairs there are.
  std::size_t size() const { return pairs_.size(); }

 private:
  /// The smaller place, the larger one, and whether one of both is mirrored: it does not matter which.
  std::set<std::tuple<std::size_t, std::size_t, bool>> pairs_;
};

/// Throws InputError where the file cannot be read, too.
Twins read_twins(const std::string& path, const std::vector<Silhouette>& silhouettes);

}  // namespace tessera::bench
