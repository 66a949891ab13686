// What candidates are worth to the collage as it is: the objective, less the cost of repetition (paper section 4).
#pragma once

#include <cstdint>
#include <vector>

#include "core/collage/placement.h"
#include "core/collage/pool.h"
#include "core/geometry/period.h"
#include "core/matching/stances.h"
#include "core/matching/use_limits.h"
#include "core/settings/settings.h"
#include "master/rules/neighbour_colours.h"

namespace tessera::master {

class Scoring {
 public:
  /// `silhouettes`: for each shape of the library the first one with its silhouette; empty: each is its own. Shapes of
  /// one silhouette repeat each other. `period` is that of the canvas: copies across a seam are near, too. `drawings`:
  /// for each shape the one that it is the mirror image of, mostly itself; empty: there are no mirror images. Uses are
  /// those of the drawing, however it stands.
  Scoring(const CollageSettings& settings, const StanceTable& stances, std::vector<ShapeId> silhouettes = {},
          const Period& period = {}, std::vector<ShapeId> drawings = {});

  /// A piece of this placement stands from now on.
  void count(const Placement& placement);
  void forget_placements();

  /// Whether it matters at all how often a shape stands.
  bool limits_uses() const { return uses_.any(); }
  /// Whether at one pose they cover the same: a silhouette in other colours does, its mirror image does not.
  bool look_alike(ShapeId a, ShapeId b) const {
    return silhouette(a) == silhouette(b) && is_mirror_image(a) == is_mirror_image(b);
  }
  /// Whether another one of the shape may stand.
  bool may_use(ShapeId shape) const;
  /// How many of the shape are wanted at least.
  int least_uses(ShapeId shape) const { return uses_.least(shape); }
  /// How many fewer of the shape stand than are wanted at least.
  int missing_uses(ShapeId shape) const;
  /// Those that may not stand for the moment, ascending: where some are `missing`, ascending, all
  /// others.
  std::vector<ShapeId> closed_shapes(const std::vector<ShapeId>& missing) const;
  /// The objective of the candidate's terms, times the weight that is wished for and what its colours are worth there.
  float score(const Candidate& candidate) const;
  /// The part (0..1) of its score that is left to a candidate by what stands already: the smaller, the more there are of
  /// its silhouette, above all close by and in the same colours, and the less its neighbours' colours are welcome. It
  /// falls as pieces are placed, and never rises but by forget_placements().
  float preference(const Candidate& candidate) const;

 private:
  struct Placed {
    ShapeId shape;
    Similarity canvas_from_shape;
  };
  float of_repetition(const Candidate& candidate) const;
  std::uint32_t silhouette(ShapeId shape) const { return index_of(silhouettes_[index_of(shape)]); }
  ShapeId drawing(ShapeId shape) const { return drawings_[index_of(shape)]; }
  bool is_mirror_image(ShapeId shape) const { return drawing(shape) != shape; }
  bool same_drawing(ShapeId a, ShapeId b) const { return drawing(a) == drawing(b); }
  int uses_of(ShapeId shape) const;

  PieceSettings pieces_;
  UseLimits uses_;
  std::vector<float> weight_;  // by stance
  ObjectiveSettings objective_;
  ColourWish colour_;
  NeighbourColours neighbours_;
  Period period_;
  std::vector<ShapeId> silhouettes_;
  std::vector<ShapeId> drawings_;
  std::vector<std::vector<Placed>> placed_;  // per silhouette
};

}  // namespace tessera::master
