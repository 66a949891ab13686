// Finds the pieces that may touch, by their boxes, on a plane that may repeat.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/period.h"
#include "core/geometry/polygon.h"

namespace tessera {

/// Another piece, or the same piece, at one of its images.
struct Neighbour {
  std::uint32_t piece = 0;
  Vec2 offset;  // from the piece to the image
};

class PieceNeighbours {
 public:
  /// `boxes`: the bounding boxes of all pieces, canvas px.
  PieceNeighbours(const std::vector<Box>& boxes, const Period& period);

  /// The neighbours whose boxes are within `reach_px` of that of `piece`, without the piece itself; in a fixed order.
  std::vector<Neighbour> of(std::uint32_t piece, float reach_px) const;

 private:
  struct Cells {
    int x0, y0, x1, y1;
  };
  Cells cells_of(const Box& box) const;

  std::vector<Box> boxes_;
  std::vector<Vec2> offsets_;
  Box all_;
  float cell_px_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> first_;   // the first index of each cell in pieces_, and the end
  std::vector<std::uint32_t> pieces_;  // by cell; a piece in several cells is listed in each of them
};

}  // namespace tessera
