#include "core/relax/relaxation_step.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

constexpr int kTurnUnknown = 2;
constexpr int kGrowth = 3;

struct StepLimits {
  double low;
  double high;
};

/// A step at most halves a piece: the linear model is valid for small movements only.
constexpr float kMostShrinking = 0.5f;

/// Solves M x = -g by L D L^T; M is given by its lower half. An unknown that is `fixed` keeps its x.
void solve(const double (&matrix)[4][4], const double (&gradient)[4], const bool (&fixed)[4], double (&x)[4]) {
  double l[4][4] = {};
  double d[4];
  double y[4];
  for (int r = 0; r < 4; ++r) {
    y[r] = fixed[r] ? x[r] : -gradient[r];
    d[r] = fixed[r] ? 1 : matrix[r][r];
    for (int c = 0; c < 4 && !fixed[r]; ++c) {
      if (fixed[c]) y[r] -= (c < r ? matrix[r][c] : matrix[c][r]) * x[c];
    }
    for (int c = 0; c < r; ++c) {
      double sum = fixed[r] || fixed[c] ? 0 : matrix[r][c];
      for (int k = 0; k < c; ++k) sum -= l[r][k] * l[c][k] * d[k];
      l[r][c] = sum / d[c];
      d[r] -= l[r][c] * l[r][c] * d[c];
      y[r] -= l[r][c] * y[c];
    }
  }
  for (int r = 3; r >= 0; --r) {
    x[r] = y[r] / d[r];
    for (int k = r + 1; k < 4; ++k) x[r] -= l[k][r] * x[k];
  }
}

/// Fixes the unknown at the limit that it exceeds; false if it exceeds none.
bool fix_at_limit(const StepLimits& limits, bool& fixed, double& x) {
  const double within = std::clamp(x, limits.low, limits.high);
  if (fixed || within == x) return false;
  x = within;
  fixed = true;
  return true;
}

}  // namespace

float PieceMovement::largest() const {
  const float shift = std::sqrt(shift_x * shift_x + shift_y * shift_y);
  return std::max(shift, std::max(std::abs(turn), std::abs(growth)));
}

void RelaxationStep::add(const float (&change)[4], float depth_px, float weight) {
  for (int r = 0; r < 4; ++r) {
    gradient_[r] -= double(weight * change[r] * depth_px);
    for (int c = 0; c <= r; ++c) matrix_[r][c] += double(weight * change[r] * change[c]);
  }
}

void RelaxationStep::add_own(const Contact& contact, float depth_px, float stiffness) {
  const Vec2 arm = contact.at - centre_;
  const Vec2 n = contact.gradient;
  const float weight = stiffness * contact.length_px;
  add({n.x, n.y, cross(arm, n) / scale_px_, dot(arm, n) / scale_px_}, depth_px, weight);
  // A larger piece has more boundary.
  gradient_[kGrowth] += double(0.5f * weight * depth_px * depth_px / scale_px_);
}

void RelaxationStep::add_others(const Contact& contact, float depth_px, float stiffness) {
  const Vec2 arm = contact.at - centre_;
  const Vec2 n = contact.gradient;
  add({-n.x, -n.y, -cross(arm, n) / scale_px_, (contact.distance_px - dot(arm, n)) / scale_px_}, depth_px,
      stiffness * contact.length_px);
}

void RelaxationStep::add_growth() { gradient_[kGrowth] -= double(2 * scale_px_); }

void RelaxationStep::add_damping(float stiffness) {
  for (int r = 0; r < 4; ++r) matrix_[r][r] += double(stiffness);
}

PieceMovement RelaxationStep::solved(const Similarity& canvas_from_shape, const PoseRange& poses) const {
  const TurnLimits turns = poses.turns(canvas_from_shape);
  const StepLimits turn{double(turns.low * scale_px_), double(turns.high * scale_px_)};
  // A pose at a bound may lie beyond it because of rounding.
  const StepLimits growth{
      double(std::min(0.f, std::max(poses.min_scale_px - scale_px_, (kMostShrinking - 1) * scale_px_))),
      double(std::max(0.f, poses.max_scale_px - scale_px_))};
  double x[4] = {};
  bool fixed[4] = {};
  do {
    solve(matrix_, gradient_, fixed, x);
  } while (fix_at_limit(growth, fixed[kGrowth], x[kGrowth]) ||
           fix_at_limit(turn, fixed[kTurnUnknown], x[kTurnUnknown]));
  return {float(x[0]), float(x[1]), float(x[2]), float(x[3])};
}

Similarity moved(const Similarity& s, const PieceMovement& movement, float part, const PoseRange& poses) {
  const float scale = s.scale();
  // The rotation is the Cayley form of the angle, which needs no sine.
  const float t = 0.5f * part * movement.turn / scale;
  const float k = (1 + part * movement.growth / scale) / (1 + t * t);
  const float c = k * (1 - t * t);
  const float n = k * (2 * t);
  Similarity next{s.a * c - s.b * n, s.b * c + s.a * n, s.tx + part * movement.shift_x, s.ty + part * movement.shift_y};
  poses.pull_in(next);
  return next;
}

}  // namespace tessera
