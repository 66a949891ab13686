// Silhouettes that nobody can tell apart; each of them counts as a right answer.
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
  /// No twins: every silhouette is only its own twin.
  Twins() = default;
  /// Reads pairs from a text, two names in a line; "~" before a name means the mirror image. '#' begins a comment, and
  /// the rest of a line is ignored. Pairs with an unknown name are ignored. Throws InputError, which names `path` and
  /// the line, where a line has only one name.
  Twins(const std::string& text, const std::string& path, const std::vector<Silhouette>& silhouettes);

  /// Whether silhouette `b`, or its mirror image where `b_mirrored`, is a twin of silhouette `a`, or `a` itself.
  bool are_twins(std::size_t a, std::size_t b, bool b_mirrored = false) const {
    return (a == b && !b_mirrored) || pairs_.contains({std::min(a, b), std::max(a, b), b_mirrored});
  }
  /// The number of pairs.
  std::size_t size() const { return pairs_.size(); }

 private:
  /// (smaller index, larger index, whether one of both is mirrored); it does not matter which.
  std::set<std::tuple<std::size_t, std::size_t, bool>> pairs_;
};

/// Reads the pairs of a file. Also throws InputError where the file cannot be read.
Twins read_twins(const std::string& path, const std::vector<Silhouette>& silhouettes);

}  // namespace tessera::bench
