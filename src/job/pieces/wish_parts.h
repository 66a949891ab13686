// Divides a library's shapes into parts: the shapes of a part are named by the same rows of a table. Each row splits
// only those parts that it names partly, so that time and memory grow with the rows' content, not with rows times
// shapes.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/settings/wishes.h"

namespace tessera {

class WishParts {
 public:
  explicit WishParts(std::size_t shapes);

  /// Adds a row. `shapes`: the shapes that it names, each once; `say` applies the row to a part's wish.
  void add_row(const std::vector<std::uint32_t>& shapes, const std::function<void(ShapeWish&)>& say);

  std::uint32_t part_of(std::size_t shape) const { return part_of_[shape]; }
  const ShapeWish& wish(std::uint32_t part) const { return parts_[part].wish; }

 private:
  struct ShapePart {
    ShapeWish wish;
    std::size_t shapes = 0;
    std::size_t chosen = 0;       // shapes of this part that the current row names
    std::uint32_t of_chosen = 0;  // the part that these shapes get
  };

  std::vector<ShapePart> parts_;
  std::vector<std::uint32_t> part_of_;  // by shape
};

}  // namespace tessera
