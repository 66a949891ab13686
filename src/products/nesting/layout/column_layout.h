// A layout without a search: pieces in columns beside each other, by their bounding boxes. It is the layout before a search
// has found a better one.
#pragma once

#include <span>
#include <vector>

#include "products/nesting/layout/nest_problem.h"

namespace tessera {

class ColumnLayout {
 public:
  /// Refers to the problem, which must outlive it.
  explicit ColumnLayout(const NestProblem& problem);

  /// A layout of all pieces.
  NestLayout all() const;

  /// The items that are too large for the material at all of their angles.
  std::vector<int> too_large() const;

  /// Adds pieces, given by their items, to a layout: on a strip from x = `from` on, on sheets from a new sheet on. Pieces
  /// that are too large at all of their angles are left over. `layout.used_length` becomes that of the strip, or of the
  /// last sheet.
  void add(std::span<const int> items, double from, NestLayout& layout) const;

 private:
  /// A piece at the angle at which its bounding box is smallest; of equal ones the narrowest.
  struct Boxed {
    int item = 0;
    int angle = -1;    // -1: none fits
    NestPoint corner;  // shift that moves the box into the corner of the material
    double width = 0, height = 0;
  };
  Boxed boxed(int item) const;

  const NestProblem* problem_;
  std::vector<Boxed> boxes_;  // of each item
};

}  // namespace tessera
