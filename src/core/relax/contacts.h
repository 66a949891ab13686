// Contacts: boundary samples of a piece in the distance field of another, and near the canvas' edge.
#pragma once

#include <algorithm>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/relax/contact_shape.h"
#include "core/relax/edge_distance.h"

namespace tessera {

/// A shape at its pose on the canvas. Canvas px.
struct ContactPiece {
  const ContactShape* shape = nullptr;  // outlives the piece
  Similarity canvas_from_shape;
  float scale_px = 0;
  const BoundarySamples* samples = nullptr;  // of the shape, with the density for this scale
  std::vector<Vec2> points;                  // the samples' positions
  Box box;                                   // bounding box of the points

  void lay(const ContactShape& of_shape, const Similarity& where);

  /// Distance to the outline, positive outside, with its gradient.
  FieldSample distance(Vec2 p) const {
    const Similarity& s = canvas_from_shape;
    const float per_px2 = 1 / (scale_px * scale_px);
    const Vec2 d = p - s.translation();
    const FieldSample at = shape->distance({(s.a * d.x + s.b * d.y) * per_px2, (s.a * d.y - s.b * d.x) * per_px2});
    return {at.value * scale_px, s.apply_direction(at.gradient) * (1 / scale_px)};
  }
};

struct Contact {
  Vec2 at;            // a sample, canvas px
  float distance_px;  // to the other's boundary; negative: depth in it
  Vec2 gradient;      // of the distance
  float length_px;    // length of the boundary that the sample stands for
};

/// Walks along the samples and calls f(contact) for those with `distance(p)` below `reach_px`. Elsewhere it skips
/// samples: the distance changes by no more than the way along the boundary. `slack_px` is the error of look-up between
/// nodes.
template <class Distance, class F>
void walk_contacts(const ContactPiece& piece, float reach_px, float slack_px, Distance distance, F f) {
  const float per_step = 1 / (piece.samples->longest_step * piece.scale_px);
  std::size_t i = 0;
  for (const std::size_t end : piece.samples->curve_ends) {
    while (i < end) {
      const Vec2 p = piece.points[i];
      const FieldSample d = distance(p);
      if (d.value < reach_px) {
        f(Contact{p, d.value, d.gradient, piece.samples->samples[i].length * piece.scale_px});
        ++i;
      } else {
        const float steps = (d.value - reach_px - slack_px) * per_step;
        i = steps < float(end - i) ? i + std::max<std::size_t>(1, std::size_t(std::max(steps, 0.f))) : end;
      }
    }
  }
}

/// Calls f(contact) for the samples of `piece` that are nearer than `reach_px` to `other` moved by `offset`.
template <class F>
void each_contact(const ContactPiece& piece, const ContactPiece& other, Vec2 offset, float reach_px, F f) {
  const Box box{other.box.low + offset, other.box.high + offset};
  if (!within_reach(piece.box, box, std::max(reach_px, 0.f))) return;
  const float node_px = other.scale_px / other.shape->nodes_per_unit;
  const auto distance = [&](Vec2 p) {
    // Far from the box the distance to the box is enough.
    const float to_box =
        std::max(std::max(box.low.x - p.x, p.x - box.high.x), std::max(box.low.y - p.y, p.y - box.high.y));
    if (to_box > std::max(reach_px, 0.f) + node_px) return FieldSample{to_box, {}};
    return other.distance(p - offset);
  };
  walk_contacts(piece, reach_px, node_px, distance, f);
}

/// Calls f(contact) for the samples nearer than `reach_px` to the canvas' edge, whose distance is negative outside.
template <class F>
void each_contact(const ContactPiece& piece, const EdgeDistance& edge, float reach_px, F f) {
  // No sample is farther from the centre than the radius.
  const FieldSample centre = edge.at(piece.canvas_from_shape.translation());
  if (centre.value > piece.shape->radius * piece.scale_px + reach_px + edge.node_px()) return;
  walk_contacts(
      piece, reach_px, edge.node_px(), [&](Vec2 p) { return edge.at(p); }, f);
}

}  // namespace tessera
