#include "master/rules/outward_growth.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/portable_math.h"
#include "core/field/piece_distance.h"
#include "core/geometry/distance_transform.h"
#include "core/settings/tuning.h"

namespace tessera::master {
namespace {

constexpr int kStep = 4;                  // px between the places where the distance to the seed is known
constexpr float kLeastFading = 1.f / 60;  // of the canvas' width and height together, so that no score becomes 0

Vec2 deepest_px(const Canvas& canvas) {
  const Grid<float>& depth = canvas.distance.value;
  const Vec2 middle{0.5f * float(canvas.width_px), 0.5f * float(canvas.height_px)};
  Vec2 best_px = middle;
  float deepest = 0;
  float nearest = 0;
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      const Vec2 p = canvas.distance.origin + Vec2{float(x), float(y)};
      const float from_middle = dot(p - middle, p - middle);
      const bool better = depth(x, y) > deepest || (depth(x, y) == deepest && from_middle < nearest);
      if (!better) continue;
      deepest = depth(x, y);
      nearest = from_middle;
      best_px = p;
    }
  }
  return best_px;
}

/// Marks the nodes, every kStep-th, that zones or pieces cover; at least the node of the first piece.
Grid<std::uint8_t> seed_at(const Canvas& canvas, const std::vector<Placement>& standing, ShapeSource& shapes,
                           Vec2 first_piece_px) {
  const Grid<float>& nodes = canvas.distance.value;
  const Vec2 origin = canvas.distance.origin;
  Grid<std::uint8_t> seed(nodes.width() / kStep + 1, nodes.height() / kStep + 1, 0);
  if (canvas.has_zones()) {
    for (int y = 0; y * kStep < nodes.height(); ++y) {
      for (int x = 0; x * kStep < nodes.width(); ++x) seed(x, y) = canvas.keep_out.value(x * kStep, y * kStep) < kStep;
    }
  }
  for (const Placement& p : standing) {
    const Shape& shape = shapes.shape(p.shape);
    const PieceDistance distance(shape, p.canvas_from_shape, 0);
    const Window window = piece_window(shape.outline, p.canvas_from_shape, origin, kStep).intersected(nodes.bounds());
    for (int y = (window.y0 + kStep - 1) / kStep; y * kStep < window.y1; ++y) {
      for (int x = (window.x0 + kStep - 1) / kStep; x * kStep < window.x1; ++x) {
        if (distance.at(origin + Vec2{float(x * kStep), float(y * kStep)}) < kStep) seed(x, y) = 1;
      }
    }
  }
  const bool nothing = std::none_of(seed.data().begin(), seed.data().end(), [](std::uint8_t at) { return at != 0; });
  const Vec2 first = first_piece_px - origin;
  if (nothing) seed(int(first.x) / kStep, int(first.y) / kStep) = 1;
  return seed;
}

}  // namespace

OutwardGrowth::OutwardGrowth(const Canvas& canvas, const PieceSettings& pieces, const std::vector<Placement>& standing,
                             ShapeSource& shapes)
    : zones_(canvas.keep_out),
      kept_px_(kept_distance_px(pieces)),
      on_edge_px_(kOnEdge_px + kOnRoundedEdge * opening_radius_px(pieces)),
      fading_px_(
          std::max(kGrowthFading * pieces.max_scale_px, kLeastFading * float(canvas.width_px + canvas.height_px))),
      first_piece_px_(deepest_px(canvas)),
      to_seed_px_(squared_distance_to(seed_at(canvas, standing, shapes, first_piece_px_))),
      origin_(canvas.distance.origin) {
  for (float& d : to_seed_px_.data()) d = float(kStep) * std::sqrt(d);
}

bool OutwardGrowth::may_dock(const FreeField& free, Vec2 canvas_px) const {
  if (free.canvas_sample(canvas_px).value - kept_px_ > on_edge_px_) return true;
  return free.has_zones() && field_value(FieldView(zones_), canvas_px) - kept_px_ <= on_edge_px_;
}

float OutwardGrowth::nearness(Vec2 canvas_px) const {
  const Vec2 at = (canvas_px - origin_) * (1.f / kStep);
  const int x = std::clamp(int(at.x), 0, to_seed_px_.width() - 1);
  const int y = std::clamp(int(at.y), 0, to_seed_px_.height() - 1);
  constexpr float kLog2OfE = 1.44269504f;
  return portable_exp2(-std::min(kLog2OfE * to_seed_px_(x, y) / fading_px_, 60.f));
}

}  // namespace tessera::master
