// Computes the arclength pyramid at a vertex of a closed polyline (paper section 3.2) by walking outwards on both
// sides.
//
// The result depends only on the vertices that the walk passes. A piece of boundary that was cut and pasted elsewhere
// has the same pyramids, bit for bit, wherever its loop starts.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/pad/pad.h"

namespace tessera {

/// Turning of the polyline at q, from p over q to r, in (-pi, pi]; positive = left.
inline float turning_rad(Vec2 p, Vec2 q, Vec2 r) {
  const Vec2 in = q - p;
  const Vec2 out = r - q;
  return std::atan2(cross(in, out), dot(in, out));
}

/// Absolute curvature below this is noise of straight sides. `sigma` is the width of the smoothing, in the curve's unit
/// of length.
inline float curvature_dead_zone(float sigma) { return 0.024f / sigma; }

/// A point has convexity 0 if its triangle is flatter than this (sine of its outer angle). Level 0 of a smooth arc
/// gives delta_tau.
inline constexpr float kFlatTriangle = 0.05f;

/// s of the paper: the orientation of the triangle of level 0's ends and the point itself; 0 if it is flat.
inline float convexity_of(const ArclengthPyramid& pyramid, int levels) {
  const Vec2 in = pyramid.keypoint[levels] - pyramid.keypoint[levels - 1];
  const Vec2 out = pyramid.keypoint[levels + 1] - pyramid.keypoint[levels];
  const float sine = cross(in, out) / std::max(norm(in) * norm(out), 1e-12f);
  return sine > kFlatTriangle ? 1.f : sine < -kFlatTriangle ? -1.f : 0.f;
}

namespace detail {

struct SideOfPyramid {
  std::array<float, kMaxPadLevels> length{};
  std::array<Vec2, kMaxPadLevels> end{};
};

/// Walks one side. `step(walk)` goes to the next vertex, `ahead(walk)` is the length of the edge to it; `edge_before`
/// is the edge on the centre's other side. The walk ends where the loop closes, or when it is `longest` long; the
/// levels that were not reached get the whole length walked.
///
/// The turning at a vertex is spread over the halves of its two edges, so that levels end between vertices and move
/// smoothly. The centre's turning is divided between both sides.
template <class Walk, class Step, class Ahead>
SideOfPyramid walk_side(const Walk& start, Vec2 before, float edge_before, Step step, Ahead ahead,
                        const PadParameters& pad, float dead_zone, float longest) {
  SideOfPyramid side;
  Walk at = start;
  int level = 0;
  float goal = pad.delta_tau;
  float turned = 0;
  float walked = 0;  // to the middle of the edge (a, b)
  Vec2 a = before;
  Vec2 b = at.position();
  float edge_in = 0;  // half the centre's own interval: it starts at the centre
  float whole_in = edge_before;
  bool closed = false;
  while (level < pad.levels && !closed && walked < longest) {
    const float half_in = 0.5f * edge_in;
    const float edge_out = ahead(at);
    const float half_out = 0.5f * edge_out;
    const bool centre = edge_in == 0;
    const float support = 0.5f * (whole_in + edge_out);
    float turn = std::max(0.f, at.turning_rad() - dead_zone * support);
    if (centre) turn *= half_out / support;
    const float interval = half_in + half_out;
    step(at);
    const Vec2 c = at.position();
    closed = at == start;
    while (level < pad.levels && turned + turn >= goal) {
      const float fraction = turn > 0 ? (goal - turned) / turn : 1.f;
      const float along = fraction * interval;  // from the middle of (a, b)
      side.length[level] = walked + along;
      side.end[level] = along < half_in ? b + (a - b) * ((half_in - along) / whole_in)
                                        : b + (c - b) * (edge_out > 0 ? (along - half_in) / edge_out : 0.f);
      goal = pad.delta_tau * float(1 << ++level);
    }
    turned += turn;
    walked += interval;
    a = b;
    b = c;
    edge_in = edge_out;
    whole_in = edge_out;
  }
  const float whole = walked + 0.5f * edge_in;
  for (; level < pad.levels; ++level) {
    side.length[level] = whole;
    side.end[level] = b;
  }
  return side;
}

}  // namespace detail

/// Makes the pyramid at `centre`. A `Walk` stands on a vertex of a closed polyline. It has forward(), backward() and
/// operator==; position() and the absolute turning_rad() there; edge_forward() and edge_backward(), the lengths of the
/// edges on both sides. No side is walked much farther than `longest`.
template <class Walk>
ArclengthPyramid make_pyramid(const Walk& centre, const PadParameters& pad, float dead_zone,
                              float longest = std::numeric_limits<float>::infinity()) {
  Walk after = centre;
  Walk before = centre;
  after.forward();
  before.backward();
  const auto r = detail::walk_side(
      centre, before.position(), centre.edge_backward(), [](Walk& w) { w.forward(); },
      [](const Walk& w) { return w.edge_forward(); }, pad, dead_zone, longest);
  const auto l = detail::walk_side(
      centre, after.position(), centre.edge_forward(), [](Walk& w) { w.backward(); },
      [](const Walk& w) { return w.edge_backward(); }, pad, dead_zone, longest);

  ArclengthPyramid pyramid;
  const int n = pad.levels;
  pyramid.keypoint[n] = centre.position();
  for (int i = 0; i < n; ++i) {
    // A length of zero (a cusp sharper than the curve's spacing) would cause a division by zero in the PAD.
    pyramid.left[i] = std::max(l.length[i], 1e-6f);
    pyramid.right[i] = std::max(r.length[i], 1e-6f);
    pyramid.keypoint[n - 1 - i] = l.end[i];
    pyramid.keypoint[n + 1 + i] = r.end[i];
  }
  pyramid.convexity = convexity_of(pyramid, n);
  return pyramid;
}

}  // namespace tessera
