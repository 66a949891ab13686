#include "core/recognition/recognition.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "core/base/rank_pool.h"
#include "core/recognition/arc_poses.h"
#include "core/recognition/curve_points.h"
#include "core/recognition/pad_poses.h"

namespace tessera {
namespace {

/// Number of poses that are refined with the model's boundary: in all, and for each shape.
constexpr std::size_t kMostRefined = 300;
constexpr std::size_t kMostOfShape = 3;
constexpr int kRefineSteps = 6;
constexpr float kRefineReach = 0.15f;  // of the query's radius, falling to
constexpr float kRefinedReach = 0.03f;
/// Number of shapes that are compared with their whole outlines. Reach in widths of the query's narrowest smoothing.
constexpr std::size_t kMostCompared = 40;
constexpr int kCompareSteps = 4;
constexpr float kCompareReach = 2;
constexpr float kComparedReach = 1;

/// The number of poses in one task: for the fast estimate, and for refinement.
constexpr std::size_t kPortion = 1024;
constexpr std::size_t kRefinedPortion = 16;

BoundaryPoints model_points(const ShapeModel& model) {
  return {model.boundary, model.tangent, model.perimeter / kBoundaryPoints};
}

void sort_by_followed(std::vector<PosedShape>& posed) {
  std::stable_sort(posed.begin(), posed.end(),
                   [](const PosedShape& a, const PosedShape& b) { return a.followed > b.followed; });
}

/// The first different poses of each shape, at most kMostOfShape for each and kMostRefined in all.
std::vector<PosedShape> first_of_each(const Query& query, const std::vector<PosedShape>& posed) {
  std::vector<PosedShape> chosen;
  std::unordered_map<std::uint32_t, std::vector<Similarity>> of_shape;
  for (const PosedShape& p : posed) {
    if (chosen.size() == kMostRefined) break;
    std::vector<Similarity>& others = of_shape[p.shape];
    if (others.size() == kMostOfShape || is_near_any_pose(others, p.query_from_shape, query)) continue;
    others.push_back(p.query_from_shape);
    chosen.push_back(p);
  }
  return chosen;
}

PosedShape refined(const Query& query, const KnownShapes& shapes, const PosedShape& start,
                   const PossibleScales& scales) {
  const BoundaryPoints points = model_points(shapes.model(start.shape));
  const float least_reach = std::max(kCompareReach * query.least_sigma(), kRefinedReach * query.radius());
  const Similarity pose =
      refined_pose(query, points, start.query_from_shape, kRefineSteps, kRefineReach * query.radius(), least_reach,
                   scales.near(start.shape, start.query_from_shape));
  return {start.shape, pose, followed_part(query, points, pose)};
}

/// Keeps only the first pose of each shape.
void keep_first_of_each(std::vector<PosedShape>& posed) {
  std::unordered_set<std::uint32_t> seen;
  std::erase_if(posed, [&](const PosedShape& p) { return !seen.insert(p.shape).second; });
}

CurvePoints outline_points(const Outline& outline) {
  std::vector<Curve> curves;
  for (const std::vector<Vec2>& points : outline.curves) curves.push_back({points, true});
  return CurvePoints(curves);
}

/// Fits the whole outline of a shape to the query, and measures the fraction of the query that it follows.
Recognition compared(const Query& query, const KnownShapes& shapes, const PosedShape& posed,
                     const PossibleScales& scales, const OutlineOf& outline_of) {
  const ShapeId id = shapes.id(posed.shape);
  const CurvePoints points = outline_points(outline_of(id));
  const Similarity pose =
      refined_pose(query, points.boundary(), posed.query_from_shape, kCompareSteps, kCompareReach * query.least_sigma(),
                   kComparedReach * query.least_sigma(), scales.near(posed.shape, posed.query_from_shape));
  return {id, pose, followed_part(query, points.boundary(), pose), query.length()};
}

/// The answers for the query's curves without removing noise; each compared shape once.
std::vector<Recognition> recognised_as_it_is(const Query& query, const KnownShapes& shapes,
                                             const RecognitionSettings& settings, const OutlineOf& outline_of) {
  const PossibleScales scales(query, shapes, settings.query_per_drawn_px);
  std::vector<PosedShape> posed = pad_poses(query, shapes, scales);
  for (const PosedShape& p : arc_poses(query, shapes, scales)) posed.push_back(p);
  parallel_for_portions(posed.size(), kPortion, [&](std::size_t i) {
    posed[i].followed = roughly_followed(query, model_points(shapes.model(posed[i].shape)), posed[i].query_from_shape);
  });
  sort_by_followed(posed);
  posed = first_of_each(query, posed);
  parallel_for_portions(posed.size(), kRefinedPortion,
                        [&](std::size_t i) { posed[i] = refined(query, shapes, posed[i], scales); });
  sort_by_followed(posed);
  keep_first_of_each(posed);
  posed.resize(std::min(posed.size(), std::max(kMostCompared, 2 * settings.most)));
  std::vector<Recognition> result;
  for (const PosedShape& p : posed) result.push_back(compared(query, shapes, p, scales, outline_of));
  return result;
}

}  // namespace

std::vector<Recognition> best_of_each(std::vector<Recognition> found) {
  std::sort(found.begin(), found.end());
  std::unordered_set<std::size_t> seen;
  std::erase_if(found, [&](const Recognition& r) { return !seen.insert(index_of(r.shape)).second; });
  return found;
}

std::vector<Recognition> recognised(const Query& query, const KnownShapes& shapes, const RecognitionSettings& settings,
                                    const OutlineOf& outline_of) {
  if (shapes.size() == 0) return {};
  std::vector<Recognition> found = recognised_as_it_is(query, shapes, settings, outline_of);
  if (query.without_noise()) {
    const auto more = recognised_as_it_is(*query.without_noise(), shapes, settings, outline_of);
    found.insert(found.end(), more.begin(), more.end());
  }
  found = best_of_each(std::move(found));
  if (found.size() > settings.most) found.resize(settings.most);
  return found;
}

}  // namespace tessera
