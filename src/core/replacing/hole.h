// A hole between pieces: its free area as a raster, and the rim that pieces dock to. Canvas px.
#pragma once

#include <vector>

#include "core/relax/contacts.h"

namespace tessera {

/// A point of the hole's rim.
struct RimPoint {
  Vec2 at;
  Vec2 inward;        // unit, into the hole
  float room_px = 0;  // length of the free way from here inward
};

class Hole {
 public:
  /// A square around `centre_px`, free except where it lies outside the canvas.
  Hole(Vec2 centre_px, float half_px, float cell_px, const EdgeDistance& edge);

  /// Takes the piece out of the free area.
  void add(const ContactPiece& piece);

  /// Distance to the boundary of the free area, positive in the hole, at most kFar_px. It is less than that beyond the
  /// end of a piece's field. Beyond the raster: the value at the nearest point of the raster.
  FieldSample at(Vec2 p) const;
  float cell_px() const { return cell_px_; }

  /// The free area within `reach_px` of the centre.
  float free_px2(float reach_px) const;
  std::vector<RimPoint> rim(float reach_px) const;

 private:
  static constexpr float kFar_px = 40;

  Vec2 node(int i, int j) const { return origin_ + Vec2{float(i), float(j)} * cell_px_; }

  Vec2 centre_;
  Vec2 origin_;
  float cell_px_;
  Grid<float> distance_;
};

}  // namespace tessera
