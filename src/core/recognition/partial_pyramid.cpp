#include "core/recognition/partial_pyramid.h"

#include <algorithm>
#include <cmath>

#include "core/pad/pyramid.h"

namespace tessera {
namespace {

/// Arclength and turning along a curve. A closed curve is walked three times, so that both sides of every point of the
/// second round lie within. The turning at a vertex is spread over the halves of its two edges, as in make_pyramid().
class TurningProfile {
 public:
  TurningProfile(const Curve& curve, float sigma)
      : points_(curve.points),
        closed_(curve.closed),
        count_(int(curve.points.size())),
        margin_(curve.closed ? 0 : sigma) {
    const double dead_zone = curvature_dead_zone(sigma);
    const int vertices = closed_ ? 3 * count_ : count_;
    double along = 0;
    double turned = 0;
    for (int i = 0; i < vertices; ++i) {
      vertex_at_.push_back(along);
      if (!closed_ && i + 1 == vertices) break;
      const double edge = norm(point(i + 1) - point(i));
      if (closed_ || i > 0) {
        const double support = 0.5 * (edge + double(norm(point(i) - point(i - 1))));
        const double turning = std::abs(turning_rad(point(i - 1), point(i), point(i + 1)));
        turned += std::max(0.0, turning - dead_zone * support);
      }
      middle_at_.push_back(along + 0.5 * edge);
      turned_until_.push_back(turned);
      along += edge;
    }
    length_ = closed_ ? along / 3 : along;
  }

  PartialPyramid pyramid(int vertex, const PadParameters& pad) const;

 private:
  Vec2 point(int i) const { return points_[std::size_t((i % count_ + count_) % count_)]; }
  /// Index of the first entry that is larger than `value`.
  static std::size_t place_after(const std::vector<double>& ascending, double value) {
    return std::size_t(std::upper_bound(ascending.begin(), ascending.end(), value) - ascending.begin());
  }
  double turned_at(double along) const;
  double along_at(double turned) const;
  Vec2 point_at(double along) const;

  const std::vector<Vec2>& points_;
  bool closed_;
  int count_;
  double margin_;
  double length_ = 0;
  std::vector<double> vertex_at_;     // arclength at each vertex
  std::vector<double> middle_at_;     // arclength at the middle of each edge
  std::vector<double> turned_until_;  // |turning| from the start to the middle of each edge, rad
};

double interpolated(const std::vector<double>& x, const std::vector<double>& y, std::size_t after, double at) {
  if (after == 0) return y.front();
  if (after == x.size()) return y.back();
  const double width = x[after] - x[after - 1];
  return y[after - 1] + (width > 0 ? (at - x[after - 1]) / width : 0.0) * (y[after] - y[after - 1]);
}

double TurningProfile::turned_at(double along) const {
  return interpolated(middle_at_, turned_until_, place_after(middle_at_, along), along);
}

double TurningProfile::along_at(double turned) const {
  return interpolated(turned_until_, middle_at_, place_after(turned_until_, turned), turned);
}

Vec2 TurningProfile::point_at(double along) const {
  const std::size_t after = std::clamp<std::size_t>(place_after(vertex_at_, along), 1, vertex_at_.size() - 1);
  const Vec2 a = point(int(after) - 1);
  const Vec2 b = point(int(after));
  const double edge = vertex_at_[after] - vertex_at_[after - 1];
  return a + (b - a) * float(edge > 0 ? std::clamp((along - vertex_at_[after - 1]) / edge, 0.0, 1.0) : 0.0);
}

PartialPyramid TurningProfile::pyramid(int vertex, const PadParameters& pad) const {
  PartialPyramid result;
  ArclengthPyramid& pyramid = result.pyramid;
  const double centre = vertex_at_[std::size_t(closed_ ? count_ + vertex : vertex)];
  const double turned = turned_at(centre);
  const double first = closed_ ? centre - length_ : margin_;
  const double last = closed_ ? centre + length_ : length_ - margin_;
  const auto side = [&](int direction, std::array<float, kMaxPadLevels>& lengths) {
    int levels = 0;
    for (; levels < pad.levels; ++levels) {
      const double goal = turned + direction * double(pad.delta_tau) * double(1 << levels);
      const bool on_curve = goal > turned_until_.front() && goal < turned_until_.back();
      double along = on_curve ? along_at(goal) : direction * std::numeric_limits<double>::infinity();
      if (along < first || along > last) {
        if (!closed_) break;
        along = std::clamp(along, first, last);  // a closed curve that turns less than this: the whole curve
      }
      lengths[std::size_t(levels)] = float(std::max(std::abs(along - centre), 1e-6));
      pyramid.keypoint[std::size_t(pad.levels + direction * (levels + 1))] = point_at(along);
    }
    return levels;
  };
  pyramid.keypoint[std::size_t(pad.levels)] = points_[std::size_t(vertex)];
  result.left_levels = side(-1, pyramid.left);
  result.right_levels = side(+1, pyramid.right);
  if (result.left_levels > 0 && result.right_levels > 0) pyramid.convexity = convexity_of(pyramid, pad.levels);
  return result;
}

}  // namespace

bool has_enough_levels(const PartialPyramid& pyramid) {
  return pyramid.left_levels + pyramid.right_levels >= kLeastLevels &&
         std::min(pyramid.left_levels, pyramid.right_levels) >= kLeastLevelsOfASide;
}

std::vector<PartialPyramid> partial_pyramids(const Curve& smooth_curve, float sigma, int stride,
                                             const PadParameters& pad) {
  const TurningProfile profile(smooth_curve, sigma);
  std::vector<PartialPyramid> result;
  for (int i = 0; i < int(smooth_curve.points.size()); i += stride) result.push_back(profile.pyramid(i, pad));
  return result;
}

}  // namespace tessera
