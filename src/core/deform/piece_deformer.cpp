#include "core/deform/piece_deformer.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

/// Largest inward movement as a fraction of a limb's thickness: there are two sides, and something must remain.
constexpr float kThinner = 0.25f;
/// A boundary stays where it faces its own shape at less than this many times the largest movement: a mouth stays open.
constexpr float kOwnGulf = 4;
/// Fraction of such a gulf that may be filled from each side if full Voronoi cells are wished.
constexpr float kOwnGulfFilled = 0.4f;
/// Length along the curve, shape units; limits fade over twice that.
constexpr float kFade = 0.03f;

/// Largest movement in one round, so that neighbours meet in their middle.
constexpr float kMostInRound_px = 2;
/// Factor by which a piece that has changed too much is deformed less, and limits of the number of such steps:
/// afterwards hardly any deformation is left.
constexpr float kShorter = 0.85f;
constexpr int kMostShorter = 16;
constexpr int kMostWeaker = 40;
/// Tolerance of a wished gap, for rounding.
constexpr float kGapSlack_px = 0.002f;

int neighbours_for(float spacing) { return std::clamp(int(kFade / spacing + 0.5f), 1, 64); }

/// Means over 2 n + 1 neighbours of a closed curve, applied twice.
void fade(std::vector<float>& values, int n) {
  const int count = int(values.size());
  n = std::min(n, (count - 1) / 2);
  for (int pass = 0; pass < 2; ++pass) {
    const std::vector<float> before = values;
    for (int i = 0; i < count; ++i) {
      float sum = 0;
      for (int k = -n; k <= n; ++k) sum += before[std::size_t((i + k + count) % count)];
      values[std::size_t(i)] = sum / float(2 * n + 1);
    }
  }
}

Vec2 outward_normal(const std::vector<Vec2>& curve, std::size_t i) {
  constexpr std::size_t kSpan = 2;  // neighbours on each side: a single segment is noisy
  const std::size_t n = curve.size(), span = std::min(kSpan, (n - 1) / 2);
  const Vec2 along = curve[(i + span) % n] - curve[(i + n - span) % n];
  const float length = norm(along);
  return length > 0 ? Vec2{along.y / length, -along.x / length} : Vec2{};
}

}  // namespace

PieceDeformer::PieceDeformer(const DeformablePiece& piece, std::uint32_t index, const DeformSettings& settings,
                             const PadParameters& pad)
    : piece_(piece),
      index_(index),
      settings_(settings),
      scale_px_(piece.canvas_from_shape.scale()),
      area_(area_moment(piece.shape->outline).area),
      identity_(*piece.shape, scale_px_, pad),
      fit_(*piece.shape, scale_px_) {
  for (const std::vector<Vec2>& curve : piece.shape->outline.curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) points_.push_back({curve[i], outward_normal(curve, i)});
  }
  warp_ = fit_.warp(std::vector<Vec2>(points_.size()));
}

float PieceDeformer::most_px() const {
  if (settings_.kind == DeformKind::voronoi) return 0.5f * scale_px_;
  return std::min(settings_.most_px, settings_.most_part * scale_px_);
}

void PieceDeformer::set_limits(const BoundaryMap& undeformed) {
  crossed_ = undeformed.crosses_itself(index_);
  const bool fills_gulfs = settings_.kind == DeformKind::voronoi;
  const float most = most_px(), look = kOwnGulf * most;
  std::size_t at = 0;
  for (const std::vector<Vec2>& curve : piece_.shape->outline.curves) {
    std::vector<float> out(curve.size()), in(curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec2 p = piece_.canvas_from_shape.apply(points_[at + i].home);
      const Vec2 normal = piece_.canvas_from_shape.apply_direction(points_[at + i].normal) * (1 / scale_px_);
      const RayHits outside = undeformed.hits(p, normal, look, index_);
      const RayHits inside = undeformed.hits(p, normal * -1, look, index_);
      const bool own_gulf = outside.own_px < look && outside.own_px < outside.other_px;
      out[i] = !own_gulf ? most : fills_gulfs ? std::min(most, kOwnGulfFilled * outside.own_px) : 0;
      in[i] = std::min(most, kThinner * inside.own_px);
    }
    const int neighbours = neighbours_for(1.f / float(curve.size()) * float(piece_.shape->perimeter));
    fade(out, neighbours);
    fade(in, neighbours);
    for (std::size_t i = 0; i < curve.size(); ++i, ++at) {
      points_[at].most_out_px = out[i];
      points_[at].most_in_px = in[i];
    }
  }
}

void PieceDeformer::step(const BoundaryMap& map, const FieldView& canvas, float gap_px, bool clears) {
  const float look = 2 * kMostInRound_px + gap_px;
  for (Point& point : points_) {
    const Vec2 p = piece_.canvas_from_shape.apply(warp_.apply(point.home));
    const float to_others = 0.5f * (map.distance_to_others_px(p, index_, look) - gap_px);
    const float to_edge = field_value(canvas, p) - gap_px;
    const float way = std::clamp(std::min(to_others, to_edge), -kMostInRound_px, clears ? 0 : kMostInRound_px);
    // Added to the wished movement, not to the resulting one: so the movement that smoothing removes is asked for
    // again.
    point.wished_px = std::clamp(point.wished_px + way, -point.most_in_px, point.most_out_px);
  }
  warp_ = fit_.warp(wished());
}

std::vector<Vec2> PieceDeformer::wished() const {
  std::vector<Vec2> displacements;
  displacements.reserve(points_.size());
  for (const Point& point : points_) displacements.push_back(point.normal * (point.wished_px / scale_px_));
  return displacements;
}

bool PieceDeformer::keeps_identity() const {
  if (settings_.kind == DeformKind::voronoi) return true;
  const float change = float(std::abs(area_moment(warped_outline(piece_.shape->outline, warp_)).area / area_ - 1));
  return change <= settings_.most_area && identity_.pad_distance(warp_) <= settings_.most_pad;
}

void PieceDeformer::grow_less() {
  for (int k = 0; k < kMostShorter && !keeps_identity(); ++k) {
    for (Point& point : points_) point.wished_px = std::min(point.wished_px, kShorter * point.wished_px);
    warp_ = fit_.warp(wished());
  }
}

void PieceDeformer::weaken() {
  if (settings_.kind == DeformKind::capped && farthest_px() > most_px()) scale_warp(most_px() / farthest_px());
  for (int k = 0; k < kMostWeaker && !keeps_identity(); ++k) scale_warp(kShorter);
  if (!keeps_identity()) undo();
}

void PieceDeformer::shrink() { scale_warp(kShorter); }

void PieceDeformer::undo() { scale_warp(0); }

std::vector<std::uint32_t> PieceDeformer::nearer_than(float gap_px, const BoundaryMap& map) const {
  std::vector<std::uint32_t> pieces;
  for (const Point& point : points_) {
    const Vec2 p = piece_.canvas_from_shape.apply(warp_.apply(point.home));
    const NearestOther other = map.nearest_other(p, index_, gap_px);
    if (other.piece && other.distance_px < gap_px - kGapSlack_px) pieces.push_back(*other.piece);
  }
  std::sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  return pieces;
}

void PieceDeformer::scale_warp(float factor) {
  for (Vec2& d : warp_.displacement.data()) d = d * factor;
}

float PieceDeformer::farthest_px() const {
  float farthest = 0;
  for (const Point& point : points_) farthest = std::max(farthest, norm(warp_.apply(point.home) - point.home));
  return farthest * scale_px_;
}

void PieceDeformer::undo_where_crossed(const BoundaryMap& map) {
  if (!crossed_ && map.crosses_itself(index_)) undo();
}

Outline PieceDeformer::outline_px() const {
  Outline outline = warped_outline(piece_.shape->outline, warp_);
  for (std::vector<Vec2>& curve : outline.curves) {
    for (Vec2& p : curve) p = piece_.canvas_from_shape.apply(p);
  }
  return outline;
}

DeformedPiece PieceDeformer::result() const {
  DeformedPiece deformed;
  deformed.outline = warped_outline(piece_.shape->outline, warp_);
  deformed.warp = warp_;
  deformed.area_ratio = float(area_moment(deformed.outline).area / area_);
  deformed.pad_distance = identity_.pad_distance(warp_);
  deformed.least_jacobian = warp_.least_jacobian();
  deformed.farthest_px = farthest_px();
  return deformed;
}

}  // namespace tessera
