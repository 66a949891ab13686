#include "core/shape/level_curve.h"

#include "core/geometry/closed_curve.h"
#include "core/pad/pyramid.h"

namespace tessera {
namespace {

/// A vertex of a closed curve held in a vector.
class IndexWalk {
 public:
  IndexWalk(const std::vector<Vec2>& curve, std::size_t at) : curve_(&curve), at_(at) {}
  Vec2 position() const { return (*curve_)[at_]; }
  void forward() { at_ = after(); }
  void backward() { at_ = before(); }
  float turning_rad() const { return std::abs(tessera::turning_rad(previous(), position(), next())); }
  float edge_forward() const { return norm(next() - position()); }
  float edge_backward() const { return norm(position() - previous()); }
  bool operator==(const IndexWalk& o) const { return at_ == o.at_; }

 private:
  std::size_t after() const { return at_ + 1 == curve_->size() ? 0 : at_ + 1; }
  std::size_t before() const { return at_ == 0 ? curve_->size() - 1 : at_ - 1; }
  Vec2 next() const { return (*curve_)[after()]; }
  Vec2 previous() const { return (*curve_)[before()]; }

  const std::vector<Vec2>* curve_;
  std::size_t at_;
};

}  // namespace

std::vector<ArclengthPyramid> sample_pyramids(const std::vector<Vec2>& smooth_curve, float sigma, int samples,
                                              const PadParameters& pad) {
  std::vector<ArclengthPyramid> pyramids;
  pyramids.reserve(samples);
  const std::size_t stride = smooth_curve.size() / samples;
  for (int j = 0; j < samples; ++j) {
    pyramids.push_back(make_pyramid(IndexWalk(smooth_curve, j * stride), pad, curvature_dead_zone(sigma)));
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
