#include "result/polygon_pieces.h"

#include <algorithm>
#include <cmath>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/too_many.h"
#include "core/geometry/winding.h"
#include "result/polygon_features.h"
#include "text/number_text.h"

namespace tessera {
namespace {

constexpr std::size_t kMostBytes = std::size_t(512) << 20;  // of the file: some 50,000 pieces of ours
constexpr double kSmallestPiece_px2 = 1e-4;                 // the least area that a job may give
constexpr double kMostTwisted = 0.01;     // part of a piece's area: outlines of thin limbs may have tiny loops
constexpr double kMostBoundary_px = 8e6;  // of all pieces, because it is sampled every half px
// boundary divided by width + height of its bounding box; more fills the box like a comb
constexpr double kMostFolded = 100;
constexpr double kFewPositions = 1000;   // positions that even the smallest piece may have ..
constexpr double kPositionsPerPx = 100;  // .. and more for each px of its bounding box' width + height
constexpr float kMostBeyond = 0.5;       // part of the canvas' width or height

std::string box_text(const Box& box) { return fixed(box.width(), 1) + " x " + fixed(box.height(), 1) + " px"; }

std::string position_text(Vec2 p) { return "[" + fixed(p.x, 3) + ", " + fixed(p.y, 3) + "]"; }

/// The ring without its closing position, in the direction of an outer boundary or a hole.
std::vector<Vec2> curve_of(Ring ring, bool is_hole) {
  if (ring.size() < 4) {
    throw InputError("geometry.coordinates: found a ring of " + count_text(ring.size(), "position") +
                     ", allowed: 4 or more, the last one the first again");
  }
  if (ring.front() != ring.back()) {
    throw InputError("geometry.coordinates: found a ring that is open, from " + position_text(ring.front()) + " to " +
                     position_text(ring.back()) + ", allowed: the last position is the first again");
  }
  ring.pop_back();
  if ((signed_area(ring) < 0) != is_hole) std::reverse(ring.begin(), ring.end());
  return ring;
}

Outline outline_of(std::vector<std::vector<Ring>> polygons) {
  Outline outline;
  for (std::vector<Ring>& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) outline.curves.push_back(curve_of(std::move(polygon[i]), i > 0));
  }
  return outline;
}

AreaMoment moment_of(const Outline& outline) {
  const AreaMoment sum = area_moment(outline);
  if (sum.area < kSmallestPiece_px2) {
    throw InputError("geometry.coordinates: found rings that enclose " + fixed(std::max(sum.area, 0.), 6) +
                     " square px, allowed: " + fixed(kSmallestPiece_px2, 4) + " or more");
  }
  return sum;
}

void check_untwisted(const Outline& outline, double area_px2) {
  const double twisted_px2 = twisted_area(outline);
  if (twisted_px2 <= kMostTwisted * area_px2) return;
  throw InputError("geometry.coordinates: found rings that cross themselves or each other, round " +
                   fixed(twisted_px2, 1) + " square px, allowed: simple ones, holes within their outer ring");
}

double length_px(const Outline& outline) {
  double sum = 0;
  for (const std::vector<Vec2>& curve : outline.curves) {
    for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) sum += norm(curve[i] - curve[j]);
  }
  return sum;
}

/// Refuses outlines that take far more time than they show: boundaries in many layers, positions without distance.
void check_unfolded(const Outline& outline) {
  const Box box = bounding_box(outline);
  const double sides_px = double(box.width()) + box.height();
  const double boundary_px = length_px(outline);
  if (boundary_px > kMostFolded * sides_px) {
    throw InputError("geometry.coordinates: found " + fixed(boundary_px, 0) + " px of boundary in a box of " +
                     box_text(box) + ", allowed: up to " + fixed(kMostFolded, 0) + " times its width and height");
  }
  std::size_t positions = 0;
  for (const std::vector<Vec2>& curve : outline.curves) positions += curve.size();
  if (double(positions) > kFewPositions + kPositionsPerPx * sides_px) {
    throw InputError("geometry.coordinates: found " + std::to_string(positions) + " positions in a box of " +
                     box_text(box) + ", allowed: " + fixed(kFewPositions, 0) + ", and " + fixed(kPositionsPerPx, 0) +
                     " for each px of its width and height");
  }
}

bool is_far_beyond(float low_px, float high_px, int side_px) {
  return high_px < -kMostBeyond * float(side_px) || low_px > (1 + kMostBeyond) * float(side_px);
}

void check_near_canvas(const Outline& outline, const Canvas& canvas) {
  const Box box = bounding_box(outline);
  if (!is_far_beyond(box.low.x, box.high.x, canvas.width_px) &&
      !is_far_beyond(box.low.y, box.high.y, canvas.height_px)) {
    return;
  }
  throw InputError("geometry.coordinates: found a piece from " + position_text(box.low) + " to " +
                   position_text(box.high) + ", far from the canvas of " + std::to_string(canvas.width_px) + " x " +
                   std::to_string(canvas.height_px) + " px, allowed: up to half of its width or height beyond it");
}

void move(JudgedPiece& piece, Vec2 by) {
  if (by == Vec2{}) return;
  piece.centre_px = piece.centre_px + by;
  for (std::vector<Vec2>& curve : piece.outline_px.curves) {
    for (Vec2& p : curve) p = p + by;
  }
}

JudgedPiece piece_of(PolygonFeature feature, const Canvas& canvas) {
  JudgedPiece piece;
  piece.outline_px = outline_of(std::move(feature.polygons));
  const AreaMoment moment = moment_of(piece.outline_px);
  check_unfolded(piece.outline_px);
  check_untwisted(piece.outline_px, moment.area);
  piece.shape = std::move(feature.shape);
  piece.centre_px = {float(moment.x / moment.area), float(moment.y / moment.area)};
  piece.scale_px = std::sqrt(moment.area);
  move(piece, canvas.period.wrapped(piece.centre_px) - piece.centre_px);
  check_near_canvas(piece.outline_px, canvas);
  return piece;
}

}  // namespace

std::vector<JudgedPiece> read_polygon_pieces(const std::string& path, const Canvas& canvas) {
  JsonFile file{FileBlocks(path, kMostBytes)};
  std::vector<JudgedPiece> pieces;
  double boundary_px = 0;
  try {
    read_polygon_features(file, [&](PolygonFeature feature) {
      pieces.push_back(piece_of(std::move(feature), canvas));
      boundary_px += length_px(pieces.back().outline_px);
      if (boundary_px <= kMostBoundary_px) return;
      throw InputError("geometry.coordinates: " +
                       too_many(std::size_t(kMostBoundary_px), "px of boundary up to here, of all pieces"));
    });
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
  return pieces;
}

}  // namespace tessera
