#include "products/puzzle/laying/within_frame.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace tessera {
namespace {

/// In tolerances: how far a piece may reach beyond the edge before it is moved in, or before all pieces settle.
constexpr float kMovedIn = 4, kBeforeSettling = 8;
/// The number of boundary points that tell about where a piece lies.
constexpr std::size_t kFewPoints = 12;
/// The most moves of a piece into the frame; in a corner two sides take turns.
constexpr int kMoves = 12;

/// Whether the point lies beyond the frame's edge by more than `distance`; the solid part of a frame is the area around it
/// (puzzle_piece.h).
bool is_beyond(const PosedPiece& frame, Vec2 p, float distance) {
  return covers(frame, p) && !frame.piece->outline.nearer_than(distance, p);
}

bool is_about_within(const PosedPiece& piece, const PosedPiece& frame, float distance) {
  if (covers(frame, piece.pose.apply(piece.piece->deepest))) return false;
  const std::size_t n = piece.piece->points.size();
  for (std::size_t k = 0; k < kFewPoints; ++k) {
    if (is_beyond(frame, piece.pose.apply(piece.piece->points[k * n / kFewPoints]), distance)) return false;
  }
  return true;
}

/// The way to the edge from the piece's point that lies farthest beyond it, among points within `reach` of the edge.
Vec2 way_in(const PosedPiece& piece, const PosedPiece& frame, float reach) {
  Vec2 way{0, 0};
  float farthest = 0;
  for (const Vec2 point : piece.piece->points) {
    const Vec2 p = piece.pose.apply(point);
    if (!covers(frame, p)) continue;
    const Approach near = frame.piece->outline.approach(p, reach);
    if (near.distance >= reach || near.distance <= farthest) continue;
    farthest = near.distance;
    way = near.there - p;
  }
  return way;
}

bool is_within(const PosedPiece& piece, const PosedPiece& frame, float distance) {
  return std::none_of(piece.piece->points.begin(), piece.piece->points.end(),
                      [&](Vec2 point) { return is_beyond(frame, piece.pose.apply(point), distance); });
}

/// The near pose in which the piece lies in the frame; empty: it is too far beyond the edge.
std::optional<Similarity> within(PosedPiece piece, const PosedPiece& frame, const PuzzleScale& scale) {
  if (is_within(piece, frame, scale.tolerance)) return piece.pose;
  if (!is_within(piece, frame, kMovedIn * scale.tolerance)) return {};
  for (int k = 0; k < kMoves; ++k) {
    const Vec2 way = way_in(piece, frame, 2 * kMovedIn * scale.tolerance);
    piece.pose.tx += way.x;
    piece.pose.ty += way.y;
    if (is_within(piece, frame, scale.tolerance)) return piece.pose;
  }
  return {};
}

}  // namespace

std::size_t pieces_within_frame(const Arrangement& alone, const Similarity& frame_from_puzzle,
                                const PuzzleArranger& arranger) {
  const PosedPiece frame = arranger.posed(arranger.frame());
  const float distance = kBeforeSettling * arranger.scale().tolerance;
  arranger.report(alone);
  return std::size_t(std::count_if(alone.laid.begin(), alone.laid.end(), [&](const LaidPiece& laid) {
    return is_about_within(arranger.posed({laid.piece, followed_by(laid.pose, frame_from_puzzle)}), frame, distance);
  }));
}

Arrangement moved_into_frame(const Arrangement& alone, const Similarity& frame_from_puzzle,
                             const PuzzleArranger& arranger) {
  Arrangement moved;
  moved.used.assign(alone.used.size(), false);
  moved.laid.push_back(arranger.frame());
  const PosedPiece frame = arranger.posed(arranger.frame());
  for (const LaidPiece& laid : alone.laid) {
    const LaidPiece there{laid.piece, followed_by(laid.pose, frame_from_puzzle)};
    if (!is_about_within(arranger.posed(there), frame, kBeforeSettling * arranger.scale().tolerance)) continue;
    moved.laid.push_back(there);
    moved.used[std::size_t(laid.piece)] = true;
  }
  arranger.settle_all(moved);
  keep_within_frame(moved, arranger);
  arranger.drop_loose(kLeastTouching, moved);
  return moved;
}

void keep_within_frame(Arrangement& in, const PuzzleArranger& arranger) {
  const PosedPiece frame = arranger.posed(arranger.frame());
  std::vector<LaidPiece> kept;
  for (LaidPiece laid : in.laid) {
    arranger.report(in);
    if (!arranger.is_frame(laid)) {
      const std::optional<Similarity> pose = within(arranger.posed(laid), frame, arranger.scale());
      in.used[std::size_t(laid.piece)] = pose.has_value();
      if (!pose) continue;
      laid.pose = *pose;
    }
    kept.push_back(laid);
  }
  in.laid = std::move(kept);
}

}  // namespace tessera
