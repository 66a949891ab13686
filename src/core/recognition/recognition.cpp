#include "core/recognition/recognition.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "core/base/rank_pool.h"
#include "core/recognition/pose_search.h"

namespace tessera {
namespace {

/// Distance up to which a pose counts at first, in parts of the query's radius, and how many points of the shape are tried
/// on the query's length.
constexpr float kRoughReach = 0.12f;
constexpr float kRoughPoints = 24;
constexpr int kMostStride = 6;
constexpr float kRoughCosine = 0.5f;

/// Poses that are made better with the model's boundary: so many in all, and of a shape.
constexpr std::size_t kMostRefined = 300;
constexpr std::size_t kMostOfShape = 3;
constexpr float kSamePose = 0.1f;  // of the query's radius: poses that differ by less end up as one
constexpr int kRefineSteps = 6;
constexpr float kRefineReach = 0.15f;  // of the query's radius, falling to
constexpr float kRefinedReach = 0.03f;
/// Shapes that are compared with their whole outlines. Reach: widths of the query's narrowest smoothing.
constexpr std::size_t kMostCompared = 40;
constexpr int kCompareSteps = 4;
constexpr float kCompareReach = 2;
constexpr float kComparedReach = 1;

/// Of the poses, for a task of one thread.
constexpr std::size_t kPortion = 1024;
constexpr std::size_t kRefinedPortion = 16;

/// A quick measure of how much of the query the shape follows, by some of its points.
float roughly_followed(const Query& query, const ShapeModel& model, const Similarity& query_from_shape) {
  const float reach = kRoughReach * query.radius();
  const float scale = query_from_shape.scale();
  const float spacing = model.perimeter / kBoundaryPoints * scale;
  const int stride = int(std::clamp(query.length() / (kRoughPoints * spacing), 1.f, float(kMostStride)));
  float followed = 0;
  for (int i = 0; i < kBoundaryPoints; i += stride) {
    const CurveMap::Rough near = query.map().rough(query_from_shape.apply(model.boundary[std::size_t(i)]));
    if (near.squared_distance >= reach * reach) continue;
    const Vec2 tangent = query_from_shape.apply_direction(model.tangent[std::size_t(i)]);
    if (dot(tangent, query.map().tangent(near.point)) < kRoughCosine * scale) continue;
    followed += 1 - std::sqrt(near.squared_distance) / reach;
  }
  return followed * float(stride) * spacing / query.length();
}

void sort_by_followed(std::vector<PosedShape>& posed) {
  std::stable_sort(posed.begin(), posed.end(),
                   [](const PosedShape& a, const PosedShape& b) { return a.followed > b.followed; });
}

/// Whether the pose moves no point near the query by much from where one of the others has it.
bool nearly_one_of(const std::vector<Similarity>& others, const Similarity& pose, const Query& query) {
  const Vec2 at_centre = pose.inverse().apply(query.centre());
  const float least = kSamePose * query.radius();
  return std::any_of(others.begin(), others.end(), [&](const Similarity& other) {
    const Vec2 moved = other.apply(at_centre) - query.centre();
    const float turned = norm({other.a - pose.a, other.b - pose.b}) / pose.scale() * query.radius();
    return norm(moved) < least && turned < least;
  });
}

/// The first poses of each shape that differ, so many of each and in all.
std::vector<PosedShape> first_of_each(const Query& query, const std::vector<PosedShape>& posed) {
  std::vector<PosedShape> chosen;
  std::unordered_map<std::uint32_t, std::vector<Similarity>> of_shape;
  for (const PosedShape& p : posed) {
    if (chosen.size() == kMostRefined) break;
    std::vector<Similarity>& others = of_shape[p.shape];
    if (others.size() == kMostOfShape || nearly_one_of(others, p.query_from_shape, query)) continue;
    others.push_back(p.query_from_shape);
    chosen.push_back(p);
  }
  return chosen;
}

PosedShape refined(const Query& query, const KnownShapes& shapes, const PosedShape& start,
                   const RecognitionSettings& settings) {
  const ShapeModel& model = shapes.model(start.shape);
  const BoundaryPoints points{model.boundary, model.tangent, model.perimeter / kBoundaryPoints};
  const float least_reach = std::max(kCompareReach * query.least_sigma(), kRefinedReach * query.radius());
  const Similarity pose =
      refined_pose(query, points, start.query_from_shape, kRefineSteps, kRefineReach * query.radius(), least_reach,
                   scale_limits(shapes, start, settings.query_per_drawn_px));
  return {start.shape, pose, followed_part(query, points, pose)};
}

/// Of poses in order, the first one of each shape.
void keep_first_of_each(std::vector<PosedShape>& posed) {
  std::unordered_set<std::uint32_t> seen;
  std::erase_if(posed, [&](const PosedShape& p) { return !seen.insert(p.shape).second; });
}

/// Points and tangents of all curves of an outline.
struct OutlinePoints {
  explicit OutlinePoints(const Outline& outline) {
    float length = 0;
    for (const std::vector<Vec2>& points : outline.curves) {
      const Curve curve{points, true};
      const std::vector<Vec2> tangents = tangents_of(curve);
      length += length_of(curve);
      position.insert(position.end(), points.begin(), points.end());
      tangent.insert(tangent.end(), tangents.begin(), tangents.end());
    }
    spacing = length / float(std::max<std::size_t>(position.size(), 1));
  }
  BoundaryPoints boundary() const { return {position, tangent, spacing}; }

  std::vector<Vec2> position;
  std::vector<Vec2> tangent;
  float spacing;
};

}  // namespace

std::vector<Recognition> recognised(const Query& query, const KnownShapes& shapes, const RecognitionSettings& settings,
                                    const OutlineOf& outline_of) {
  std::vector<PosedShape> posed = posed_shapes(query, shapes, settings.query_per_drawn_px);
  parallel_for_portions(posed.size(), kPortion, [&](std::size_t i) {
    posed[i].followed = roughly_followed(query, shapes.model(posed[i].shape), posed[i].query_from_shape);
  });
  sort_by_followed(posed);
  posed = first_of_each(query, posed);
  parallel_for_portions(posed.size(), kRefinedPortion,
                        [&](std::size_t i) { posed[i] = refined(query, shapes, posed[i], settings); });
  sort_by_followed(posed);
  keep_first_of_each(posed);
  posed.resize(std::min(posed.size(), std::max(kMostCompared, 2 * settings.most)));
  std::vector<Recognition> result;
  for (const PosedShape& p : posed) {
    const OutlinePoints points(outline_of(shapes.id(p.shape)));
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
