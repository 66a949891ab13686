#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/descriptors/boundary_points.h"
#include "bench/descriptors/shape_descriptor.h"

namespace tessera::bench {
namespace {

constexpr int kScalePoints = 200;  // as in the paper
/// Maxima below this part of the highest one are noise (a sixth in the paper), and those below this width in points.
constexpr float kLeastHeight = 1.f / 6;
constexpr float kLeastWidth = 3;
/// Smoothing ends at this width in points, where the curve would be an ellipse.
constexpr float kMostWidth = 80;
/// Largest distance along the curve between matched maxima.
constexpr float kNearAlong = 0.2f;
/// Curves are aligned by their highest maxima, and by those of at least this part of the highest.
constexpr float kAligned = 0.8f;

/// A maximum of the curvature scale space image: the place along the curve, 0 to 1, and the width of the Gaussian
/// relative to the curve's length, at which two zero crossings of the curvature meet.
struct ScaleMaximum {
  float along;
  float height;
};

/// A point in double precision, for thousands of steps of smoothing.
using FinePoint = Eigen::Vector2d;

/// The points about their centroid.
std::vector<FinePoint> fine_points(const std::vector<Vec2>& points) {
  std::vector<FinePoint> result;
  FinePoint sum(0, 0);
  for (const Vec2 p : points) sum += FinePoint(p.x, p.y);
  for (const Vec2 p : points) result.emplace_back(FinePoint(p.x, p.y) - sum / double(points.size()));
  return result;
}

/// The points of a closed curve after one step of smoothing, approximately a Gaussian of variance 1/2.
std::vector<FinePoint> smoothed_a_step(const std::vector<FinePoint>& points) {
  const std::size_t count = points.size();
  std::vector<FinePoint> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = points[i] * 0.5 + (points[(i + 1) % count] + points[(i + count - 1) % count]) * 0.25;
  }
  return result;
}

/// Indices of the points where the curvature changes its sign.
std::vector<int> zero_crossings(const std::vector<FinePoint>& points) {
  const std::size_t count = points.size();
  std::vector<int> crossings;
  const auto convex = [&](std::size_t i) {
    const FinePoint before = points[i % count] - points[(i + count - 1) % count];
    const FinePoint after = points[(i + 1) % count] - points[i % count];
    return before.x() * after.y() - before.y() * after.x() >= 0;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (convex(i) != convex(i + 1)) crossings.push_back(int(i));
  }
  return crossings;
}

/// Removes the two closest neighbouring crossings from the list, and returns the point between them.
float closest_pair(std::vector<int>& crossings) {
  const std::size_t count = crossings.size();
  std::size_t at = 0;
  int closest = kScalePoints + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const int gap = (crossings[(i + 1) % count] - crossings[i] + kScalePoints) % kScalePoints;
    if (gap >= closest) continue;
    closest = gap;
    at = i;
  }
  const float middle = float(crossings[at]) + 0.5f * float(closest);
  const std::size_t next = (at + 1) % count;
  crossings.erase(crossings.begin() + std::ptrdiff_t(std::max(at, next)));
  crossings.erase(crossings.begin() + std::ptrdiff_t(std::min(at, next)));
  return std::fmod(middle, float(kScalePoints));
}

std::vector<ScaleMaximum> scale_maxima(std::vector<FinePoint> points) {
  std::vector<ScaleMaximum> maxima;
  std::vector<int> crossings = zero_crossings(points);
  float width = 0;
  for (int step = 1; !crossings.empty() && width < kMostWidth; ++step) {
    points = smoothed_a_step(points);
    width = std::sqrt(0.5f * float(step));
    std::vector<int> left = zero_crossings(points);
    while (crossings.size() >= left.size() + 2) {
      maxima.push_back({closest_pair(crossings) / kScalePoints, width / kScalePoints});
    }
    crossings = std::move(left);
  }
  return maxima;
}

/// The way from one place to another along the closed curve, from -1/2 to 1/2.
float way_along(float from, float to) { return to - from - std::round(to - from); }

/// The cost of matching: distances of matched maxima plus heights of unmatched ones, with the query shifted by `shift`.
/// Both lists have the highest first.
float matching_cost(const std::vector<ScaleMaximum>& query, std::vector<ScaleMaximum> known, float shift) {
  float cost = 0;
  for (const ScaleMaximum& q : query) {
    std::size_t best = known.size();
    float least = q.height;
    for (std::size_t k = 0; k < known.size(); ++k) {
      const float along = way_along(q.along + shift, known[k].along);
      const float away = std::hypot(along, known[k].height - q.height);
      if (std::abs(along) > kNearAlong || away >= least) continue;
      least = away;
      best = k;
    }
    cost += least;
    if (best < known.size()) known.erase(known.begin() + std::ptrdiff_t(best));
  }
  for (const ScaleMaximum& k : known) cost += k.height;
  return cost;
}

std::vector<ScaleMaximum> maxima_of(const Description& description) {
  std::vector<ScaleMaximum> maxima;
  for (std::size_t i = 0; i + 1 < description.size(); i += 2) maxima.push_back({description[i], description[i + 1]});
  return maxima;
}

class CurvatureScaleSpace : public ShapeDescriptor {
 public:
  std::string name() const override { return "curvature-scale-space"; }

  /// Places and heights of the maxima above the noise, the highest first. A convex curve has none.
  Description describe(const std::vector<Curve>& curves, float) const override {
    std::vector<ScaleMaximum> maxima =
        scale_maxima(fine_points(resampled(closed_boundary(curves), kScalePoints).points));
    std::stable_sort(maxima.begin(), maxima.end(),
                     [](const ScaleMaximum& a, const ScaleMaximum& b) { return a.height > b.height; });
    Description description;
    for (const ScaleMaximum& m : maxima) {
      if (m.height < std::max(kLeastHeight * maxima.front().height, kLeastWidth / kScalePoints)) break;
      description.push_back(m.along);
      description.push_back(m.height);
    }
    return description;
  }

  float distance(const Description& query, const Description& known) const override {
    const std::vector<ScaleMaximum> ours = maxima_of(query), theirs = maxima_of(known);
    float least = std::numeric_limits<float>::infinity();
    for (const ScaleMaximum& q : ours) {
      if (q.height < kAligned * ours.front().height) break;
      for (const ScaleMaximum& k : theirs) {
        if (k.height < kAligned * theirs.front().height) break;
        least = std::min(least, matching_cost(ours, theirs, k.along - q.along));
      }
    }
    return std::isinf(least) ? matching_cost(ours, theirs, 0) : least;
  }
};

}  // namespace

std::unique_ptr<ShapeDescriptor> make_curvature_scale_space() { return std::make_unique<CurvatureScaleSpace>(); }

}  // namespace tessera::bench
