// Random choices for forgeries. They follow from a seed, the same on every machine.
#pragma once

#include <random>

#include "library/library_surgery.h"

namespace tessera::test {

class ForgingChance {
 public:
  explicit ForgingChance(std::uint32_t seed) : random_(seed), columns_(all_columns()) {}

  std::uint32_t bits() { return std::uint32_t(random_()); }
  std::size_t below(std::size_t end) { return std::size_t(random_() % end); }

  const std::vector<Column>& columns() const { return columns_; }
  const Column& any_column() { return columns_[below(columns_.size())]; }

  /// Removes the digests of the parts from half of the files, as an older version wrote them. Then only the limits can reveal a forgery.
  bool make_older(hid_t file) {
    if (below(2) == 0) return false;
    H5Ldelete(file, "/shapes/part_digest", H5P_DEFAULT);
    return true;
  }

 private:
  std::mt19937 random_;
  std::vector<Column> columns_;
};

}  // namespace tessera::test
