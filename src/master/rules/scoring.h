// The worth of candidates to the present collage: the objective, less the cost of repetition (paper section 4).
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
  /// `silhouettes`: for each shape of the library, the first shape with its silhouette; shapes of one silhouette repeat
  /// each other. Empty: each shape has its own. `drawings`: for each shape, the shape whose mirror image it is, mostly
  /// itself; uses are counted by drawing. Empty: there are no mirror images. `period` is that of the canvas: copies across
  /// a seam are near, too.
  Scoring(const CollageSettings& settings, const StanceTable& stances, std::vector<ShapeId> silhouettes = {},
          const Period& period = {}, std::vector<ShapeId> drawings = {});

  /// Adds a piece that stands from now on.
  void count(const Placement& placement);
  void forget_placements();

  /// Whether the job limits how often a shape stands.
  bool limits_uses() const { return uses_.any(); }
  /// Whether the two cover the same area at the same pose. A silhouette in other colours does, its mirror image does not.
  bool look_alike(ShapeId a, ShapeId b) const {
    return silhouette(a) == silhouette(b) && is_mirror_image(a) == is_mirror_image(b);
  }
  /// Whether one more piece of the shape may stand.
  bool may_use(ShapeId shape) const;
  /// The least number of pieces of the shape that are wanted.
  int least_uses(ShapeId shape) const { return uses_.least(shape); }
  /// The number of pieces of the shape that are missing to the least number.
  int missing_uses(ShapeId shape) const;
  /// The shapes that may not stand at the moment, ascending. Where some are `missing` (ascending), all others are closed.
  std::vector<ShapeId> closed_shapes(const std::vector<ShapeId>& missing) const;
  /// The objective of the candidate's terms, times the wished weight and what its colours are worth there.
  float score(const Candidate& candidate) const;
  /// A factor (0..1) for the score, by the pieces that stand. It is smaller the more of them share the candidate's
  /// silhouette, above all close by and in the same colours, and the less welcome its neighbours' colours are. It falls as
  /// pieces are placed, and rises only by forget_placements().
  float preference(const Candidate& candidate) const;

 private:
  /// A piece as a copy of others.
  struct Copy {
    Vec2 centre_px;
    float scale_px;
  };
  float repetition_factor(const Candidate& candidate) const;
  std::uint32_t silhouette(ShapeId shape) const { return index_of(silhouettes_[index_of(shape)]); }
  ShapeId drawing(ShapeId shape) const { return drawings_[index_of(shape)]; }
  bool is_mirror_image(ShapeId shape) const { return drawing(shape) != shape; }
  /// Pieces of this drawing alone: the same outline in other colours is another drawing.
  int uses_of(ShapeId shape) const { return uses_of_drawing_[index_of(drawing(shape))]; }

  PieceSettings pieces_;
  UseLimits uses_;
  std::vector<float> weight_;  // by stance
  ObjectiveSettings objective_;
  ColourWish colour_;
  NeighbourColours neighbours_;
  Period period_;
  std::vector<ShapeId> silhouettes_;
  std::vector<ShapeId> drawings_;
  std::vector<std::vector<Copy>> copies_;  // by silhouette
  std::vector<int> uses_of_drawing_;
};

}  // namespace tessera::master
