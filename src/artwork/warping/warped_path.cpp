#include "artwork/warping/warped_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace tessera {
namespace {

/// Most halvings of a step.
constexpr int kMostHalvings = 10;
/// Number of places at which a curve is compared with the image: two for each cell of the warp that it may cross,
/// within these limits.
constexpr int kFewestPlaces = 6, kMostPlaces = 60;

struct Cubic {
  cv::Point2d a, b, c, d;

  cv::Point2d at(double t) const {
    const double s = 1 - t;
    return a * (s * s * s) + b * (3 * s * s * t) + c * (3 * s * t * t) + d * (t * t * t);
  }
};

double length(cv::Point2d v) { return std::sqrt(v.dot(v)); }

Cubic line(cv::Point2d a, cv::Point2d d) { return {a, a + (d - a) / 3, d - (d - a) / 3, d}; }

/// The curve through the four points at parameters 0, 1/3, 2/3 and 1.
Cubic cubic_through(cv::Point2d p, cv::Point2d q, cv::Point2d r, cv::Point2d s) {
  return {p, (q * 18 - p * 5 - r * 9 + s * 2) / 6, (r * 18 - s * 5 - q * 9 + p * 2) / 6, s};
}

class PathWarper {
 public:
  PathWarper(const Warp& warp, double tolerance, std::size_t& steps_left)
      : warp_(warp),
        tolerance_(tolerance),
        steps_left_(steps_left) {}

  PathSteps warped(const PathSteps& path) {
    for (const PathStep& step : path) take(step);
    return std::move(result_);
  }

 private:
  void take(const PathStep& step) {
    const cv::Point2d from = position_;
    if (step.command == 'M') {
      start_ = step.points[0];
      add('M', {image(start_)});
    } else if (step.command == 'L') {
      add_image(line(from, step.points[0]), 0);
    } else if (step.command == 'C') {
      add_image({from, step.points[0], step.points[1], step.points[2]}, 0);
    } else {
      if (from != start_) add_image(line(from, start_), 0);
      add('Z', {});
    }
    const int count = points_of(step);
    position_ = count > 0 ? step.points[std::size_t(count - 1)] : start_;
  }

  cv::Point2d image(cv::Point2d p) const {
    const Vec2 moved = warp_.apply({float(p.x), float(p.y)});
    return {moved.x, moved.y};
  }

  void add(char command, const std::array<cv::Point2d, 3>& points) {
    if (steps_left_ == 0) throw InputError("its paths have too many steps");
    --steps_left_;
    result_.push_back({command, points});
  }

  void add_image(const Cubic& curve, int halvings) {
    const Cubic fitted =
        cubic_through(image(curve.a), image(curve.at(1 / 3.)), image(curve.at(2 / 3.)), image(curve.d));
    if (halvings == kMostHalvings || is_near_image(fitted, curve)) {
      if (is_straight(fitted)) {
        add('L', {fitted.d});
      } else {
        add('C', {fitted.b, fitted.c, fitted.d});
      }
      return;
    }
    const cv::Point2d ab = (curve.a + curve.b) / 2, bc = (curve.b + curve.c) / 2, cd = (curve.c + curve.d) / 2;
    const cv::Point2d abc = (ab + bc) / 2, bcd = (bc + cd) / 2, middle = (abc + bcd) / 2;
    add_image({curve.a, ab, abc, middle}, halvings + 1);
    add_image({middle, bcd, cd, curve.d}, halvings + 1);
  }

  bool is_near_image(const Cubic& fitted, const Cubic& curve) const {
    const double hull = length(curve.b - curve.a) + length(curve.c - curve.b) + length(curve.d - curve.c);
    const int places = int(std::clamp(2 * hull / warp_.step, double(kFewestPlaces), double(kMostPlaces)));
    for (int k = 1; k < places; ++k) {
      const double t = double(k) / places;
      if (!(length(fitted.at(t) - image(curve.at(t))) <= tolerance_)) return false;
    }
    return true;
  }

  /// Whether both control points lie at the thirds of the chord, within half the tolerance.
  bool is_straight(const Cubic& fitted) const {
    const Cubic chord = line(fitted.a, fitted.d);
    return std::max(length(fitted.b - chord.b), length(fitted.c - chord.c)) <= tolerance_ / 2;
  }

  const Warp& warp_;
  double tolerance_;
  std::size_t& steps_left_;
  PathSteps result_;
  cv::Point2d start_, position_;
};

}  // namespace

PathSteps warped_path(const PathSteps& path, const Warp& warp, double tolerance, std::size_t& steps_left) {
  return PathWarper(warp, tolerance, steps_left).warped(path);
}

}  // namespace tessera
