#include "core/recognition/arc_poses.h"

#include "core/base/rank_pool.h"
#include "core/recognition/point_fit.h"
#include "core/recognition/query_arcs.h"

namespace tessera {
namespace {

/// Largest distance of signatures, and the number of nearest arcs that are tried for each arc of the query.
constexpr float kArcReach = 0.04f;
constexpr std::size_t kMostPairs = 100;
/// Arcs whose points are farther apart do not match.
constexpr float kMostResidual = 0.15f;
/// The number of arcs in one task of a thread.
constexpr std::size_t kPortion = 8;

void look_up(const QueryArc& arc, const KnownShapes& shapes, const PossibleScales& scales,
             std::vector<PosedShape>& poses) {
  const KnownArcs& arcs = shapes.arcs();
  const auto may_have = [&](std::uint32_t place) {
    const float scale = arc.length / arcs.length_of(place);
    return scales.may_have(arcs.shape_of(place), {scale, scale});
  };
  const PadTarget target =
      arc_target(arc.signature, arc.length / scales.limits().most, arc.length / scales.limits().least);
  for (const PadHit& hit : arcs.search().nearest(target, kArcReach, kMostPairs, may_have)) {
    const std::uint32_t shape = arcs.shape_of(hit.place);
    const PointFit fit = fit_points(arcs.points_of(hit.place, shapes.model(shape)), arc.points);
    if (fit.residual <= kMostResidual) poses.push_back({shape, fit.query_from_shape, 0});
  }
}

}  // namespace

std::vector<PosedShape> arc_poses(const Query& query, const KnownShapes& shapes, const PossibleScales& scales) {
  const std::optional<float> known = scales.query_per_drawn_px();
  const std::vector<QueryArc> arcs = query_arcs(query, known.value_or(1), known ? kArcStep : kFineArcStep);
  std::vector<std::vector<PosedShape>> of_arc(arcs.size());
  parallel_for_portions(arcs.size(), kPortion, [&](std::size_t i) { look_up(arcs[i], shapes, scales, of_arc[i]); });
  std::vector<PosedShape> poses;
  for (const std::vector<PosedShape>& some : of_arc) poses.insert(poses.end(), some.begin(), some.end());
  return poses;
}

}  // namespace tessera
