// The deformation of one piece of a collage, round by round.
#pragma once

#include <vector>

#include "core/deform/boundary_map.h"
#include "core/deform/deformation.h"
#include "core/deform/identity.h"
#include "core/deform/unfolded_fit.h"
#include "core/field/field_lookup.h"

namespace tessera {

class PieceDeformer {
 public:
  /// `piece.shape` and `settings` must outlive this object. `index`: the piece's index in the maps.
  PieceDeformer(const DeformablePiece& piece, std::uint32_t index, const DeformSettings& settings,
                const PadParameters& pad);

  /// Sets how far each point of the boundary may move, from the undeformed pieces. Called once, before the first round.
  void set_limits(const BoundaryMap& undeformed);

  /// Moves the boundary a step towards the middle between this piece and its neighbours, which lie as in `map`. With
  /// `clears`, only away from pieces that it overlaps.
  void step(const BoundaryMap& map, const FieldView& canvas, float gap_px, bool clears);

  /// While the piece has changed more than the settings allow, reduces the outward movement of its boundary.
  void grow_less();
  /// Reduces the whole deformation until the piece certainly keeps the settings' limits.
  void weaken();
  /// Reduces the whole deformation by one step.
  void shrink();
  void undo();

  bool is_deformed() const { return farthest_px() > 0; }
  /// The pieces to whose boundaries in `map` some point of this piece is nearer than `gap_px`.
  std::vector<std::uint32_t> nearer_than(float gap_px, const BoundaryMap& map) const;

  /// Removes the deformation if the boundary crosses itself in `map` and did not before.
  void undo_where_crossed(const BoundaryMap& map);

  Outline outline_px() const;
  DeformedPiece result() const;

 private:
  /// A point of the outline.
  struct Point {
    Vec2 home;    // shape frame
    Vec2 normal;  // outward, shape frame, of length 1
    float most_out_px = 0;
    float most_in_px = 0;
    float wished_px = 0;  // movement along the normal that is aimed at
  };

  float most_px() const;
  float farthest_px() const;
  void scale_warp(float factor);
  bool keeps_identity() const;
  std::vector<Vec2> wished() const;

  const DeformablePiece piece_;
  const std::uint32_t index_;
  const DeformSettings& settings_;
  const float scale_px_;
  const double area_;  // shape frame
  ShapeIdentity identity_;
  UnfoldedFit fit_;
  std::vector<Point> points_;  // curve after curve
  Warp warp_;
  bool crossed_ = false;  // already before the deformation
};

}  // namespace tessera
