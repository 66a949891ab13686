#include "core/recognition/query_arcs.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

/// The shortest arc, in widths of the query's narrowest smoothing: shorter ones have lost their shape.
constexpr float kShortestWidths = 6;
/// Distance of arcs' starts, as a fraction of their length. It is larger if more than kMostOfLength arcs of a length
/// would be looked up.
constexpr float kStartSpacing = 1.f / 8;
constexpr float kMostOfLength = 10;
/// Each curve has at least this number of starts: a shape seen between bars is many short curves.
constexpr float kLeastArcsOfCurve = 8;

/// An arc whose points lie within this fraction of its length from a line is useless: many shapes have a straight side.
constexpr float kStraight = 0.015f;

bool is_straight(const ArcSignature& signature) {
  for (std::size_t i = 1; i < signature.size(); i += 2) {
    if (std::abs(signature[i] - 0.5f) > kStraight) return false;
  }
  return true;
}

/// The point at an arclength of an evenly spaced curve.
class EvenCurve {
 public:
  explicit EvenCurve(const Curve& curve)
      : curve_(curve),
        length_(length_of(curve)),
        spacing_(length_ / float(curve.points.size() - (curve.closed ? 0 : 1))) {}

  float length() const { return length_; }
  Vec2 at(float along) const {
    const float place = along / spacing_;
    const auto before = std::size_t(place);
    const float part = place - float(before);
    return point(before) * (1 - part) + point(before + 1) * part;
  }

 private:
  Vec2 point(std::size_t i) const {
    const std::size_t count = curve_.points.size();
    return curve_.points[curve_.closed ? i % count : std::min(i, count - 1)];
  }

  const Curve& curve_;
  float length_;
  float spacing_;
};

void add_arcs(const EvenCurve& curve, bool closed, float length, float spacing, std::vector<QueryArc>& arcs) {
  // A closed curve has an arc at every start. On an open curve the first arc begins and the last one ends with the
  // curve.
  const float room = closed ? curve.length() : curve.length() - length;
  const int gaps = std::max(1, int(room / spacing));
  for (int k = 0; k < (closed ? gaps : gaps + 1); ++k) {
    const float start = room * float(k) / float(gaps);
    QueryArc arc{length, {}, {}};
    for (std::size_t i = 0; i < kArcPoints; ++i) arc.points[i] = curve.at(start + length * float(i) / (kArcPoints - 1));
    const std::optional<ArcSignature> signature = arc_signature(arc.points, length);
    if (!signature || is_straight(*signature)) continue;
    arc.signature = *signature;
    arcs.push_back(arc);
  }
}

}  // namespace

std::vector<QueryArc> query_arcs(const Query& query, float unit, float step) {
  std::vector<QueryArc> arcs;
  const float shortest = kShortestWidths * query.least_sigma();
  for (const Curve& curve : query.narrow_curves()) {
    const EvenCurve even(curve);
    const float longest = curve.closed ? kLongestOfClosed * even.length() : even.length();
    const float first = unit * std::pow(step, std::ceil(std::log(shortest / unit) / std::log(step)));
    for (float length = first; length <= longest; length *= step) {
      const float apart = std::min(query.length() / kMostOfLength, even.length() / kLeastArcsOfCurve);
      add_arcs(even, curve.closed, length, std::max(kStartSpacing * length, apart), arcs);
    }
  }
  return arcs;
}

}  // namespace tessera
