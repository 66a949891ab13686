#include "products/puzzle/pieces/puzzle_piece.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/closed_curve.h"

namespace tessera {
namespace {

/// Turns are measured over so many steps to either side, because outlines traced from pixels have round corners.
constexpr int kCornerReach = 3;
/// Cosine of the least turn of a corner, 27 degrees.
constexpr float kStraightest = 0.89f;
/// Profiles end after this part of the boundary,
constexpr float kLongestProfile = 0.6f;
/// or after so many steps, which are eight pieces long.
constexpr int kMostProfileSteps = 512;
/// Corners of all pieces together, and the least and most of each: a piece with tabs has twelve. Each corner has a profile
/// in both directions and is compared with all others.
constexpr std::size_t kAllCorners = 20'000;
constexpr std::size_t kLeastCorners = 16, kMostCorners = 64;

std::vector<Vec2> directions_of(const std::vector<Vec2>& points) {
  const std::size_t n = points.size();
  std::vector<Vec2> directions(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 d = points[(k + 1) % n] - points[(k + n - 1) % n];
    directions[k] = d * (1 / std::max(norm(d), 1e-20f));
  }
  return directions;
}

/// Cosine of the turn at point k.
float straightness(const std::vector<Vec2>& points, std::size_t k) {
  const std::size_t n = points.size();
  const Vec2 before = points[k] - points[(k + n - kCornerReach) % n];
  const Vec2 after = points[(k + kCornerReach) % n] - points[k];
  return dot(before, after) / std::max(norm(before) * norm(after), 1e-20f);
}

/// Indices of the sharpest points within the reach.
std::vector<std::size_t> corner_points(const std::vector<Vec2>& points, std::size_t most) {
  const std::size_t n = points.size();
  std::vector<float> straight(n);
  for (std::size_t k = 0; k < n; ++k) straight[k] = straightness(points, k);
  std::vector<std::size_t> corners;
  for (std::size_t k = 0; k < n; ++k) {
    bool sharpest = straight[k] < kStraightest;
    for (std::size_t d = 1; d <= kCornerReach && sharpest; ++d)
      sharpest = straight[k] < straight[(k + d) % n] && straight[k] <= straight[(k + n - d) % n];
    if (sharpest) corners.push_back(k);
  }
  if (corners.size() > most) {
    std::stable_sort(corners.begin(), corners.end(),
                     [&](std::size_t a, std::size_t b) { return straight[a] < straight[b]; });
    corners.resize(most);
    std::sort(corners.begin(), corners.end());
  }
  return corners;
}

/// The point at `at` steps along the boundary, between its points.
Vec2 point_at(const std::vector<Vec2>& points, float at) {
  const float n = float(points.size());
  const float whole = std::floor(at);
  const std::size_t k = std::size_t(whole - n * std::floor(whole / n)) % points.size();
  return points[k] + (points[(k + 1) % points.size()] - points[k]) * (at - whole);
}

/// The exact place of corner k along the boundary: where the lines along its two sides meet.
float exact_corner(const std::vector<Vec2>& points, std::size_t k) {
  const float c = float(k);
  constexpr float kNear = 2, kFar = 6;
  const Vec2 a = point_at(points, c - kFar), b = point_at(points, c - kNear);
  const Vec2 d = point_at(points, c + kFar), e = point_at(points, c + kNear);
  const Vec2 u = b - a, v = e - d;
  const float sine = cross(u, v);
  if (std::abs(sine) < 0.2f * norm(u) * norm(v)) return c;
  const Vec2 meeting = a + u * (cross(d - a, v) / sine);
  float best = c, least = norm(points[k] - meeting);
  for (float at = c - 1.5f; at <= c + 1.5f; at += 0.125f) {
    const float distance = norm(point_at(points, at) - meeting);
    if (distance < least) {
      least = distance;
      best = at;
    }
  }
  return best;
}

std::vector<float> bends_of(const std::vector<Vec2>& directions) {
  constexpr std::size_t kReach = 8;
  const std::size_t n = directions.size();
  std::vector<float> bends(n);
  for (std::size_t k = 0; k < n; ++k) {
    const float turn = 1 - dot(directions[(k + n - kReach % n) % n], directions[(k + kReach) % n]);
    bends[k] = std::min(1.f, 4 * turn);
  }
  return bends;
}

/// Weight of the agreement of straight lines; bends have 1.
constexpr float kStraight = 0.3f;

/// The deepest point among those of a grid over its box.
Vec2 deepest_point(const PolygonIndex& outline) {
  constexpr int kPoints = 16;
  const Box& box = outline.box();
  Vec2 deepest = outline.outline().curves.front().front();
  float depth = 0;
  for (int j = 1; j < kPoints; ++j) {
    for (int i = 1; i < kPoints; ++i) {
      const Vec2 p{box.low.x + box.width() * float(i) / kPoints, box.low.y + box.height() * float(j) / kPoints};
      const float distance = outline.approach(p, box.width() + box.height()).distance;
      if (distance <= depth || !outline.contains(p)) continue;
      depth = distance;
      deepest = p;
    }
  }
  return deepest;
}

}  // namespace

PuzzleScale PuzzleScale::of(std::vector<double> areas) {
  const auto middle = areas.begin() + std::ptrdiff_t(areas.size() / 2);
  std::nth_element(areas.begin(), middle, areas.end());
  const float piece = float(std::sqrt(*middle));
  return {.piece = piece,
          .step = piece / 64,
          .tolerance = piece / 64,
          .most_corners = std::clamp(kAllCorners / areas.size(), kLeastCorners, kMostCorners)};
}

PuzzlePiece puzzle_piece(const std::vector<Vec2>& polygon, const PuzzleScale& scale) {
  const float length = closed_length(polygon);
  const int count = std::max(4 * kCornerReach, int(length / scale.step + 0.5f));
  PuzzlePiece piece{.outline = PolygonIndex(Outline{{polygon}}), .points = resampled_closed(polygon, count)};
  piece.directions = directions_of(piece.points);
  piece.bends = bends_of(piece.directions);
  for (const float bend : piece.bends) piece.weights.push_back(kStraight + (1 - kStraight) * bend);
  piece.point_length = length / float(count);
  const AreaMoment moment = area_moment(polygon);
  piece.area = moment.area;
  piece.deepest = deepest_point(piece.outline);
  piece.centre = {float(moment.x / moment.area), float(moment.y / moment.area)};
  for (const Vec2 p : polygon) piece.radius = std::max(piece.radius, norm(p - piece.centre));

  std::vector<float> at;
  for (const std::size_t k : corner_points(piece.points, scale.most_corners))
    at.push_back(exact_corner(piece.points, k));
  const int longest = std::min(kMostProfileSteps, int(kLongestProfile * float(count)));
  for (std::size_t i = 0; i < at.size(); ++i) {
    PuzzleCorner corner;
    for (int k = 0; k <= longest; ++k) {
      corner.ahead.push_back(point_at(piece.points, at[i] + float(k)));
      corner.back.push_back(point_at(piece.points, at[i] - float(k)));
    }
    const float after = at[(i + 1) % at.size()] - at[i], before = at[i] - at[(i + at.size() - 1) % at.size()];
    corner.side_ahead = after > 0 ? after : after + float(count);
    corner.side_back = before > 0 ? before : before + float(count);
    piece.corners.push_back(std::move(corner));
  }
  return piece;
}

}  // namespace tessera
