#include "products/puzzle/laying/poses_in_frame.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tessera {
namespace {

/// The number of turns that are tried. Between two of them a boundary two pieces from the centre moves by less than a tenth
/// of a piece.
constexpr int kTurns = 128;
/// The number of the best turns that are followed.
constexpr std::size_t kMostPoses = 8;
/// Gauss-Newton steps until a pose is settled.
constexpr int kSteps = 30;
/// Points of the outer boundary, at most.
constexpr std::size_t kMostPoints = 512;
/// Part of the frame's edge that pieces must reach at the right scale, and part of their outer boundary that may lie beyond
/// it.
constexpr float kLeastReached = 0.6f;
constexpr float kMostBeyond = 0.02f;

/// The boundary points of all pieces beside which no other piece lies, as if all were one piece.
PuzzlePiece outer_boundary(const std::vector<PosedPiece>& laid, const PuzzlePiece& frame, const PuzzleScale& scale) {
  PuzzlePiece outer{.outline = frame.outline};
  double x = 0, y = 0, length = 0;
  for (const PosedPiece& piece : laid) {
    std::vector<Beside> beside(piece.piece->points.size(), Beside::nothing);
    for (const PosedPiece& other : laid) {
      if (other.piece != piece.piece) see_neighbour(piece, other, scale, beside);
    }
    for (std::size_t k = 0; k < beside.size(); ++k) {
      if (beside[k] != Beside::nothing) continue;
      outer.points.push_back(piece.pose.apply(piece.piece->points[k]));
      outer.directions.push_back(piece.pose.apply_direction(piece.piece->directions[k]));
      length += double(piece.piece->point_length);
    }
    const Vec2 centre = piece.pose.apply(piece.piece->centre);
    outer.area += piece.piece->area;
    x += piece.piece->area * centre.x;
    y += piece.piece->area * centre.y;
  }
  outer.centre = {float(x / outer.area), float(y / outer.area)};
  const std::size_t step = outer.points.size() / kMostPoints + 1;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < outer.points.size(); k += step, ++kept) {
    outer.points[kept] = outer.points[k];
    outer.directions[kept] = outer.directions[k];
  }
  outer.points.resize(kept);
  outer.directions.resize(kept);
  outer.point_length = float(length / double(std::max<std::size_t>(kept, 1)));
  return outer;
}

/// The convex hull of points, seen from evenly spaced directions.
struct Hull {
  Vec2 centre;      // its Steiner point, which moves, turns and grows with the points
  float width = 0;  // mean
};

Hull hull_of(const std::vector<Vec2>& points) {
  constexpr int kDirections = 64;
  constexpr double kCosine = 0.99518472667219693, kSine = 0.098017140329560602;  // of the angle between two
  double along_x = 1, along_y = 0, x = 0, y = 0, sum = 0;
  for (int k = 0; k < kDirections; ++k) {
    double farthest = -INFINITY;
    for (const Vec2 p : points) farthest = std::max(farthest, along_x * p.x + along_y * p.y);
    x += farthest * along_x;
    y += farthest * along_y;
    sum += farthest;
    const double turned_x = kCosine * along_x - kSine * along_y;
    along_y = kSine * along_x + kCosine * along_y;
    along_x = turned_x;
  }
  constexpr double kOfSum = 2. / kDirections;
  return {{float(kOfSum * x), float(kOfSum * y)}, float(kOfSum * sum)};
}

/// The mean distance from the frame, at most `reach`.
float distance_from(const PuzzlePiece& frame, const PuzzlePiece& outer, const Similarity& pose, float reach) {
  double sum = 0;
  for (const Vec2 p : outer.points) sum += frame.outline.approach(pose.apply(p), reach).distance;
  return outer.points.empty() ? reach : float(sum / double(outer.points.size()));
}

using Tried = std::vector<std::pair<float, Similarity>>;  // with the distance of the outer boundary from the frame

void sort_nearest_first(Tried& tried) {
  std::stable_sort(tried.begin(), tried.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

/// The best poses with the hull's centre on that of the frame, enlarged `times` times, over all turns.
Tried turned_in_frame(const PuzzlePiece& outer, const Hull& hull, const PuzzlePiece& frame, const Hull& frame_hull,
                      float times, const PuzzleScale& scale) {
  Tried tried;
  // Without sines and cosines, which differ from machine to machine: half a turn's tangent goes from -1 to 1, twice.
  for (int k = 0; k < kTurns; ++k) {
    const float half = 4 * (float(k % (kTurns / 2)) + 0.5f) / float(kTurns) - 1;
    const float sign = k < kTurns / 2 ? 1.f : -1.f, length = 1 + half * half;
    const Similarity turned{times * sign * (1 - half * half) / length, times * sign * 2 * half / length, 0, 0};
    const Vec2 shift = frame_hull.centre - turned.apply(hull.centre);
    const Similarity pose{turned.a, turned.b, shift.x, shift.y};
    tried.emplace_back(distance_from(frame, outer, pose, scale.piece), pose);
  }
  sort_nearest_first(tried);
  tried.resize(kMostPoses);
  return tried;
}

/// Moves, turns and scales the boundary so that the parts nearer to the frame than `reach` lie along it: least squares like
/// settled(), but with the scale.
Similarity along_frame(const PuzzlePiece& outer, Similarity pose, const PuzzlePiece& frame, float reach, float arm) {
  for (int step = 0; step < kSteps / 3; ++step) {
    Eigen::Matrix4d hessian = Eigen::Matrix4d::Identity() * 0.5;
    Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
    const Vec2 centre = pose.apply(outer.centre);
    for (std::size_t k = 0; k < outer.points.size(); ++k) {
      const Vec2 p = pose.apply(outer.points[k]);
      const Approach near = frame.outline.approach(p, reach);
      if (near.distance >= reach) continue;
      const Vec2 d = pose.apply_direction(outer.directions[k]) * (1 / pose.scale());
      const Vec2 normal{d.y, -d.x}, from_centre = (p - centre) * (1 / arm);
      const Eigen::Vector4d row(normal.x, normal.y, cross(from_centre, normal), dot(from_centre, normal));
      hessian += row * row.transpose();
      gradient += row * double(dot(p - near.there, normal));
    }
    const Eigen::Vector4d move = hessian.ldlt().solve(-gradient);
    const double turn = move[2] / arm, growth = 1 + move[3] / arm, length = std::sqrt(1 + turn * turn);
    const Similarity turned{float(growth / length), float(growth * turn / length), 0, 0};
    const Vec2 shift = centre - turned.apply(centre) + Vec2{float(move[0]), float(move[1])};
    pose = followed_by(pose, {turned.a, turned.b, shift.x, shift.y});
  }
  return pose;
}

/// The part of the frame's edge that the outer boundary reaches; 0: too much of it lies beyond the edge.
float reached_part(const PuzzlePiece& outer, const Similarity& pose, const PuzzlePiece& frame,
                   const PuzzleScale& scale) {
  std::size_t there = 0, beyond = 0;
  for (const Vec2 point : outer.points) {
    const Vec2 p = pose.apply(point);
    if (frame.outline.nearer_than(2 * scale.tolerance, p)) {
      ++there;
    } else if (!frame.outline.contains(p)) {
      ++beyond;
    }
  }
  if (float(beyond) > kMostBeyond * float(outer.points.size())) return 0;
  const float frame_length = frame.point_length * float(frame.points.size());
  return float(there) * outer.point_length * pose.scale() / frame_length;
}

}  // namespace

std::vector<Similarity> poses_in_frame(const std::vector<PosedPiece>& laid, const PuzzlePiece& frame,
                                       const PuzzleScale& scale) {
  const PuzzlePiece outer = outer_boundary(laid, frame, scale);
  if (outer.points.empty()) return {};
  Tried tried = turned_in_frame(outer, hull_of(outer.points), frame, hull_of(frame.points), 1, scale);
  PuzzleScale wide = scale;
  for (auto& [distance, pose] : tried) {
    for (const float tolerance : {scale.piece / 4, scale.piece / 16, scale.tolerance}) {
      wide.tolerance = tolerance;
      pose = settled({&outer, pose}, {{&frame, {}}}, wide, kSteps / 3);
    }
    distance = distance_from(frame, outer, pose, scale.piece);
  }
  sort_nearest_first(tried);
  std::vector<Similarity> poses;
  for (const auto& [distance, pose] : tried) poses.push_back(pose);
  return poses;
}

std::optional<Similarity> scaled_pose_in_frame(const std::vector<PosedPiece>& laid, const PuzzlePiece& frame,
                                               const PuzzleScale& scale) {
  const PuzzlePiece outer = outer_boundary(laid, frame, scale);
  if (outer.points.empty()) return {};
  const Hull hull = hull_of(outer.points), frame_hull = hull_of(frame.points);
  if (!(hull.width > 0)) return {};
  std::optional<Similarity> best;
  float most = kLeastReached;
  for (auto& [distance, pose] : turned_in_frame(outer, hull, frame, frame_hull, frame_hull.width / hull.width, scale)) {
    for (const float reach : {scale.piece / 2, scale.piece / 8, 2 * scale.tolerance})
      pose = along_frame(outer, pose, frame, reach, scale.piece / 2);
    const float reached = reached_part(outer, pose, frame, scale);
    if (!(reached > most)) continue;
    most = reached;
    best = pose;
  }
  return best;
}

}  // namespace tessera
