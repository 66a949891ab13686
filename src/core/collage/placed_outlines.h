// The outlines of the placed pieces as they are written to pieces.geojson. They decide finally whether another piece
// may stand beside them: polygon against polygon, where fields and boundary points only estimate.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "core/collage/placement.h"
#include "core/field/free_field.h"
#include "core/geometry/polygon_index.h"
#include "core/geometry/tile_index.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera {

/// The outline at the piece's pose, in canvas px.
Outline placed_outline(const Outline& outline, const Similarity& canvas_from_shape);

class PlacedOutlines {
 public:
  /// `free` gives the canvas' edge and must outlive this object.
  PlacedOutlines(const FreeField& free, const PieceSettings& pieces);

  /// `line_radius`: see shape_field.h.
  void add(const Placement& placement, const Outline& outline, float line_radius);
  /// Sets the outlines to those of `placements`, in this order.
  void replace(const std::vector<Placement>& placements, ShapeSource& shapes);

  /// The conflicts of a piece with neighbours that are too near and with the canvas' edge. A conflict is the vector
  /// (px) by which the piece would have to move away. It is (0, 0) where no move helps: the piece is larger than the
  /// period of a seamless canvas, or it surrounds a zone. With padding_px, or if overlap_px is 0, polygons must have at
  /// least that distance, exactly. Otherwise no vertex of one may lie deeper than overlap_px in the other. In pieces of
  /// lines (line_art.h) less is allowed, so that lines do not cross. An empty list: the piece may stand.
  std::vector<Vec2> conflicts(const Shape& shape, const Similarity& canvas_from_shape) const;

  // For placed pieces that still move. An index is the place in the order in which pieces were added.

  void move(std::size_t index, const Similarity& canvas_from_shape, const Outline& outline);
  /// Removes the piece; the others keep their indices. This index may not be used any more.
  void take_out(std::size_t index);
  /// The distance, canvas px, of a position to a placed piece by its shape's field; positive outside.
  using FieldDistance = std::function<float(std::size_t index, Vec2 canvas_px)>;
  /// conflicts() of a placed piece with all others, whatever the free field holds. If it has no conflict with another
  /// piece, that piece has none with it.
  std::vector<Vec2> conflicts_of(std::size_t index, const FieldDistance& distance_px) const;
  /// conflicts_of() without the canvas' edge and without the test for pieces larger than the period.
  std::vector<Vec2> conflicts_with_others(std::size_t index, const FieldDistance& distance_px) const;

 private:
  struct Placed {
    Placement placement;
    std::shared_ptr<const PolygonIndex> outline;  // empty: the piece was taken out
    Box box;
    float line_radius;  // shape units

    float line_radius_px() const { return line_radius * placement.canvas_from_shape.scale(); }
  };
  /// `needed_px`, reduced to the smaller depth that pieces of lines allow.
  static float required_distance_px(float needed_px, float line_radius_px);
  void add_neighbours(const Shape& shape, const Similarity& canvas_from_shape, const PolygonIndex& piece,
                      float needed_px, std::vector<Vec2>& ways) const;
  /// `in_piece` and `in_other`: see deepest_vertex().
  template <class InPiece, class InOther>
  void add_ways(const PolygonIndex& piece, InPiece in_piece, const PolygonIndex& other, InOther in_other,
                float needed_px, std::vector<Vec2>& ways) const;
  /// The pieces whose boxes are within reach of this box, in the order in which they were added.
  std::vector<std::size_t> near(const Box& piece, float reach_px) const;
  void set_box(std::size_t index, const Box& box);
  bool reaches_itself(const Box& piece) const;
  static bool too_near(const PolygonIndex& piece, const PolygonIndex& other, float needed_px, Vec2& way);
  bool too_near_the_edge(const PolygonIndex& piece, float needed_px, Vec2& way) const;
  bool holds_a_zone(const PolygonIndex& piece, float needed_px) const;

  const FreeField& free_;
  float needed_px_;  // between the boundaries; negative: largest depth of one in the other
  std::vector<Placed> placed_;
  TileIndex index_;        // of placed_, by the lower corner of the box, canvas px
  Vec2 largest_px_{0, 0};  // width and height that no box has exceeded
};

}  // namespace tessera
