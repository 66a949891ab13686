// Growing outward (paper, Fig. 15): pieces dock to what stands, never to the canvas' edge, those near the seed first.
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
  /// The seed is what stands at first: zones of the canvas, and `standing` pieces. Where nothing does, it is the place
  /// of the first piece.
  OutwardGrowth(const Canvas& canvas, const PieceSettings& pieces, const std::vector<Placement>& standing,
                ShapeSource& shapes);

  /// Whether pieces may dock here: on the boundary of what stands. `free` is that of the canvas.
  bool may_dock(const FreeField& free, Vec2 canvas_px) const;

  /// What is left (0..1) of a candidate's score there: less the further it is from the seed.
  float nearness(Vec2 canvas_px) const;

  /// Deepest in the canvas; of places as deep, the one nearest to its middle.
  Vec2 first_piece_px() const { return first_piece_px_; }

 private:
  CanvasField zones_;  // Canvas::keep_out
  float kept_px_;      // round zones, and within the canvas' edge
  float on_edge_px_;
  float fading_px_;  // over which nearness falls to 1 / e
  Vec2 first_piece_px_;
  Grid<float> to_seed_px_;  // at every kStep-th node of the canvas
  Vec2 origin_;
};

}  // namespace tessera::master
