// One piece of a collage that is being deformed, round by round.
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
  /// `piece.shape` and `settings` must outlive it. `index`: of the piece in the maps.
  PieceDeformer(const DeformablePiece& piece, std::uint32_t index, const DeformSettings& settings,
                const PadParameters& pad);

  /// How far each point of the boundary may go, as the undeformed pieces lie. Once, before the first round.
  void set_limits(const BoundaryMap& undeformed);

  /// A step towards the middle of what is between this piece and its neighbours, as all lie in `map`; `clears`: only away
  /// from what it overlaps.
  void step(const BoundaryMap& map, const FieldView& canvas, float gap_px, bool clears);

  /// Where the piece has changed more than the settings allow: its boundary goes less far out.
  void grow_less();
  /// The same for certain, and no farther than the settings allow, by less of the whole deformation.
  void weaken();
  /// Some less of the deformation.
  void shrink();
  void undo();

  bool is_deformed() const { return farthest_px() > 0; }
  /// The pieces to whose boundaries in `map` a point of this one's is nearer than `gap_px`.
  std::vector<std::uint32_t> nearer_than(float gap_px, const BoundaryMap& map) const;

  /// Without any deformation, where the boundary crosses itself in `map` and did not before.
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
    float wished_px = 0;  // along the normal
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
  bool crossed_ = false;  // already before it was deformed
};

}  // namespace tessera
