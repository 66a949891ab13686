// Growth outward (paper, Fig. 15): pieces dock to what stands and never to the canvas' edge. Places near the seed come
// first.
#pragma once

#include <vector>

#include "core/collage/placement.h"
#include "core/field/canvas.h"
#include "core/field/free_field.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera::master {

class OutwardGrowth {
 public:
  /// The seed is the zones of the canvas and the `standing` pieces. Where there are none, it is the place of the first
  /// piece.
  OutwardGrowth(const Canvas& canvas, const PieceSettings& pieces, const std::vector<Placement>& standing,
                ShapeSource& shapes);

  /// Whether pieces may dock at this point, that is, on the boundary of what stands. `free` is that of the canvas.
  bool may_dock(const FreeField& free, Vec2 canvas_px) const;

  /// A factor (0..1) for the score of a candidate at this point: it falls with the distance from the seed.
  float nearness(Vec2 canvas_px) const;

  /// The point of the canvas that is deepest inside; of several, the one nearest to the middle.
  Vec2 first_piece_px() const { return first_piece_px_; }

 private:
  CanvasField zones_;  // Canvas::keep_out
  float kept_px_;      // px, round zones and within the canvas' edge
  float on_edge_px_;
  float fading_px_;  // px over which nearness falls to 1 / e
  Vec2 first_piece_px_;
  Grid<float> to_seed_px_;  // at every kStep-th node of the canvas
  Vec2 origin_;
};

}  // namespace tessera::master
