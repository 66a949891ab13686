// Distances that pieces keep from their like: from pieces of the same silhouette (pieces.apart_px), or of the shapes that a
// wish names together. Pieces also keep away from places where their like was taken out.
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

/// Measures distances between outlines, because these are what is seen. It compares points along each outline and adds half
/// of their spacing: pieces are as far apart as wished for, or farther by a 200th of the outline.
class KeptApart {
 public:
  /// `shapes` outlives it. `period` is that of the canvas: the distance is kept across a seam, too.
  KeptApart(const CollageSettings& settings, ShapeSource& shapes, const Period& period);

  /// Whether there is any rule: pieces keep a distance, or do not come back to where they lay.
  bool matters() const { return matters_; }
  /// Whether pieces of this shape keep a distance from their like.
  bool concerns(ShapeId shape) const { return distance_px(shape) > 0; }
  float distance_px(ShapeId shape) const { return company_of(shape).distance_px; }

  /// Whether pieces of these two shapes keep a distance from each other.
  bool are_like(ShapeId a, ShapeId b) const { return company_of(a).key() == company_of(b).key(); }

  void add(const Placement& placement);
  void forget_placements() { placed_.clear(); }

  /// Whether a piece may stand there beside the added ones and does not come back to where its like lay (Wishes::not_back).
  /// It reads the shape only near its like. `radius`: of the shape, in shape units.
  bool may_stand(ShapeId shape, const Similarity& canvas_from_shape, float radius);

  /// Whether `holds` is true for any point of a boundary, canvas px. Few points are asked about in most cases.
  using AnyPoint = std::function<bool(const std::function<bool(Vec2)>& holds)>;
  /// The shapes below `shapes` that could stand at none of the boundary's points, ascending, because all points are too
  /// near to pieces that were added. Matching need not look for them.
  std::vector<ShapeId> shut_out(std::uint32_t shapes, const AnyPoint& any_point) const;

 private:
  struct Company {
    bool wished = false;  // a wish names them together; otherwise they share a silhouette
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
  static bool any_points_nearer(float reach_px, const Boundary& a, const Boundary& b, Vec2 b_moved_by);
  bool any_beyond(float distance_px, const std::vector<Boundary>& pieces, const AnyPoint& any_point) const;

  float job_distance_px_;
  bool matters_;
  Wishes wishes_;
  ShapeSource& shapes_;
  Period period_;
  std::map<ShapeId, std::vector<Similarity>> not_back_;                     // former poses, by silhouette
  std::map<std::pair<bool, std::uint32_t>, std::vector<Boundary>> placed_;  // by company
};

/// The placements that keep the distances from their like among the placements before them, and do not come back to where
/// their like lay. The first `given` stand in any case. `period` is that of the canvas.
std::vector<Placement> without_pieces_near_like(const std::vector<Placement>& placements, std::size_t given,
                                                const CollageSettings& settings, ShapeSource& shapes,
                                                const Period& period);

}  // namespace tessera::master
