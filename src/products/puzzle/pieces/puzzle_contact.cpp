#include "products/puzzle/pieces/puzzle_contact.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

/// A gap is wider than the tolerance, and narrower than so many tolerances.
constexpr float kWidestGap = 4;
/// Distance from the edge at which pictures are compared, in steps.
constexpr float kInside = 1.5f;
/// Part of a piece's points that may lie deeper in another piece than the tolerance.
constexpr float kOverlapping = 0.02f;

bool is_frame(const PuzzlePiece& piece) { return piece.area < 0; }

/// Whether the point lies in the solid part; for a frame that is the area around it.
bool covers(const PuzzlePiece& piece, Vec2 p) { return piece.outline.contains(p) != is_frame(piece); }

/// Whether too many points of `a` lie deep in `b`.
bool lies_in(const PosedPiece& a, const PosedPiece& b, const PuzzleScale& scale) {
  const Similarity b_from_a = followed_by(a.pose, rigid_inverse(b.pose));
  const Box& box = b.piece->outline.box();
  // for example, a piece of the same outline in the same place
  if (covers(*b.piece, b_from_a.apply(a.piece->deepest))) return true;
  const std::size_t n = a.piece->points.size();
  const std::size_t most = std::size_t(kOverlapping * float(n));
  std::size_t deep = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 p = b_from_a.apply(a.piece->points[k]);
    const bool in_box = p.x > box.low.x && p.x < box.high.x && p.y > box.low.y && p.y < box.high.y;
    if (!in_box && !is_frame(*b.piece)) continue;
    if (!covers(*b.piece, p) || b.piece->outline.nearer_than(scale.tolerance, p)) continue;
    if (++deep > most) return true;
  }
  return false;
}

/// From 1, where boundaries lie on each other, to -2, where they are as far apart as those of unrelated pieces often are.
/// Straight lines tell nothing: all of them are alike, and their distance is what the pieces have lost.
float closeness(float distance, float bend, const PuzzleScale& scale) {
  constexpr float kOfStrangers = 0.6f, kWorst = 3;
  const float apart = distance / (kOfStrangers * scale.tolerance);
  return bend * (1 - kWorst * std::min(1.f, apart * apart));
}

}  // namespace

Similarity followed_by(const Similarity& here, const Similarity& there) {
  const Vec2 at = there.apply(here.translation());
  return {there.a * here.a - there.b * here.b, there.b * here.a + there.a * here.b, at.x, at.y};
}

Similarity rigid_inverse(const Similarity& pose) {
  return {pose.a, -pose.b, -(pose.a * pose.tx + pose.b * pose.ty), pose.b * pose.tx - pose.a * pose.ty};
}

bool covers(const PosedPiece& piece, Vec2 p) { return covers(*piece.piece, rigid_inverse(piece.pose).apply(p)); }

bool may_touch(const PosedPiece& a, const PosedPiece& b, float reach) {
  if (is_frame(*a.piece) || is_frame(*b.piece)) return true;
  const Vec2 d = a.pose.apply(a.piece->centre) - b.pose.apply(b.piece->centre);
  const float most = a.piece->radius + b.piece->radius + reach;
  return dot(d, d) <= most * most;
}

bool overlap(const PosedPiece& a, const PosedPiece& b, const PuzzleScale& scale) {
  return may_touch(a, b, 0) &&
         ((!is_frame(*a.piece) && lies_in(a, b, scale)) || (!is_frame(*b.piece) && lies_in(b, a, scale)));
}

float inside_from_edge(const PuzzleScale& scale) { return kInside * scale.step; }

float pictures_agree(const PuzzlePiece& here, Vec2 at_here, Vec2 outside_here, const PuzzlePiece& there, Vec2 at_there,
                     Vec2 outside_there, const PuzzleScale& scale) {
  if (scale.contrast <= 0 || !here.picture || !there.picture) return 0;
  const float inside = inside_from_edge(scale);
  const auto a = here.picture->at(at_here - outside_here * inside);
  const auto b = there.picture->at(at_there - outside_there * inside);
  return a && b ? 1 - 2 * std::min(1.f, colour_distance(*a, *b) / scale.contrast) : 0;
}

float see_neighbour(const PosedPiece& piece, const PosedPiece& neighbour, const PuzzleScale& scale,
                    std::vector<Beside>& beside) {
  const float reach = kWidestGap * scale.tolerance;
  if (!may_touch(piece, neighbour, reach)) return 0;
  float agreement = 0;
  const Similarity there_from_here = followed_by(piece.pose, rigid_inverse(neighbour.pose));
  for (std::size_t k = 0; k < beside.size(); ++k) {
    if (beside[k] == Beside::contact) continue;
    const Vec2 p = there_from_here.apply(piece.piece->points[k]);
    const Approach near = neighbour.piece->outline.approach(p, reach);
    if (near.distance >= reach) continue;
    beside[k] = near.distance <= scale.tolerance ? Beside::contact : Beside::gap;
    if (beside[k] == Beside::gap) continue;
    agreement += closeness(near.distance, piece.piece->bends[k], scale);
    const Vec2 along = piece.piece->directions[k], outside{along.y, -along.x};
    agreement += pictures_agree(*piece.piece, piece.piece->points[k], outside, *neighbour.piece, near.there,
                                there_from_here.apply_direction(outside) * -1, scale);
  }
  return agreement;
}

Similarity moved(const PosedPiece& piece, Vec2 shift, double turn) {
  const double length = std::sqrt(1 + turn * turn);
  const Similarity turned{float(1 / length), float(turn / length), 0, 0};
  const Vec2 centre = piece.pose.apply(piece.piece->centre);
  const Vec2 at = centre - turned.apply(centre) + shift;
  const Similarity pose = followed_by(piece.pose, {turned.a, turned.b, at.x, at.y});
  const float unit = 1 / pose.scale();
  return {pose.a * unit, pose.b * unit, pose.tx, pose.ty};
}

Similarity settled(PosedPiece piece, const std::vector<PosedPiece>& neighbours, const PuzzleScale& scale, int steps) {
  const float reach = 2 * scale.tolerance;
  const double arm = scale.piece / 2;  // turns angles into lengths
  for (int step = 0; step < steps; ++step) {
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Identity() * 0.5;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    const Vec2 centre = piece.pose.apply(piece.piece->centre);
    for (const PosedPiece& neighbour : neighbours) {
      const Similarity there_from_puzzle = rigid_inverse(neighbour.pose);
      for (std::size_t k = 0; k < piece.piece->points.size(); ++k) {
        const Vec2 p = piece.pose.apply(piece.piece->points[k]);
        const Approach near = neighbour.piece->outline.approach(there_from_puzzle.apply(p), reach);
        if (near.distance >= reach) continue;
        const Vec2 off = p - neighbour.pose.apply(near.there);
        const Vec2 d = piece.pose.apply_direction(piece.piece->directions[k]);
        const Vec2 normal{d.y, -d.x};
        const double error = dot(off, normal);
        const Eigen::Vector3d row(normal.x, normal.y, cross(p - centre, normal) / arm);
        hessian += row * row.transpose();
        gradient += row * error;
      }
    }
    const Eigen::Vector3d move = hessian.ldlt().solve(-gradient);
    piece.pose = moved(piece, {float(move[0]), float(move[1])}, move[2] / arm);
  }
  return piece.pose;
}

}  // namespace tessera
