// A library's shapes in parts, each of what the same rows of a table are about. Rows come one after the other and split
// the parts that they are about only partly, so that time and memory go by what the rows say, not by rows times shapes.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/settings/wishes.h"

namespace tessera {

class WishParts {
 public:
  explicit WishParts(std::size_t shapes);

  /// `shapes`: what the row is about, each once; `say` changes a part's wish as the row says.
  void add_row(const std::vector<std::uint32_t>& shapes, const std::function<void(ShapeWish&)>& say);

  std::uint32_t part_of(std::size_t shape) const { return part_of_[shape]; }
  const ShapeWish& wish(std::uint32_t part) const { return parts_[part].wish; }

 private:
  struct Part {
    ShapeWish wish;
    std::size_t shapes = 0;
    std::size_t chosen = 0;       // of them, by the row
    std::uint32_t of_chosen = 0;  // the part that they come to
  };

  std::vector<Part> parts_;
  std::vector<std::uint32_t> part_of_;  // by shape
};

}  // namespace tessera
