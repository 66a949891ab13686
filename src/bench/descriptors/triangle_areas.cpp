#include <algorithm>
#include <cmath>

#include "bench/descriptors/boundary_points.h"
#include "bench/descriptors/shape_descriptor.h"

namespace tessera::bench {
namespace {

// From the paper's section 4: 128 points, and triangles of all sizes below half of that.
constexpr int kTrianglePoints = 128;
constexpr int kTriangleSizes = kTrianglePoints / 2 - 1;

float triangle_area(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - b) / 2; }

class TriangleAreas : public ShapeDescriptor {
 public:
  std::string name() const override { return "triangle-areas"; }

  /// One row for each point: the areas of its triangles, positive where the boundary is convex, relative to the largest
  /// one of their size (Equation 3 of the paper).
  Description describe(const std::vector<Curve>& curves, float) const override {
    const std::vector<Vec2> points = resampled(closed_boundary(curves), kTrianglePoints).points;
    Description areas(std::size_t(kTrianglePoints) * kTriangleSizes);
    for (int size = 1; size <= kTriangleSizes; ++size) {
      float largest = 1e-12f;
      for (int i = 0; i < kTrianglePoints; ++i) {
        const auto at = [&](int k) { return points[std::size_t((i + k + kTrianglePoints) % kTrianglePoints)]; };
        float& area = areas[std::size_t(i * kTriangleSizes + size - 1)];
        area = triangle_area(at(-size), at(0), at(size));
        largest = std::max(largest, std::abs(area));
      }
      for (int i = 0; i < kTrianglePoints; ++i) areas[std::size_t(i * kTriangleSizes + size - 1)] /= largest;
    }
    return areas;
  }

  /// The paper's dynamic space warping. It may begin and end anywhere on the known shape, as the query may be a part.
  float distance(const Description& query, const Description& known) const override {
    return warped_difference(query, known, kTriangleSizes);
  }
};

}  // namespace

std::unique_ptr<ShapeDescriptor> make_triangle_areas() { return std::make_unique<TriangleAreas>(); }

}  // namespace tessera::bench
