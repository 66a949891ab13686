#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bench/descriptors/boundary_points.h"
#include "bench/descriptors/shape_descriptor.h"

namespace tessera::bench {
namespace {

// From the paper's section 3.1: 5 rings from an eighth to twice the mean distance, 12 directions.
constexpr int kRings = 5;
constexpr int kDirections = 12;
constexpr int kContextBins = kRings * kDirections;
constexpr float kInnerRing = 0.125f;
constexpr float kOuterRing = 2;

float mean_distance(const std::vector<Vec2>& points) {
  float sum = 0;
  for (const Vec2 p : points) {
    for (const Vec2 q : points) sum += norm(q - p);
  }
  return sum / float(points.size() * (points.size() - 1));
}

/// The ring of a distance; rings are logarithmic. Smaller distances count for the innermost ring; larger ones give -1.
int ring_of(float distance) {
  if (distance >= kOuterRing) return -1;
  const float steps = std::log2(kOuterRing / kInnerRing) / float(kRings);
  return std::clamp(int(std::log2(distance / kInnerRing) / steps), 0, kRings - 1);
}

/// The direction relative to the tangent, so that the histogram turns with the boundary (section 3.2).
int direction_of(Vec2 to, Vec2 tangent) {
  const float turn = std::atan2(cross(tangent, to), dot(tangent, to)) / (2 * std::numbers::pi_v<float>);
  return std::min(int((turn - std::floor(turn)) * kDirections), kDirections - 1);
}

/// Half the chi-squared statistic of two histograms (Equation 1 of the paper).
float context_cost(const float* a, const float* b) {
  float sum = 0;
  for (int k = 0; k < kContextBins; ++k) {
    const float difference = a[k] - b[k];
    sum += difference * difference / (a[k] + b[k] + 1e-12f);
  }
  return sum / 2;
}

class ShapeContext : public ShapeDescriptor {
 public:
  explicit ShapeContext(int points) : points_(points) {}

  std::string name() const override { return "shape-context"; }

  /// One histogram for each point with a sum of 1, or less where points lie beyond the rings.
  Description describe(const std::vector<Curve>& curves, float unit) const override {
    const EvenPoints points = even_points(curves, points_);
    const float one = unit > 0 ? unit : mean_distance(points.position);
    Description histograms(std::size_t(points_) * kContextBins);
    for (std::size_t i = 0; i < points.position.size(); ++i) {
      float* histogram = histograms.data() + i * kContextBins;
      for (std::size_t j = 0; j < points.position.size(); ++j) {
        const Vec2 to = points.position[j] - points.position[i];
        const int ring = i == j ? -1 : ring_of(norm(to) / one);
        if (ring >= 0) histogram[ring * kDirections + direction_of(to, points.tangent[i])] += 1.f / float(points_ - 1);
      }
    }
    return histograms;
  }

  /// The shape context distance of section 4.3, with only the sum over the query's points: a hidden part of the known
  /// shape costs nothing.
  float distance(const Description& query, const Description& known) const override {
    float sum = 0;
    for (std::size_t i = 0; i < query.size(); i += kContextBins) {
      float least = std::numeric_limits<float>::infinity();
      for (std::size_t j = 0; j < known.size(); j += kContextBins) {
        least = std::min(least, context_cost(query.data() + i, known.data() + j));
      }
      sum += least;
    }
    return sum / float(points_);
  }

 private:
  int points_;
};

}  // namespace

std::unique_ptr<ShapeDescriptor> make_shape_context(int points) { return std::make_unique<ShapeContext>(points); }

}  // namespace tessera::bench
