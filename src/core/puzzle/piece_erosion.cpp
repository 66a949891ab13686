#include "core/puzzle/piece_erosion.h"

#include <algorithm>
#include <cstddef>

#include "core/puzzle/piece_matches.h"

namespace tessera {
namespace {

/// Distances that are tried: multiples of this part of a piece's size, up to so many, and halves at last.
constexpr float kStep = 1.f / 256;
constexpr int kMostSteps = 12;
/// So many steps after the best one none better is expected.
constexpr int kPatience = 3;
/// Pieces whose boundaries are followed; they are held against all.
constexpr std::size_t kSample = 16;
/// How much better boundaries must run alike before pieces count as eroded. Where sides are straight they always do, and
/// chance brings some per cent; a pixel that was lost of pieces of 60 to 160 px brings 45 to 85.
constexpr double kLeastGain = 1.2;

}  // namespace

std::vector<Vec2> grown_polygon(const std::vector<Vec2>& polygon, float distance) {
  const std::size_t n = polygon.size();
  std::vector<Vec2> grown(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 along = polygon[(k + 1) % n] - polygon[(k + n - 1) % n];
    grown[k] = polygon[k] + Vec2{along.y, -along.x} * (distance / std::max(norm(along), 1e-20f));
  }
  return grown;
}

float erosion_of(const std::vector<std::vector<Vec2>>& polygons, const PuzzleScale& scale,
                 const std::function<void()>& watch) {
  double most = 0;
  float best = 0;
  const auto try_growing = [&](float steps) {
    std::vector<PuzzlePiece> pieces;
    for (const std::vector<Vec2>& polygon : polygons) {
      watch();
      pieces.push_back(puzzle_piece(grown_polygon(polygon, steps * kStep * scale.piece), scale));
    }
    const double length = matched_length(pieces, kSample, scale, watch);
    if (length <= most) return false;
    most = length;
    best = steps;
    return true;
  };
  try_growing(0);
  const double as_they_are = most;
  for (int steps = 1; steps <= std::min(kMostSteps, int(best) + kPatience); ++steps) try_growing(float(steps));
  if (most < kLeastGain * as_they_are || best == 0) return 0;
  if (const float middle = best; !try_growing(middle + 0.5f)) try_growing(middle - 0.5f);
  return best * kStep * scale.piece;
}

}  // namespace tessera
