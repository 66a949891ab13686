#include "core/replacing/hole.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

int nodes_across(float half_px, float cell_px) { return int(2 * half_px / cell_px) + 2; }

}  // namespace

Hole::Hole(Vec2 centre_px, float half_px, float cell_px, const EdgeDistance& edge)
    : centre_(centre_px),
      origin_(centre_px - Vec2{half_px, half_px}),
      cell_px_(cell_px),
      distance_(nodes_across(half_px, cell_px), nodes_across(half_px, cell_px)) {
  for (int j = 0; j < distance_.height(); ++j) {
    for (int i = 0; i < distance_.width(); ++i) distance_(i, j) = std::min(kFar_px, edge.at(node(i, j)).value);
  }
}

void Hole::add(const ContactPiece& piece) {
  const auto first = [&](float low, float origin) { return std::max(0, int((low - kFar_px - origin) / cell_px_)); };
  const auto end = [&](float high, float origin, int count) {
    return std::min(count, int(std::max(0.f, (high + kFar_px - origin) / cell_px_)) + 2);
  };
  const int x1 = end(piece.box.high.x, origin_.x, distance_.width());
  const int y1 = end(piece.box.high.y, origin_.y, distance_.height());
  for (int j = first(piece.box.low.y, origin_.y); j < y1; ++j) {
    for (int i = first(piece.box.low.x, origin_.x); i < x1; ++i) {
      float& distance = distance_(i, j);
      distance = std::min(distance, piece.distance(node(i, j)).value);
    }
  }
}

FieldSample Hole::at(Vec2 p) const {
  const float u = std::clamp((p.x - origin_.x) / cell_px_, 0.f, float(distance_.width()) - 1.001f);
  const float v = std::clamp((p.y - origin_.y) / cell_px_, 0.f, float(distance_.height()) - 1.001f);
  const int i = int(u);
  const int j = int(v);
  const float s = u - float(i);
  const float t = v - float(j);
  const float* q = distance_.row(j) + i;
  const float* r = q + distance_.width();
  const float upper = q[0] + (q[1] - q[0]) * s;
  const float lower = r[0] + (r[1] - r[0]) * s;
  return {upper + (lower - upper) * t,
          {((q[1] - q[0]) * (1 - t) + (r[1] - r[0]) * t) / cell_px_, (lower - upper) / cell_px_}};
}

float Hole::free_px2(float reach_px) const {
  std::int64_t nodes = 0;
  for (int j = 0; j < distance_.height(); ++j) {
    for (int i = 0; i < distance_.width(); ++i) {
      nodes += distance_(i, j) > 0 && norm(node(i, j) - centre_) < reach_px;
    }
  }
  return float(nodes) * cell_px_ * cell_px_;
}

std::vector<RimPoint> Hole::rim(float reach_px) const {
  std::vector<RimPoint> points;
  for (int j = 0; j < distance_.height(); ++j) {
    for (int i = 0; i < distance_.width(); ++i) {
      const float distance = distance_(i, j);
      if (!(distance > 0 && distance <= cell_px_) || norm(node(i, j) - centre_) >= reach_px) continue;
      const FieldSample here = at(node(i, j));
      const float slope = norm(here.gradient);
      if (slope < 0.3f) continue;  // a ridge: the rim lies on both sides
      RimPoint point{node(i, j), here.gradient * (1 / slope), 0};
      point.at = point.at - point.inward * distance;
      point.room_px = 2 * cell_px_;
      for (;;) {
        const float free = at(point.at + point.inward * point.room_px).value;
        if (free <= 0 || point.room_px > 2 * reach_px) break;
        point.room_px += std::max(0.5f * cell_px_, free);
      }
      points.push_back(point);
    }
  }
  return points;
}

}  // namespace tessera
