// A hole between pieces: what is free there, as a raster, and the rim that pieces dock to. Canvas px.
#pragma once

#include <vector>

#include "core/relax/contacts.h"

namespace tessera {

/// A point beside what surrounds the hole.
struct RimPoint {
  Vec2 at;
  Vec2 inward;        // unit, into the hole
  float room_px = 0;  // free way from here inward
};

class Hole {
 public:
  /// A square round `centre_px`, free but for what lies outside the canvas.
  Hole(Vec2 centre_px, float half_px, float cell_px, const EdgeDistance& edge);

  /// Takes the piece out of what is free.
  void add(const LaidPiece& piece);

  /// Distance to what is not free, positive in the hole, no more than kFar_px; less than that far from a piece, where
  /// its shape's field ends. Beyond the raster that of its nearest point.
  FieldSample at(Vec2 p) const;
  float cell_px() const { return cell_px_; }

  /// Of what is free within `reach_px` of the centre.
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
