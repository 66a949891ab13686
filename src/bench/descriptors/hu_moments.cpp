#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "bench/descriptors/shape_descriptor.h"
#include "core/geometry/polygon.h"

namespace tessera::bench {
namespace {

/// Degrees of the invariants as polynomials of the normalised moments; the roots of these degrees are comparable.
constexpr std::array<double, 7> kDegrees = {1, 2, 2, 2, 4, 3, 4};

/// Moments of the area within all curves. A straight line closes an arc: where all arcs end on one line, such as a clip
/// edge, the sum is exact.
cv::Moments moments_of(const std::vector<Curve>& curves) {
  std::array<double, 10> sums{};
  for (const Curve& curve : curves) {
    std::vector<cv::Point2f> points;
    for (const Vec2 p : curve.points) points.emplace_back(p.x, p.y);
    const cv::Moments m = cv::moments(points);  // with positive area, in either direction of the curve
    const double sign = signed_area(curve.points) < 0 ? -1 : 1;
    const std::array<double, 10> own = {m.m00, m.m10, m.m01, m.m20, m.m11, m.m02, m.m30, m.m21, m.m12, m.m03};
    for (std::size_t k = 0; k < own.size(); ++k) sums[k] += sign * own[k];
  }
  return {sums[0], sums[1], sums[2], sums[3], sums[4], sums[5], sums[6], sums[7], sums[8], sums[9]};
}

class HuMoments : public ShapeDescriptor {
 public:
  std::string name() const override { return "hu-moments"; }

  /// The seven invariants, each as the root of its degree with its sign. All 0 where the curves enclose no area.
  Description describe(const std::vector<Curve>& curves, float) const override {
    Description roots(kDegrees.size(), 0.f);
    const cv::Moments moments = moments_of(curves);
    if (!(moments.m00 > 0)) return roots;
    std::array<double, 7> invariants{};
    cv::HuMoments(moments, invariants.data());
    for (std::size_t k = 0; k < roots.size(); ++k) {
      roots[k] = float(std::copysign(std::pow(std::abs(invariants[k]), 1 / kDegrees[k]), invariants[k]));
    }
    return roots;
  }

  float distance(const Description& query, const Description& known) const override {
    float sum = 0;
    for (std::size_t k = 0; k < query.size(); ++k) sum += std::abs(query[k] - known[k]);
    return sum;
  }
};

}  // namespace

std::unique_ptr<ShapeDescriptor> make_hu_moments() { return std::make_unique<HuMoments>(); }

}  // namespace tessera::bench
