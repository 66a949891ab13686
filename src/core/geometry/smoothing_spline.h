// Periodic cubic smoothing B-splines: closed curves without the raster's stairs.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// A closed uniform cubic B-spline. The parameter t runs from 0 to spans() once around; the curve is twice continuously
/// differentiable.
class ClosedSpline {
 public:
  /// One control point per span, at least 4.
  explicit ClosedSpline(Eigen::Matrix2Xd control);

  int spans() const { return int(control_.cols()); }
  Vec2 position(double t) const { return combine(t, 0); }
  Vec2 first_derivative(double t) const { return combine(t, 1); }
  Vec2 second_derivative(double t) const { return combine(t, 2); }
  /// Signed curvature, 1 / unit of length; positive where the curve turns left (an outer curve is convex there).
  double curvature(double t) const;

  double length() const { return length_until_.back(); }
  /// `count` points of even arclength, the first at t = 0.
  std::vector<Vec2> even_points(int count) const;

 private:
  Vec2 combine(double t, int derivative) const;
  double parameter_at(double length, std::size_t& cursor) const;

  Eigen::Matrix2Xd control_;
  std::vector<double> length_until_;  // at every 1/kLengthSteps of a span
};

/// The spline with control points at even arclength that minimises
///   sum over its knots of |S - polygon|²  +  lambda · integral of |S''|².
/// lambda is chosen so that a ripple is damped as by a Gaussian of width `sigma` along the curve (equal at half
/// height). Coarser features stay, which a Gaussian would shrink. Knots are min(sigma, 1) units of length apart, but
/// there are at least 16. `polygon` is closed, with at least 3 points and a positive length.
ClosedSpline smoothing_spline(const std::vector<Vec2>& polygon, double sigma);

}  // namespace tessera
