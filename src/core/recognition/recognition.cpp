#include "core/recognition/recognition.h"

#include <algorithm>
#include <unordered_map>

#include "core/recognition/curve_points.h"
#include "core/recognition/pose_search.h"

namespace tessera {
namespace {

/// Poses that are made better with the model's boundary: so many in all, and of a shape.
constexpr std::size_t kMostRefined = 300;
constexpr std::size_t kMostOfShape = 3;
constexpr int kRefineSteps = 6;
constexpr float kRefineReach = 0.15f;  // of the query's radius, falling to
constexpr float kRefinedReach = 0.03f;
/// Shapes that are compared with their whole outlines. Reach: widths of the query's narrowest smoothing.
constexpr std::size_t kMostCompared = 40;
constexpr int kCompareSteps = 4;
constexpr float kCompareReach = 2;
constexpr float kComparedReach = 1;

BoundaryPoints model_points(const ShapeModel& model) {
  return {model.boundary, model.tangent, model.perimeter / kBoundaryPoints};
}

void sort_by_followed(std::vector<PosedShape>& posed) {
  std::stable_sort(posed.begin(), posed.end(),
                   [](const PosedShape& a, const PosedShape& b) { return a.followed > b.followed; });
}

/// The first poses of each shape that differ, made better; the best one of each.
std::vector<PosedShape> refined(const Query& query, const KnownShapes& shapes, const std::vector<PosedShape>& posed,
                                const RecognitionSettings& settings) {
  std::vector<PosedShape> best;
  struct OfShape {
    std::size_t place;  // in best
    std::vector<Similarity> tried;
  };
  std::unordered_map<std::uint32_t, OfShape> of_shape;
  std::size_t tried = 0;
  for (const PosedShape& start : posed) {
    if (tried == kMostRefined) break;
    const auto [at, is_new] = of_shape.try_emplace(start.shape, OfShape{best.size(), {}});
    std::vector<Similarity>& others = at->second.tried;
    if (others.size() == kMostOfShape || is_nearly_one_of(others, start.query_from_shape, query)) continue;
    others.push_back(start.query_from_shape);
    ++tried;
    const BoundaryPoints points = model_points(shapes.model(start.shape));
    PosedShape result = start;
    const float least_reach = std::max(kCompareReach * query.least_sigma(), kRefinedReach * query.radius());
    result.query_from_shape =
        refined_pose(query, points, start.query_from_shape, kRefineSteps, kRefineReach * query.radius(), least_reach,
                     scale_limits(shapes, start, settings.query_per_drawn_px));
    result.followed = followed_part(query, points, result.query_from_shape);
    if (is_new) {
      best.push_back(result);
    } else if (result.followed > best[at->second.place].followed) {
      best[at->second.place] = result;
    }
  }
  return best;
}

CurvePoints outline_points(const Outline& outline) {
  std::vector<Curve> curves;
  for (const std::vector<Vec2>& points : outline.curves) curves.push_back({points, true});
  return CurvePoints(curves);
}

}  // namespace

std::vector<Recognition> recognised(const Query& query, const KnownShapes& shapes, const RecognitionSettings& settings,
                                    const OutlineOf& outline_of) {
  std::vector<PosedShape> posed = posed_shapes(query, shapes, settings.query_per_drawn_px);
  for (PosedShape& p : posed)
    p.followed = roughly_followed(query, model_points(shapes.model(p.shape)), p.query_from_shape);
  sort_by_followed(posed);
  posed = refined(query, shapes, posed, settings);
  sort_by_followed(posed);
  posed.resize(std::min(posed.size(), std::max(kMostCompared, 2 * settings.most)));
  std::vector<Recognition> result;
  for (const PosedShape& p : posed) {
    const CurvePoints points = outline_points(outline_of(shapes.id(p.shape)));
    const Similarity pose =
        refined_pose(query, points.boundary(), p.query_from_shape, kCompareSteps, kCompareReach * query.least_sigma(),
                     kComparedReach * query.least_sigma(), scale_limits(shapes, p, settings.query_per_drawn_px));
    result.push_back({shapes.id(p.shape), pose, followed_part(query, points.boundary(), pose)});
  }
  std::sort(result.begin(), result.end());
  if (result.size() > settings.most) result.resize(settings.most);
  return result;
}

}  // namespace tessera
