#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bench/descriptors/boundary_points.h"
#include "bench/descriptors/shape_descriptor.h"
#include "core/geometry/polygon.h"

namespace tessera::bench {
namespace {

constexpr int kInvariantPoints = 96;
/// Points for each curve.
constexpr int kRegionPoints = 200;
/// Radii of the discs, relative to the unit or to the square root of the shape's area.
constexpr std::array<float, 4> kDiscRadii = {0.08f, 0.16f, 0.32f, 0.64f};

/// Twice the signed area of the sector of the unit disc between two directions.
float sector(Vec2 a, Vec2 b) { return std::atan2(cross(a, b), dot(a, b)); }

/// Twice the signed area of the intersection of the unit disc with the triangle of its centre, a and b.
float twice_area_in_disc(Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const float squared = dot(along, along);
  if (squared == 0) return 0;
  // The line from a to b crosses the circle at these fractions of its length.
  const float middle = -dot(a, along) / squared;
  const float inside = middle * middle - (dot(a, a) - 1) / squared;
  if (inside <= 0) return sector(a, b);
  const float half = std::sqrt(inside);
  const float enters = std::clamp(middle - half, 0.f, 1.f);
  const float leaves = std::clamp(middle + half, 0.f, 1.f);
  if (enters >= leaves) return sector(a, b);
  const Vec2 p = a + along * enters;
  const Vec2 q = a + along * leaves;
  return (enters > 0 ? sector(a, p) : 0) + cross(p, q) + (leaves < 1 ? sector(q, b) : 0);
}

/// The part of the disc that is within the curves. A straight line closes an arc.
float part_of_disc(const std::vector<Curve>& curves, Vec2 centre, float radius) {
  float twice_area = 0;
  for (const Curve& curve : curves) {
    Vec2 before = (curve.points.back() - centre) * (1 / radius);
    for (const Vec2 point : curve.points) {
      const Vec2 p = (point - centre) * (1 / radius);
      twice_area += twice_area_in_disc(before, p);
      before = p;
    }
  }
  return twice_area / (2 * std::numbers::pi_v<float>);
}

float square_root_of_area(const std::vector<Curve>& curves) {
  double area = 0;
  for (const Curve& curve : curves) area += signed_area(curve.points);
  const float length = length_of_all(curves);
  return std::max(float(std::sqrt(std::max(area, 0.))), 0.01f * length);
}

class IntegralInvariants : public ShapeDescriptor {
 public:
  std::string name() const override { return "integral-invariants"; }

  /// One row for each point: the part of each disc round it that is inside; 1/2 where the boundary is straight.
  Description describe(const std::vector<Curve>& curves, float unit) const override {
    const float one = unit > 0 ? unit : square_root_of_area(curves);
    std::vector<Curve> region;
    for (const Curve& curve : curves) region.push_back(resampled(curve, kRegionPoints));
    Description parts;
    for (const Vec2 p : even_points(region, kInvariantPoints).position) {
      for (const float radius : kDiscRadii) parts.push_back(part_of_disc(region, p, radius * one));
    }
    return parts;
  }

  /// The distance with the best ordered correspondence of points, as in section 4 of the paper.
  float distance(const Description& query, const Description& known) const override {
    return warped_difference(query, known, kDiscRadii.size());
  }
};

}  // namespace

std::unique_ptr<ShapeDescriptor> make_integral_invariants() { return std::make_unique<IntegralInvariants>(); }

}  // namespace tessera::bench
