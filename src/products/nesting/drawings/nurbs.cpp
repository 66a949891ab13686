#include "products/nesting/drawings/nurbs.h"

#include <algorithm>
#include <array>

namespace tessera {
namespace {

double distance_to_segment(NestPoint p, NestPoint a, NestPoint b) {
  const NestPoint side = b - a;
  const double length2 = dot(side, side);
  const double along = length2 > 0 ? std::clamp(dot(p - a, side) / length2, 0.0, 1.0) : 0;
  return norm(p - a - side * along);
}

/// One span of a curve: from knot `span` to the next one.
class Span {
 public:
  Span(const Nurbs& curve, std::size_t span) : curve_(curve), span_(span) {}

  double first() const { return curve_.knots[span_]; }
  double last() const { return curve_.knots[span_ + 1]; }

  /// De Boor's algorithm, in homogeneous coordinates.
  NestPoint at(double t) const {
    const std::size_t degree = std::size_t(curve_.degree), low = span_ - degree;
    std::array<Homogeneous, kMostNurbsDegree + 1> points;
    for (std::size_t j = 0; j <= degree; ++j) {
      const double weight = curve_.weights.empty() ? 1 : curve_.weights[low + j];
      points[j] = {curve_.points[low + j] * weight, weight};
    }
    for (std::size_t level = 1; level <= degree; ++level) {
      for (std::size_t j = degree; j >= level; --j) {
        const double from = curve_.knots[low + j], to = curve_.knots[span_ + 1 + j - level];
        const double part = (t - from) / (to - from);
        points[j].at = points[j - 1].at * (1 - part) + points[j].at * part;
        points[j].weight = points[j - 1].weight * (1 - part) + points[j].weight * part;
      }
    }
    return points[degree].at * (1 / points[degree].weight);
  }

 private:
  struct Homogeneous {
    NestPoint at;  // times the weight
    double weight = 1;
  };

  const Nurbs& curve_;
  std::size_t span_;
};

struct Piece {
  double first = 0, last = 0;  // parameters
  NestPoint from, to;
};

/// Adds the points of a piece after its first one. The piece is halved until three points between its ends are near to its
/// chord. `halvings`: how often that may happen.
void add_piece(const Span& span, const Piece& piece, double flatness, int halvings, std::size_t most, NestRing& ring) {
  if (ring.size() > most) return;
  const double middle = (piece.first + piece.last) / 2;
  const NestPoint at_middle = span.at(middle);
  const auto is_off = [&](NestPoint p) { return distance_to_segment(p, piece.from, piece.to) > flatness; };
  const bool is_flat =
      !is_off(at_middle) && !is_off(span.at((piece.first + middle) / 2)) && !is_off(span.at((middle + piece.last) / 2));
  if (is_flat || halvings == 0) {
    ring.push_back(piece.to);
    return;
  }
  add_piece(span, {piece.first, middle, piece.from, at_middle}, flatness, halvings - 1, most, ring);
  add_piece(span, {middle, piece.last, at_middle, piece.to}, flatness, halvings - 1, most, ring);
}

void add_span(const Nurbs& curve, const Span& span, double flatness, std::size_t most, NestRing& ring) {
  constexpr int kMostHalvings = 12;
  // Between three samples the curve can only hide a bend if its degree is above four; then there are more steps.
  const int steps = curve.degree == 1 ? 1 : std::max(2, curve.degree - 2);
  const auto parameter = [&](int i) { return span.first() + (span.last() - span.first()) * (double(i) / steps); };
  NestPoint from = span.at(span.first());
  if (ring.empty() || ring.back() != from) ring.push_back(from);
  for (int i = 0; i < steps; ++i) {
    const double last = i + 1 == steps ? span.last() : parameter(i + 1);
    const NestPoint to = span.at(last);
    if (curve.degree == 1)
      ring.push_back(to);
    else
      add_piece(span, {parameter(i), last, from, to}, flatness, kMostHalvings, most, ring);
    from = to;
  }
}

}  // namespace

bool is_nurbs(const Nurbs& curve) {
  if (curve.degree < 1 || curve.degree > kMostNurbsDegree) return false;
  const std::size_t degree = std::size_t(curve.degree);
  if (curve.points.size() <= degree || curve.knots.size() != curve.points.size() + degree + 1) return false;
  if (!std::is_sorted(curve.knots.begin(), curve.knots.end())) return false;
  if (!(curve.knots[degree] < curve.knots[curve.points.size()])) return false;
  const bool has_weights = curve.weights.size() == curve.points.size() &&
                           std::all_of(curve.weights.begin(), curve.weights.end(), [](double w) { return w > 0; });
  return curve.weights.empty() || has_weights;
}

NestRing nurbs_outline(const Nurbs& curve, double flatness, std::size_t most) {
  // A sample may be a little nearer to the chord than the farthest point of the curve.
  constexpr double kOfSample = 0.9;
  NestRing ring;
  if (!is_nurbs(curve)) return ring;
  for (std::size_t span = std::size_t(curve.degree); span < curve.points.size() && ring.size() <= most; ++span) {
    if (curve.knots[span] < curve.knots[span + 1]) add_span(curve, Span(curve, span), kOfSample * flatness, most, ring);
  }
  return ring;
}

}  // namespace tessera
