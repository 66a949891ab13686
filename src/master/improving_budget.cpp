#include "master/improving_budget.h"

#include <algorithm>

#include "master/replacing.h"

namespace tessera::master {
namespace {

constexpr std::uint64_t kExpectedPerPiece = 60;  // replacements a piece, before their time is known
constexpr double kMostReplacements = 1e15;
/// Two trials relax all pieces: one before the replacement phase and one after it.
constexpr std::uint64_t kTrialsAroundPhase = 2;

}  // namespace

double ImprovingBudget::area_px2(std::uint32_t region) const {
  return canvas_.regions.empty() ? canvas_.area_px2 : canvas_.regions[region].area_px2;
}

bool ImprovingBudget::may_go_on(std::uint32_t region, std::uint64_t trials, double improve_s) const {
  const ImproveSettings& limits = settings_.improve;
  return (limits.trials == 0 || trials < trials_below(region + 1)) &&
         (limits.seconds == 0 || improve_s < limits.seconds * part_below(region + 1));
}

std::uint64_t ImprovingBudget::replacements(std::uint32_t region, std::size_t pieces, const Replaced& so_far) const {
  if (settings_.improve.trials > 0) {
    const std::uint64_t trials = trials_below(region + 1) - trials_below(region);
    return std::uint64_t(kReplacementsPerTrial * kPartReplaced * double(trials - std::min(trials, kTrialsAroundPhase)));
  }
  if (so_far.trials == 0) return kExpectedPerPiece * pieces;
  const double begin_s = settings_.improve.seconds * part_below(region);
  double end_s = settings_.improve.seconds * part_below(region + 1);
  const double stop_s = settings_.stop.seconds;
  if (stop_s > 0) end_s = std::min(end_s, so_far.improve_s + stop_s - so_far.total_s);
  const double took_s = std::max(0., so_far.improve_s - begin_s);
  const double in_time = double(so_far.trials) * kPartReplaced * (end_s - begin_s) / took_s;
  return std::uint64_t(in_time < kMostReplacements ? std::max(0., in_time) : kMostReplacements);
}

/// The trials of all regions before `end`, shared out by area. Each region that has any area gets one trial at least, if
/// there are enough: it relaxes all pieces of the region.
std::uint64_t ImprovingBudget::trials_below(std::uint32_t end) const {
  const auto has_area = [](const CanvasRegion& region) { return region.area_px2 > 0; };
  auto left = std::uint64_t(std::count_if(canvas_.regions.begin(), canvas_.regions.end(), has_area));
  const auto trials = std::uint64_t(settings_.improve.trials);
  if (left < 2 || trials < left) return share_below(end);
  std::uint64_t below = 0;
  for (std::uint32_t r = 1; r <= end; ++r) {
    if (!has_area(canvas_.regions[r - 1])) continue;
    below = std::min(std::max(share_below(r), below + 1), trials - --left);
  }
  return below;
}

std::uint64_t ImprovingBudget::share_below(std::uint32_t end) const {
  return std::uint64_t(double(settings_.improve.trials) * part_below(end));
}

/// The part (0..1) of the regions' area that lies in the regions before `end`.
double ImprovingBudget::part_below(std::uint32_t end) const {
  if (end == 0) return 0;
  double before_px2 = 0;
  double all_px2 = 0;
  for (std::size_t r = 0; r < canvas_.regions.size(); ++r) {
    all_px2 += canvas_.regions[r].area_px2;
    if (r < end) before_px2 += canvas_.regions[r].area_px2;
  }
  return before_px2 == all_px2 ? 1 : before_px2 / all_px2;
}

}  // namespace tessera::master
