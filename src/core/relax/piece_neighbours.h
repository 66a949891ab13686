// Which pieces may touch: by their boxes, on a plane that may repeat itself.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/period.h"
#include "core/geometry/polygon.h"

namespace tessera {

/// Another piece, or the same, at one of its images.
struct Neighbour {
  std::uint32_t piece = 0;
  Vec2 offset;  // from the piece to the image
};

class PieceNeighbours {
 public:
  /// Of pieces with these boxes, canvas px.
  PieceNeighbours(const std::vector<Box>& boxes, const Period& period);

  /// Those whose boxes are within `reach_px` of that of `piece`, without itself; in a fixed order.
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
  std::vector<std::uint32_t> first_;   // of each cell in pieces_, and the end
  std::vector<std::uint32_t> pieces_;  // by cell; those that lie in several stand in each of them
};

}  // namespace tessera
