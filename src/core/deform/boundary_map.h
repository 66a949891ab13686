// A spatial index of the boundaries of all pieces of a collage: distance to the nearest other boundary, and first hit
// of a ray.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/period.h"
#include "core/geometry/polygon.h"
#include "core/geometry/polygon_index.h"

namespace tessera {

/// Length of a ray up to its first hit; the whole length if it hits nothing.
struct RayHits {
  float own_px = 0;    // the boundary of the piece itself
  float other_px = 0;  // that of another, or of an image of the piece
};

/// The nearest boundary among all other pieces and images of the piece.
struct NearestOther {
  float distance_px = 0;  // negative inside the other piece
  std::optional<std::uint32_t> piece;
};

class BoundaryMap {
 public:
  /// `pieces_px`: canvas frame. On a seamless canvas all images count.
  BoundaryMap(const std::vector<Outline>& pieces_px, const Period& period);

  /// The nearest other boundary; `reach_px` without a piece if none is nearer.
  NearestOther nearest_other(Vec2 p, std::uint32_t piece, float reach_px) const;
  float distance_to_others_px(Vec2 p, std::uint32_t piece, float reach_px) const {
    return nearest_other(p, piece, reach_px).distance_px;
  }

  /// The hits of a ray. `direction` has length 1. Own boundary within kSelf_px of the start does not count, as the ray
  /// starts from it.
  RayHits hits(Vec2 from, Vec2 direction, float length_px, std::uint32_t piece) const;

  /// Whether two segments of the piece cross that are not neighbours.
  bool crosses_itself(std::uint32_t piece) const;

 private:
  /// A side of a boundary, with its neighbours along the curve.
  struct Side {
    Segment segment;
    std::uint32_t piece;
    bool image;
    std::uint32_t before;
    std::uint32_t after;
  };
  struct Cells {
    int x0, y0, x1, y1;
  };

  void add(const Outline& outline, std::uint32_t piece, Vec2 offset, bool image);
  void sort_into_cells();
  Cells cells_of(Vec2 low, Vec2 high) const;
  bool is_own(const Side& side, std::uint32_t piece) const { return side.piece == piece && !side.image; }
  bool is_inside_of(const Side& side, Vec2 p) const;
  template <class F>
  void each_in(const Cells& cells, F f) const;

  std::vector<Side> sides_;
  std::vector<std::uint32_t> own_sides_;  // first side of each piece in sides_, and the end; images come last
  Vec2 low_;
  float cell_px_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> first_;  // the first index of each cell in sorted_, and the end
  std::vector<std::uint32_t> sorted_;
};

}  // namespace tessera
