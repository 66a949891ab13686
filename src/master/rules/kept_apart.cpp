#include "master/rules/kept_apart.h"

#include <algorithm>
#include <optional>

#include "core/collage/former_pieces.h"

namespace tessera::master {
namespace {

/// To find that a point is near a piece, every 16th outline point is compared first.
constexpr std::size_t kNearPointStride = 16;

/// Added to circles, so that rounding excludes no point.
constexpr float kRounding_px = 0.01f;

/// The points, moved, that lie within the circle.
std::vector<Vec2> within_circle(const std::vector<Vec2>& points, Vec2 moved_by, Vec2 centre, float radius_px) {
  const float most_px = radius_px + kRounding_px;
  std::vector<Vec2> within;
  for (const Vec2& point : points) {
    const Vec2 p = point + moved_by;
    if (dot(p - centre, p - centre) < most_px * most_px) within.push_back(p);
  }
  return within;
}

bool any_nearer_than(float reach_px, const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return std::any_of(b.begin(), b.end(), [&](Vec2 p) {
    return std::any_of(a.begin(), a.end(), [&](Vec2 q) { return dot(p - q, p - q) < reach_px * reach_px; });
  });
}

}  // namespace

bool any_kept_apart(const CollageSettings& settings) {
  const std::vector<ShapeWish>& classes = settings.wishes.classes;
  return settings.pieces.apart_px > 0 || std::any_of(classes.begin(), classes.end(), [](const ShapeWish& wish) {
           return wish.apart && wish.apart->distance_px > 0;
         });
}

KeptApart::KeptApart(const CollageSettings& settings, ShapeSource& shapes, const Period& period)
    : job_distance_px_(settings.pieces.apart_px),
      matters_(any_kept_apart(settings) || !settings.wishes.not_back.empty()),
      wishes_(settings.wishes),
      shapes_(shapes),
      period_(period) {
  for (const FormerPiece& piece : wishes_.not_back)
    not_back_[shapes.silhouette(piece.shape)].push_back(piece.canvas_from_shape);
}

KeptApart::Company KeptApart::company_of(ShapeId shape) const {
  if (!wishes_.class_of_shape.empty()) {
    const std::optional<ApartWish>& apart = wishes_.classes[wishes_.class_of_shape[index_of(shape)]].apart;
    if (apart) return {true, apart->company, apart->distance_px};
  }
  return {false, index_of(shapes_.silhouette(shape)), job_distance_px_};
}

KeptApart::Boundary KeptApart::boundary_of(ShapeId shape, const Similarity& canvas_from_shape) {
  const ShapeModel& model = shapes_.model(shape);
  const float scale_px = canvas_from_shape.scale();
  Boundary boundary{canvas_from_shape.translation(),
                    model.radius * scale_px,
                    0.5f * model.perimeter * scale_px / float(kBoundaryPoints),
                    {}};
  for (const Vec2 p : model.boundary) boundary.points_px.push_back(canvas_from_shape.apply(p));
  return boundary;
}

void KeptApart::add(const Placement& placement) {
  if (!concerns(placement.shape)) return;
  placed_[company_of(placement.shape).key()].push_back(boundary_of(placement.shape, placement.canvas_from_shape));
}

bool KeptApart::comes_back(ShapeId shape, const Similarity& canvas_from_shape) const {
  const auto lay = not_back_.find(shapes_.silhouette(shape));
  return lay != not_back_.end() && std::any_of(lay->second.begin(), lay->second.end(), [&](const Similarity& then) {
           return is_at_former_place(then, canvas_from_shape, period_);
         });
}

/// Compares only the points of each that the other's circle can reach.
bool KeptApart::any_points_nearer(float reach_px, const Boundary& a, const Boundary& b, Vec2 b_moved_by) {
  const std::vector<Vec2> of_b = within_circle(b.points_px, b_moved_by, a.centre_px, a.radius_px + reach_px);
  if (of_b.empty()) return false;
  const Vec2 b_centre_px = b.centre_px + b_moved_by;
  return any_nearer_than(reach_px, within_circle(a.points_px, {}, b_centre_px, b.radius_px + reach_px), of_b);
}

bool KeptApart::may_stand(ShapeId shape, const Similarity& canvas_from_shape, float radius) {
  if (comes_back(shape, canvas_from_shape)) return false;
  const Company company = company_of(shape);
  const auto like = placed_.find(company.key());
  if (company.distance_px == 0 || like == placed_.end()) return true;
  const Vec2 centre_px = canvas_from_shape.translation();
  std::optional<Boundary> own;
  for (const Boundary& other : like->second) {
    for (const Vec2 image : period_.offsets()) {
      const Vec2 between = other.centre_px + image - centre_px;
      const float circles_px = company.distance_px + other.radius_px + radius * canvas_from_shape.scale();
      if (dot(between, between) >= circles_px * circles_px) continue;
      if (!own) own = boundary_of(shape, canvas_from_shape);
      const float reach_px = company.distance_px + own->half_spacing_px + other.half_spacing_px;
      if (any_points_nearer(reach_px, *own, other, image)) return false;
    }
  }
  return true;
}

/// Whether one of the points is farther than `distance_px` from all of the pieces.
bool KeptApart::any_beyond(float distance_px, const std::vector<Boundary>& pieces, const AnyPoint& any_point) const {
  const auto near_piece = [&](Vec2 point, const Boundary& piece) {
    for (std::size_t i = 0; i < piece.points_px.size(); i += kNearPointStride) {
      const Vec2 between = period_.nearest(point, piece.points_px[i]) - piece.points_px[i];
      if (dot(between, between) < distance_px * distance_px) return true;
    }
    return false;
  };
  return any_point([&](Vec2 point) {
    return std::none_of(pieces.begin(), pieces.end(), [&](const Boundary& piece) { return near_piece(point, piece); });
  });
}

std::vector<ShapeId> KeptApart::shut_out(std::uint32_t shapes, const AnyPoint& any_point) const {
  std::map<std::pair<bool, std::uint32_t>, bool> open;  // companies that were looked at
  std::vector<ShapeId> shut_out;
  for (std::uint32_t i = 0; i < shapes; ++i) {
    const Company company = company_of(ShapeId{i});
    const auto like = placed_.find(company.key());
    if (company.distance_px == 0 || like == placed_.end()) continue;
    const auto [known, is_new] = open.try_emplace(company.key(), false);
    if (is_new) known->second = any_beyond(company.distance_px, like->second, any_point);
    if (!known->second) shut_out.push_back(ShapeId{i});
  }
  return shut_out;
}

std::vector<Placement> without_pieces_near_like(const std::vector<Placement>& placements, std::size_t given,
                                                const CollageSettings& settings, ShapeSource& shapes,
                                                const Period& period) {
  KeptApart apart(settings, shapes, period);
  if (!apart.matters()) return placements;
  std::vector<Placement> kept;
  for (std::size_t i = 0; i < placements.size(); ++i) {
    const auto& [shape, pose, score, matched_px] = placements[i];
    if (i >= given && !apart.may_stand(shape, pose, shapes.model(shape).radius)) continue;
    apart.add(placements[i]);
    kept.push_back(placements[i]);
  }
  return kept;
}

}  // namespace tessera::master
