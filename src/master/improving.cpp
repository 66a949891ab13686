#include "master/improving.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/base/portable_math.h"
#include "core/base/stop.h"
#include "core/collage/objective.h"
#include "core/relax/schedules.h"
#include "core/replacing/repetition.h"
#include "core/replacing/repetition_costs.h"
#include "core/settings/tuning.h"
#include "master/replacing.h"

namespace tessera::master {
namespace {

constexpr std::uint64_t kRuin = 0x7275696e;  // keeps these random numbers apart from those of the dockings
constexpr std::uint32_t kPassesPerTrial = 4;
constexpr double kLeastDwarfs = 5;  // a dwarf is smaller than the largest size divided by this

/// Whether the size belongs to the lowest sixth of sizes, by their logarithm, like dwarfs_below_px (size_balance.h) but
/// without a logarithm. Where sizes differ by less than kLeastDwarfs there are no dwarfs.
bool is_dwarf(double scale_px, const PieceSettings& pieces) {
  const double by_smallest = scale_px / double(pieces.min_scale_px);
  const double squared = by_smallest * by_smallest;
  return squared * squared * squared * double(pieces.min_scale_px) < double(pieces.max_scale_px) &&
         scale_px * kLeastDwarfs < double(pieces.max_scale_px);
}

/// The area of the pieces, in whole numbers, so that their order does not matter.
std::int64_t area_256ths_px2(const std::vector<Placement>& placements) {
  std::int64_t sum = 0;
  for (const Placement& p : placements) {
    const Similarity& s = p.canvas_from_shape;
    sum += std::int64_t(256 * (double(s.a) * s.a + double(s.b) * s.b));
  }
  return sum;
}

/// A point in a gap; every free px is as likely. False where there is hardly any free area.
bool find_gap(const FreeField& free, std::uint64_t random, Vec2& gap) {
  const CanvasField& field = free.field();
  const Window& nodes = free.grid().one_period();
  for (int draw = 0; draw < kGapDraws; ++draw) {
    random = mix_bits(random);
    const int x = nodes.x0 + int(((random >> 32) * std::uint64_t(nodes.width())) >> 32);
    const int y = nodes.y0 + int(((random & 0xffffffffull) * std::uint64_t(nodes.height())) >> 32);
    if (field.value(x, y) < kGapDepth_px) continue;
    gap = field.origin + Vec2{float(x), float(y)};
    return true;
  }
  return false;
}

}  // namespace

Improving::Improving(Collage& collage, Filling& filling, const CollageSettings& settings, double area_px2,
                     ShapeSource& shapes)
    : collage_(collage),
      filling_(filling),
      shapes_(shapes),
      relaxing_(collage.free(), settings, shapes,
                [&collage](const Placement& p) { return collage.open_shapes().poses_of(p); }),
      relax_(pays_to_relax(settings)),
      trials_per_relaxation_(trials_per_relaxation(area_px2, settings.pieces)),
      pieces_(settings.pieces),
      dwarf_loss_(kDwarfLoss * double(balance_of(settings.objective))),
      off_colour_(settings.colour, shapes),
      repetition_(pays_to_replace(settings)
                      ? repetition_costs(settings, count_drawings(collage.open_shapes().stances(), shapes), area_px2)
                      : RepetitionCosts{}),
      seed_(settings.seed),
      most_scale_px_(settings.pieces.fit_all ? std::numeric_limits<float>::infinity()
                                             : kRuinedScale * settings.pieces.min_scale_px),
      most_pieces_(settings.stop.pieces > 0 ? std::size_t(settings.stop.pieces) : SIZE_MAX) {}

/// The pieces that are small enough and nearest to a gap, nearest first. Each counts as a disc of its area.
std::vector<std::size_t> Improving::pieces_near(Vec2 gap_px) const {
  constexpr float kDiscRadius = 0.5642f;  // of area 1
  std::vector<std::pair<float, std::size_t>> nearest;
  const std::vector<Placement>& placements = collage_.placements();
  for (std::size_t i = collage_.open_shapes().given(); i < placements.size(); ++i) {
    const Similarity& pose = placements[i].canvas_from_shape;
    if (pose.scale() > most_scale_px_) continue;
    const Vec2 gap = collage_.free().grid().period().nearest(gap_px, pose.translation());
    nearest.emplace_back(norm(pose.translation() - gap) - kDiscRadius * pose.scale(), i);
  }
  const std::size_t count = std::min<std::size_t>(nearest.size(), kRuinedExamined);
  std::partial_sort(nearest.begin(), nearest.begin() + std::ptrdiff_t(count), nearest.end());
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < count; ++k) result.push_back(nearest[k].second);
  return result;
}

std::vector<Placement> Improving::ruined(std::uint64_t random) {
  std::vector<Placement> left = collage_.placements();
  Vec2 gap_px;
  if (!find_gap(collage_.free(), random, gap_px)) return left;
  std::vector<std::pair<float, std::size_t>> nearest;
  for (const std::size_t i : pieces_near(gap_px)) {
    nearest.emplace_back(collage_.distance_px(left[i], gap_px), i);
  }
  std::sort(nearest.begin(), nearest.end());
  nearest.resize(std::min<std::size_t>(nearest.size(), 1 + mix_bits(random) % std::uint64_t(kMostRuined)));
  std::vector<bool> out(left.size(), false);
  for (const auto& [distance_px, i] : nearest) out[i] = true;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!out[i]) left[kept++] = left[i];
  }
  left.resize(kept);
  return left;
}

void Improving::fill(const StopCheck& check_stop) {
  do check_stop();
  while (collage_.placements().size() < most_pieces_ && filling_.place_one());
}

/// The loss that a trial must reduce: free area, area covered twice, part of the area of dwarfs, the cost of repeated
/// drawings and the cost of wrong colours.
std::int64_t Improving::loss_256ths_px2() {
  const std::int64_t free = collage_.free().free_256ths_px2();
  const std::int64_t loss = relax_ ? 2 * free + area_256ths_px2(collage_.placements()) : free;
  return loss + dwarfs_256ths_px2() + repeated_256ths_px2() + off_colour_.loss_256ths_px2(collage_.placements());
}

std::int64_t Improving::repeated_256ths_px2() const {
  if (repetition_ == RepetitionCosts{}) return 0;
  std::vector<PlacedDrawing> pieces;
  for (const Placement& p : collage_.placements()) {
    pieces.push_back(placed_drawing(shapes_.silhouette(p.shape), p.canvas_from_shape));
  }
  return std::int64_t(256 * repetition_px2(std::move(pieces), repetition_, collage_.free().grid().period()));
}

std::int64_t Improving::dwarfs_256ths_px2() const {
  std::int64_t sum = 0;
  for (const Placement& p : collage_.placements()) {
    const double scale_px = p.canvas_from_shape.scale();
    if (is_dwarf(scale_px, pieces_)) sum += std::int64_t(256 * dwarf_loss_ * scale_px * scale_px);
  }
  return sum;
}

void Improving::recreate(std::uint32_t trial, const StopCheck& check_stop) {
  std::vector<Placement> rest = ruined(mix_bits(seed_ ^ mix_bits(kRuin ^ (std::uint64_t(trial) << 32))));
  if (rest.size() == collage_.placements().size()) return;
  filling_.start(collage_.replace_placements(std::move(rest)));
  collage_.schedule().set_first_pass(kPassesPerTrial * trial);
  fill(check_stop);
}

void Improving::relax_all(const std::vector<Placement>& from, std::span<const RelaxationSchedule> schedules,
                          std::uint32_t trial, const StopCheck& check_stop) {
  filling_.start(
      collage_.replace_placements(relaxing_.relaxed(from, collage_.open_shapes().given(), schedules, check_stop)));
  collage_.schedule().set_first_pass(kPassesPerTrial * trial);
  fill(check_stop);
}

Trial Improving::try_once(std::uint32_t trial, const StopCheck& check_stop, std::uint32_t earlier) {
  const auto change = [&] {
    if (relax_ && (trial - earlier) % trials_per_relaxation_ == 0) {
      relax_all(collage_.placements(), kRelaxCollage, trial, check_stop);
    } else {
      recreate(trial, check_stop);
    }
  };
  return try_with(change, check_stop);
}

Trial Improving::relax_replaced_pieces(const std::vector<Placement>& placements, std::uint32_t trial,
                                       const StopCheck& check_stop) {
  return try_with([&] { relax_all(placements, kSettleCollage, trial, check_stop); }, check_stop);
}

Trial Improving::try_with(const std::function<void()>& change, const StopCheck& check_stop) {
  const std::vector<Placement> before = collage_.placements();
  const std::int64_t loss_before = loss_256ths_px2();
  const std::uint64_t missing_before = collage_.open_shapes().shortage().pieces;
  try {
    change();
    check_stop();
  } catch (const Interrupted&) {
    collage_.replace_placements(before);
    throw;
  }
  if (collage_.open_shapes().shortage().pieces <= missing_before && loss_256ths_px2() < loss_before) return Trial::kept;
  collage_.replace_placements(before);
  return Trial::put_back;
}

}  // namespace tessera::master
