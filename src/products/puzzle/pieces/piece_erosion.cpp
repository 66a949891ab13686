#include "products/puzzle/pieces/piece_erosion.h"

#include <algorithm>
#include <cstddef>

#include "core/base/stop.h"
#include "core/geometry/closed_curve.h"
#include "core/geometry/polygon.h"
#include "products/puzzle/pieces/growth_between.h"
#include "products/puzzle/pieces/piece_matches.h"

namespace tessera {
namespace {

/// Distances that are tried: multiples of this part of a piece's size, at most so many. The best pairs tell the exact
/// value.
constexpr float kStep = 1.f / 256;
constexpr std::size_t kMostErosions = 12;
/// The search ends so many steps after the best one.
constexpr std::size_t kPassesWithoutGain = 3;
/// Pieces whose boundaries are followed; they are compared with all.
constexpr std::size_t kSample = 16;
/// The factor by which boundaries must agree longer before pieces count as eroded. Chance brings some per cent; a lost pixel on pieces
/// of 60 to 160 px with tabs brings 45 to 100.
constexpr double kLeastGain = 1.2;
/// The best pairs, one in so many, are examined: pairs that belong together are among them.
constexpr std::size_t kBestPart = 4;
/// Boundaries tell the distance only if it is visible that pieces are grown too far. With tabs, two fifths or less of the
/// agreement are left after so many steps; with polygons three quarters are left, and the maximum is chance.
constexpr std::size_t kTooFar = kPassesWithoutGain;
constexpr double kMostTooFar = 0.5;
/// In tolerances: the erosion that a frame may tell is between these two, because pieces may also be missing; and the usual
/// erosions.
constexpr float kLeastFilling = 0.125f, kMostFilling = 2;
constexpr float kUsual[] = {0, 1, 0.5f};

using Polygons = std::vector<std::vector<Vec2>>;

std::vector<PuzzlePiece> grown_pieces(const Polygons& polygons, float distance, const PuzzleScale& scale,
                                      const StopCheck& check_stop) {
  std::vector<PuzzlePiece> pieces;
  for (const std::vector<Vec2>& polygon : polygons) {
    check_stop();
    pieces.push_back(puzzle_piece(grown_polygon(polygon, distance), scale));
  }
  return pieces;
}

/// The growth that the pieces still need: the median over the pairs that meet best.
float missing_growth(const std::vector<PuzzlePiece>& pieces, const PuzzleScale& scale, const StopCheck& check_stop) {
  std::vector<GrowthBetween> found;
  for (const SideMatch& side : sampled_sides(pieces, kSample, scale, check_stop)) {
    const PosedPiece here{&pieces[std::size_t(side.piece)], {}};
    const PosedPiece there{&pieces[std::size_t(side.match.piece)], side.match.here_from_there};
    if (const auto growth = growth_between(there, here, scale)) found.push_back(*growth);
  }
  if (found.empty()) return 0;
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.rms < b.rms; });
  found.resize((found.size() + kBestPart - 1) / kBestPart);
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  return found[found.size() / 2].distance;
}

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

std::optional<float> erosion_of(const std::vector<std::vector<Vec2>>& polygons, const PuzzleScale& scale,
                                const StopCheck& check_stop) {
  const auto length_at = [&](float steps) {
    const auto pieces = grown_pieces(polygons, steps * kStep * scale.piece, scale, check_stop);
    double length = 0;
    for (const SideMatch& side : sampled_sides(pieces, kSample, scale, check_stop)) length += double(side.length());
    return length;
  };
  std::vector<double> lengths = {length_at(0)};
  std::size_t best = 0;
  for (std::size_t steps = 1; steps <= std::min(kMostErosions, best + kPassesWithoutGain); ++steps) {
    lengths.push_back(length_at(float(steps)));
    if (lengths[steps] > lengths[best]) best = steps;
  }
  const double most = lengths[best];
  if (lengths[std::min(best + kTooFar, lengths.size() - 1)] > kMostTooFar * most) return {};
  if (most < kLeastGain * lengths[0] || best == 0) return 0;
  const float step = kStep * scale.piece, about = float(best) * step;
  return about +
         std::clamp(missing_growth(grown_pieces(polygons, about, scale, check_stop), scale, check_stop), -step, step);
}

std::vector<float> likely_erosions(const std::vector<std::vector<Vec2>>& pieces, double frame_area,
                                   const PuzzleScale& scale, const StopCheck& check_stop) {
  if (const std::optional<float> told = erosion_of(pieces, scale, check_stop)) return {*told};
  double area = 0, length = 0;
  for (const std::vector<Vec2>& polygon : pieces) {
    area += signed_area(polygon);
    length += closed_length(polygon);
  }
  std::vector<float> likely;
  const float filling = float((frame_area - area) / length);
  if (filling > kLeastFilling * scale.tolerance && filling < kMostFilling * scale.tolerance) likely.push_back(filling);
  for (const float usual : kUsual) likely.push_back(usual * scale.tolerance);
  return likely;
}

}  // namespace tessera
