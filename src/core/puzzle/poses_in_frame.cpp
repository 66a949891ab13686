#include "core/puzzle/poses_in_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tessera {
namespace {

/// Turns that are tried; between two of them a boundary two pieces from the centre moves by less than a tenth of one.
constexpr int kTurns = 128;
/// Of these, so many are followed.
constexpr std::size_t kMostPoses = 8;
/// Rest after so many steps of Gauss and Newton.
constexpr int kSteps = 30;
/// Of the outer boundary, so many points in all.
constexpr std::size_t kMostPoints = 512;

/// The points of all pieces' boundaries beside which no other piece lies, as if they were one piece.
PuzzlePiece outer_boundary(const std::vector<PosedPiece>& laid, const PuzzlePiece& frame, const PuzzleScale& scale) {
  PuzzlePiece outer{.outline = frame.outline};
  double x = 0, y = 0;
  for (const PosedPiece& piece : laid) {
    std::vector<Beside> beside(piece.piece->points.size(), Beside::nothing);
    for (const PosedPiece& other : laid) {
      if (other.piece != piece.piece) see_neighbour(piece, other, scale, beside);
    }
    for (std::size_t k = 0; k < beside.size(); ++k) {
      if (beside[k] != Beside::nothing) continue;
      outer.points.push_back(piece.pose.apply(piece.piece->points[k]));
      outer.directions.push_back(piece.pose.apply_direction(piece.piece->directions[k]));
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
  return outer;
}

/// Mean distance from the frame, at most `reach`.
float distance_from(const PuzzlePiece& frame, const PuzzlePiece& outer, const Similarity& pose, float reach) {
  double sum = 0;
  for (const Vec2 p : outer.points) sum += frame.outline.approach(pose.apply(p), reach).distance;
  return outer.points.empty() ? reach : float(sum / double(outer.points.size()));
}

}  // namespace

std::vector<Similarity> poses_in_frame(const std::vector<PosedPiece>& laid, const PuzzlePiece& frame,
                                       const PuzzleScale& scale) {
  const PuzzlePiece outer = outer_boundary(laid, frame, scale);
  std::vector<std::pair<float, Similarity>> tried;
  // Not by sines and cosines, which differ from machine to machine: half a turn's tangent goes from -1 to 1, twice.
  for (int k = 0; k < kTurns; ++k) {
    const float half = 4 * (float(k % (kTurns / 2)) + 0.5f) / float(kTurns) - 1;
    const float sign = k < kTurns / 2 ? 1.f : -1.f, length = 1 + half * half;
    const Similarity turned{sign * (1 - half * half) / length, sign * 2 * half / length, 0, 0};
    const Vec2 shift = frame.centre - turned.apply(outer.centre);
    const Similarity pose{turned.a, turned.b, shift.x, shift.y};
    tried.emplace_back(distance_from(frame, outer, pose, scale.piece), pose);
  }
  const auto nearer = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::stable_sort(tried.begin(), tried.end(), nearer);
  tried.resize(kMostPoses);
  PuzzleScale wide = scale;
  std::vector<Similarity> poses;
  for (auto& [distance, pose] : tried) {
    for (const float tolerance : {scale.piece / 4, scale.piece / 16, scale.tolerance}) {
      wide.tolerance = tolerance;
      pose = settled({&outer, pose}, {{&frame, {}}}, wide, kSteps / 3);
    }
    distance = distance_from(frame, outer, pose, scale.piece);
  }
  std::stable_sort(tried.begin(), tried.end(), nearer);
  for (const auto& [distance, pose] : tried) poses.push_back(pose);
  return poses;
}

}  // namespace tessera
