#include "master/relaxing.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/stop.h"
#include "core/collage/clearing.h"
#include "core/matching/stances.h"
#include "core/relax/schedules.h"
#include "core/settings/tuning.h"
#include "master/rules/kept_apart.h"

namespace tessera::master {
namespace {

/// Whether any piece may grow. Pieces of fixed sizes would cover no more, and moving them opens gaps.
bool any_may_grow(const CollageSettings& s) {
  const StanceTable table(s, std::uint32_t(s.wishes.class_of_shape.size()));
  return std::any_of(table.stances().begin(), table.stances().end(),
                     [](const Stance& stance) { return stance.poses.min_scale_px < stance.poses.max_scale_px; });
}

}  // namespace

std::optional<NoRelaxing> why_not_relaxed(const CollageSettings& s) {
  if (!s.improve.relax) return NoRelaxing::not_wanted;
  if (s.pieces.size_map) return NoRelaxing::sizes_by_place;
  if (s.colour) return NoRelaxing::colours_by_place;
  const float most_px = kMostRelaxedSizeRatio * s.pieces.min_scale_px;
  if (s.pieces.max_scale_px > most_px * (1 + kScaleRounding)) return NoRelaxing::sizes_differ;
  if (!any_may_grow(s)) return NoRelaxing::sizes_fixed;
  return {};
}

bool pays_to_relax(const CollageSettings& settings) { return !why_not_relaxed(settings); }

std::uint32_t trials_per_relaxation(double area_px2, const PieceSettings& pieces) {
  const double pieces_at_most = area_px2 / (double(pieces.min_scale_px) * pieces.max_scale_px);
  return std::uint32_t(std::clamp(pieces_at_most, double(kTrialsPerRelaxation), 1e6));
}

Relaxing::Relaxing(const FreeField& free, const CollageSettings& settings, ShapeSource& shapes, PosesOf poses_of)
    : free_(free),
      settings_(settings),
      shapes_(shapes),
      poses_of_(std::move(poses_of)),
      relaxation_(free, contact_distances(settings.pieces)) {}

std::vector<Placement> Relaxing::relaxed(const std::vector<Placement>& placements, std::size_t given,
                                         std::span<const RelaxationSchedule> schedules, const StopCheck& check_stop) {
  std::map<ShapeId, ContactShape> contact_shapes;  // 80 KB each, so only of shapes that stand, and only for this call
  std::vector<RelaxedPiece> pieces;
  for (const Placement& p : placements) {
    check_stop();
    auto found = contact_shapes.find(p.shape);
    if (found == contact_shapes.end())
      found = contact_shapes.emplace(p.shape, make_contact_shape(shapes_.shape(p.shape))).first;
    const bool fixed = pieces.size() < given;
    pieces.push_back({&found->second, p.canvas_from_shape, poses_of_(p), fixed});
  }
  std::vector<std::size_t> moving(placements.size() - given);
  std::iota(moving.begin(), moving.end(), given);
  for (const RelaxationSchedule& schedule : schedules) relaxation_.relax(pieces, moving, schedule, check_stop);
  const std::vector<std::size_t> lost = make_clear(pieces, moving, free_, settings_.pieces, check_stop);
  std::vector<Placement> result = placements;
  for (const std::size_t i : moving) result[i].canvas_from_shape = pieces[i].canvas_from_shape;
  for (auto i = lost.rbegin(); i != lost.rend(); ++i) result.erase(result.begin() + std::ptrdiff_t(*i));
  return without_pieces_near_like(result, given, settings_, shapes_, free_.grid().period());
}

}  // namespace tessera::master
