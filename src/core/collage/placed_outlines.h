// The outlines of the placed pieces as they are written to pieces.geojson, and the last word on whether another piece
// may stand beside them: polygon against polygon, where fields and boundary points only estimate.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/collage/placement.h"
#include "core/field/free_field.h"
#include "core/geometry/polygon_index.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera {

/// The outline where the piece lies, in canvas px.
Outline placed_outline(const Outline& outline, const Similarity& canvas_from_shape);

class PlacedOutlines {
 public:
  /// `free` outlives the outlines: it knows the canvas' edge.
  PlacedOutlines(const FreeField& free, const PieceSettings& pieces);

  /// `line_radius`: as of shape_field.h.
  void add(const Placement& placement, const Outline& outline, float line_radius);
  /// Makes the outlines those of `placements`, in this order.
  void replace(const std::vector<Placement>& placements, ShapeSource& shapes);

  /// For each neighbour that the piece comes too near to, and for the canvas' edge, the way (px) by which it would have
  /// to move away; no way, (0, 0), where it is larger than the period of a seamless canvas. With padding_px, or where
  /// overlap_px is 0, two polygons are at least so far apart, exactly; else no vertex of one lies deeper than
  /// overlap_px in the other, and where one consists of lines (line_art.h) not so deep that it crosses them. Where the
  /// list is empty, the piece may stand.
  std::vector<Vec2> conflicts(const Shape& shape, const Similarity& canvas_from_shape) const;

  // For those that are placed and still move: by their index, in the order in which they were added.

  void move(std::size_t index, const Similarity& canvas_from_shape, const Outline& outline);
  /// Takes the piece out; the others keep their indices. Of this one nothing may be asked any more.
  void take_out(std::size_t index);
  /// The distance of a placed piece by its shape's field, positive outside, canvas px.
  using FieldDistance = std::function<float(std::size_t index, Vec2 canvas_px)>;
  /// conflicts() of a placed piece with all others, whatever the free field holds; where there are none, the others
  /// have none with it either.
  std::vector<Vec2> conflicts_of(std::size_t index, const FieldDistance& distance_px) const;
  /// The same without the canvas' edge, and without pieces larger than the period.
  std::vector<Vec2> conflicts_with_others(std::size_t index, const FieldDistance& distance_px) const;

 private:
  struct Placed {
    Placement placement;
    std::shared_ptr<const PolygonIndex> outline;  // none: it was taken out
    Box box;
    float line_radius;  // shape units

    float line_radius_px() const { return line_radius * placement.canvas_from_shape.scale(); }
  };
  /// `needed_px`, but where a piece consists of lines as much less deep as these allow.
  static float needed_of(float needed_px, float line_radius_px);
  void add_neighbours(const Shape& shape, const Similarity& canvas_from_shape, const PolygonIndex& piece,
                      float needed_px, std::vector<Vec2>& ways) const;
  /// `in_piece` and `in_other`: see deepest_vertex().
  template <class InPiece, class InOther>
  void add_ways(const PolygonIndex& piece, InPiece in_piece, const PolygonIndex& other, InOther in_other,
                float needed_px, std::vector<Vec2>& ways) const;
  bool any_near(const Box& piece, float reach_px) const;
  bool reaches_itself(const Box& piece) const;
  static bool too_near(const PolygonIndex& piece, const PolygonIndex& other, float needed_px, Vec2& way);
  bool too_near_the_edge(const PolygonIndex& piece, float needed_px, Vec2& way) const;
  bool holds_a_zone(const PolygonIndex& piece, float needed_px) const;

  const FreeField& free_;
  float needed_px_;  // between the boundaries; negative: how deep one may reach into the other
  std::vector<Placed> placed_;
};

}  // namespace tessera
