#include "core/shape/level_curve.h"

#include "core/geometry/closed_curve.h"
#include "core/pad/pyramid.h"

namespace tessera {
namespace {

/// A closed curve with what a walk asks at each vertex. The walks of many samples pass the same vertices.
struct MeasuredCurve {
  std::vector<Vec2> points;
  std::vector<float> turning_rad;  // absolute
  std::vector<float> edge;         // length of the edge to the next vertex
};

MeasuredCurve measured(const std::vector<Vec2>& points) {
  const std::size_t n = points.size();
  MeasuredCurve curve{points, std::vector<float>(n), std::vector<float>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 previous = points[i == 0 ? n - 1 : i - 1], next = points[i + 1 == n ? 0 : i + 1];
    curve.turning_rad[i] = std::abs(turning_rad(previous, points[i], next));
    curve.edge[i] = norm(next - points[i]);
  }
  return curve;
}

/// A vertex of a measured curve.
class IndexWalk {
 public:
  IndexWalk(const MeasuredCurve& curve, std::size_t at) : curve_(&curve), at_(at) {}
  Vec2 position() const { return curve_->points[at_]; }
  void forward() { at_ = after(); }
  void backward() { at_ = before(); }
  float turning_rad() const { return curve_->turning_rad[at_]; }
  float edge_forward() const { return curve_->edge[at_]; }
  float edge_backward() const { return curve_->edge[before()]; }
  bool operator==(const IndexWalk& o) const { return at_ == o.at_; }

 private:
  std::size_t after() const { return at_ + 1 == curve_->points.size() ? 0 : at_ + 1; }
  std::size_t before() const { return at_ == 0 ? curve_->points.size() - 1 : at_ - 1; }

  const MeasuredCurve* curve_;
  std::size_t at_;
};

}  // namespace

std::vector<ArclengthPyramid> sample_pyramids(const std::vector<Vec2>& smooth_curve, float sigma, int samples,
                                              const PadParameters& pad) {
  std::vector<ArclengthPyramid> pyramids;
  pyramids.reserve(samples);
  const MeasuredCurve curve = measured(smooth_curve);
  const std::size_t stride = smooth_curve.size() / samples;
  for (int j = 0; j < samples; ++j) {
    pyramids.push_back(make_pyramid(IndexWalk(curve, j * stride), pad, curvature_dead_zone(sigma)));
  }
  return pyramids;
}

LevelCurve make_level_curve(const std::vector<Vec2>& outer_curve, const SmoothingLevel& level,
                            const PadParameters& pad) {
  LevelCurve result;
  result.points = resampled_closed(gaussian_smoothed(outer_curve, level.sigma), level.curve_points);
  result.perimeter = closed_length(result.points);
  result.samples = sample_pyramids(result.points, level.sigma, level.samples, pad);
  return result;
}

}  // namespace tessera
