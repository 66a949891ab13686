// Pieces that keep a distance from their like: those of one silhouette (pieces.apart_px), or those that a wish names
// together. And those that keep away from where their like lay before it was taken out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "core/collage/placement.h"
#include "core/geometry/period.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera::master {

/// Whether pieces of any shape keep a distance.
bool any_kept_apart(const CollageSettings& settings);

/// Distances are those between outlines, which is what is seen; along each outline points are compared, and half of
/// their spacing is added, so that what stands is as far apart as was wished for, or farther by a 200th of its outline.
class KeptApart {
 public:
  /// `shapes` outlives it. `period` is that of the canvas: across a seam the distance is kept, too.
  KeptApart(const CollageSettings& settings, ShapeSource& shapes, const Period& period);

  /// Whether pieces of any shape keep a distance, or do not come back to where they lay.
  bool matters() const { return matters_; }
  /// Whether pieces of this shape keep a distance at all.
  bool concerns(ShapeId shape) const { return company_of(shape).distance_px > 0; }

  /// Whether it is from each other that they keep one.
  bool are_like(ShapeId a, ShapeId b) const { return company_of(a).key() == company_of(b).key(); }

  void add(const Placement& placement);
  void forget_placements() { placed_.clear(); }

  /// Whether a piece may stand there beside those that were added, and does not come back to where its like lay
  /// (Wishes::not_back). Only near its like the shape is looked at; `radius`: its own, shape units.
  bool may_stand(ShapeId shape, const Similarity& canvas_from_shape, float radius);

  /// Says whether something holds of any point of a boundary, canvas px; mostly it is asked about few of them.
  using AnyPoint = std::function<bool(const std::function<bool(Vec2)>& holds)>;
  /// Of so many shapes those that could stand at none of these points, ascending: all of them are too near to pieces
  /// that were added. Matching need not look for them.
  std::vector<ShapeId> shut_out(std::uint32_t shapes, const AnyPoint& any_point) const;

 private:
  struct Company {
    bool wished = false;  // by name; else: of one silhouette
    std::uint32_t id = 0;
    float distance_px = 0;

    std::pair<bool, std::uint32_t> key() const { return {wished, id}; }
  };
  /// Points along a piece's outline, canvas px.
  struct Boundary {
    Vec2 centre_px;
    float radius_px = 0;  // round the centre
    float half_spacing_px = 0;
    std::vector<Vec2> points_px;
  };

  bool comes_back(ShapeId shape, const Similarity& canvas_from_shape) const;
  Company company_of(ShapeId shape) const;
  Boundary boundary_of(ShapeId shape, const Similarity& canvas_from_shape);
  bool any_beyond(float distance_px, const std::vector<Boundary>& pieces, const AnyPoint& any_point) const;

  float job_distance_px_;
  bool matters_;
  Wishes wishes_;
  ShapeSource& shapes_;
  Period period_;
  std::map<ShapeId, std::vector<Similarity>> not_back_;                     // where they lay, by silhouette
  std::map<std::pair<bool, std::uint32_t>, std::vector<Boundary>> placed_;  // by company
};

/// Those of the placements that keep the distances from their like among those before them and do not come back to
/// where their like lay, and the first `given`, which stand in any case. `period` is that of the canvas.
std::vector<Placement> without_too_near(const std::vector<Placement>& placements, std::size_t given,
                                        const CollageSettings& settings, ShapeSource& shapes, const Period& period);

}  // namespace tessera::master
