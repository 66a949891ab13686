#include "products/nesting/layout/search_outline.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

bool in_triangle(NestPoint a, NestPoint b, NestPoint c, NestPoint p) {
  const double ab = turn(a, b, p), bc = turn(b, c, p), ca = turn(c, a, p);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// Whether the triangle contains no points of the ring but its own.
bool is_free(const NestRing& ring, NestPoint a, NestPoint b, NestPoint c) {
  const NestBox box = box_of({a, b, c});
  return std::none_of(ring.begin(), ring.end(), [&](NestPoint p) {
    return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y && p != a && p != b &&
           p != c && in_triangle(a, b, c, p);
  });
}

/// A way to remove a point: `b` goes, or `b` and `c` become `corner`.
struct Removal {
  double area = 0;
  bool joins = false;
  NestPoint corner;
};

/// Finds such a way: fills the dent at ring[i], or extends the corner that the side from ring[i] cuts off. False: neither
/// is possible.
bool removal_at(const NestRing& ring, std::size_t i, Removal& removal) {
  const std::size_t n = ring.size();
  const NestPoint a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n], d = ring[(i + 2) % n];
  const double at_b = turn(a, b, c);
  if (at_b == 0 && dot(b - a, c - b) < 0) return false;  // the tip of a spike
  if (at_b <= 0) {
    removal = {-at_b / 2, false, {}};
    return true;
  }
  if (turn(b, c, d) <= 0) return false;
  const double slope = cross(b - a, d - c);  // positive where the two sides meet beyond bc
  if (!(slope > 1e-9 * norm(b - a) * norm(d - c))) return false;
  const double t = cross(c - b, c - d) / cross(b - a, c - d);
  if (!(t > 0)) return false;
  removal = {0, true, b + (b - a) * t};
  removal.area = std::abs(turn(b, removal.corner, c)) / 2;
  return true;
}

bool may_go(const NestRing& ring, std::size_t i, const Removal& removal) {
  const std::size_t n = ring.size();
  const NestPoint a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
  return removal.joins ? is_free(ring, b, removal.corner, c) : is_free(ring, a, b, c);
}

NestPoint unit(NestPoint a) {
  const double length = norm(a);
  return length > 0 ? a * (1 / length) : NestPoint{};
}

NestPoint right_of(NestPoint direction) { return {direction.y, -direction.x}; }

/// Adds corners of a polygon outside the arc round `centre` from one unit direction to another; its sides touch the arc.
void add_arc(NestPoint centre, NestPoint from, NestPoint to, double radius, NestRing& out) {
  constexpr double kLeastCosine = 0.87;  // 30 degrees
  const double cosine = dot(from, to);
  if (cosine < kLeastCosine) {
    const NestPoint sum = from + to;
    const NestPoint half = norm(sum) > 1e-6 ? unit(sum) : NestPoint{-from.y, from.x};
    add_arc(centre, from, half, radius, out);
    add_arc(centre, half, to, radius, out);
    return;
  }
  out.push_back(centre + (from + to) * (radius / (1 + cosine)));
}

}  // namespace

NestRing tidied(NestRing ring) {
  if (signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  const double size = ring.empty() ? 0 : std::max(box_of(ring).width(), box_of(ring).height());
  const double near = 1e-7 * size;
  NestRing out;
  for (const NestPoint p : ring) {
    if (out.empty() || norm(p - out.back()) > near) out.push_back(p);
  }
  while (out.size() > 1 && norm(out.front() - out.back()) <= near) out.pop_back();
  for (std::size_t i = 0; i < out.size() && out.size() > 3;) {
    const NestPoint a = out[(i + out.size() - 1) % out.size()], b = out[i], c = out[(i + 1) % out.size()];
    const bool straight = std::abs(turn(a, b, c)) <= 1e-9 * size * norm(c - a) && dot(b - a, c - b) > 0;
    if (straight)
      out.erase(out.begin() + std::ptrdiff_t(i));
    else
      ++i;
  }
  return out;
}

NestRing without_spikes(NestRing ring) {
  const NestBox box = box_of(ring);
  const double least = 1e-9 * std::max(box.width(), box.height());
  const auto is_tip = [&](std::size_t i) {
    const NestPoint a = ring[(i + ring.size() - 1) % ring.size()], b = ring[i], c = ring[(i + 1) % ring.size()];
    const double longer = std::max(norm(b - a), norm(c - b));
    return dot(b - a, c - b) < 0 && std::abs(turn(a, b, c)) <= least * longer;
  };
  for (std::size_t i = 0; i < ring.size() && ring.size() > 3;) {
    if (!is_tip(i)) {
      ++i;
      continue;
    }
    ring.erase(ring.begin() + std::ptrdiff_t(i));
    // The two ends may now be the same point, and the point before may be a tip.
    const std::size_t before = (i + ring.size() - 1) % ring.size();
    if (ring[before] == ring[i % ring.size()]) ring.erase(ring.begin() + std::ptrdiff_t(before));
    i = i > 2 ? i - 2 : 0;
  }
  return ring;
}

NestRing enlarged_to_fewer_points(NestRing ring, double most_area) {
  double left = most_area;
  // The allowed area grows step by step, so that cheap removals come first.
  for (double allowed = most_area / 256; allowed <= most_area; allowed *= 2) {
    for (std::size_t i = 0; i < ring.size() && ring.size() > 4; ++i) {
      Removal removal;
      if (!removal_at(ring, i, removal) || removal.area > std::min(allowed, left) || !may_go(ring, i, removal))
        continue;
      left -= removal.area;
      if (removal.joins) ring[(i + 1) % ring.size()] = removal.corner;
      ring.erase(ring.begin() + std::ptrdiff_t(i));
    }
  }
  return ring;
}

NestRing grown(const NestRing& ring, double distance) {
  NestRing out;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const NestPoint a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
    const NestPoint before = right_of(unit(b - a)), after = right_of(unit(c - b));
    if (turn(a, b, c) >= 0) {
      add_arc(b, before, after, distance, out);
    } else {
      out.push_back(b + before * distance);
      out.push_back(b);
      out.push_back(b + after * distance);
    }
  }
  return out;
}

NestRing inset(const NestRing& ring, double depth) {
  constexpr double kFarthest = 8;
  NestRing out;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const NestPoint before = unit(ring[i] - ring[(i + n - 1) % n]), after = unit(ring[(i + 1) % n] - ring[i]);
    const NestPoint inward = (right_of(before) + right_of(after)) * -1.0;
    const double mitre = 1 / std::max(1 + dot(before, after), 1e-12);  // inward * mitre moves both sides by 1
    const double length = norm(inward) * mitre;
    out.push_back(ring[i] + inward * (depth * (length > kFarthest ? kFarthest / length * mitre : mitre)));
  }
  return out;
}

}  // namespace tessera
