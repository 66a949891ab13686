#include "core/matching/match_round.h"

#include <algorithm>
#include <cmath>

#include "core/base/stopwatch.h"
#include "core/matching/pair_limits.h"

namespace tessera {
namespace {

/// Per sample: the number of bins whose pairs are docked.
std::vector<std::uint32_t> bin_limits(Matcher& matcher, const std::vector<TargetSample>& samples,
                                      std::uint64_t pairs_per_sample) {
  if (pairs_per_sample == 0) return std::vector<std::uint32_t>(samples.size(), 0);
  return pair_limits(matcher, samples, pairs_per_sample);
}

/// The best kRefined distinct dockings of each sample; `dockings` come by sample, best first.
std::vector<Docking> distinct(const std::vector<Docking>& dockings, std::vector<bool>& truncated) {
  std::vector<Docking> kept;
  std::size_t first = 0;  // index in `kept` of the current sample's first docking
  for (std::size_t i = 0; i < dockings.size(); ++i) {
    const Docking& d = dockings[i];
    if (i == 0 || d.sample != dockings[i - 1].sample) first = kept.size();
    bool repeated = false;
    for (std::size_t k = first; k < kept.size() && !repeated; ++k) {
      repeated = kept[k].shape == d.shape && near_copy(kept[k].canvas_from_shape, d.canvas_from_shape, kSameDocking);
    }
    if (repeated) continue;
    if (kept.size() - first < kRefined) {
      kept.push_back(d);
    } else {
      truncated[d.sample] = true;
    }
  }
  return kept;
}

}  // namespace

bool near_copy(const Similarity& a, const Similarity& b, float tolerance) {
  const float reach = tolerance * b.scale();
  return std::abs(a.tx - b.tx) + std::abs(a.ty - b.ty) < reach && norm({a.a - b.a, a.b - b.b}) < reach;
}

MatchPlan match_plan(const MatchSettings& settings, std::uint64_t library_pads) {
  std::uint64_t pairs = std::uint64_t(settings.top_percent / 100.0 * double(library_pads));
  if (settings.most_pairs > 0) pairs = std::min(pairs, std::uint64_t(settings.most_pairs));
  return {pairs, std::uint32_t(settings.tangent_dockings)};
}

MatchRound match(Matcher& matcher, const std::vector<TargetSample>& samples, const MatchPlan& plan,
                 std::uint64_t library_pads, RunStatistics& statistics, const std::function<void()>& meanwhile) {
  Stopwatch watch;
  MatchRound round;
  round.truncated.assign(samples.size(), plan.tangent_dockings > 0);
  if (samples.empty()) return round;
  DockRequest request{samples, bin_limits(matcher, samples, plan.pairs_per_sample), plan.tangent_dockings,
                      plan.first_drawn};
  statistics.prune_s += watch.lap();
  for (std::size_t t = 0; t < samples.size(); ++t) {
    if (request.bin_limit[t] > 0 && request.bin_limit[t] < kDistanceBins) round.truncated[t] = true;
  }
  matcher.post_dock(request);
  meanwhile();
  const DockReply docked = matcher.take_dock();
  const std::vector<Docking> chosen = distinct(docked.dockings, round.truncated);
  matcher.post_refine(chosen);
  for (const RefinedDocking& refined : matcher.take_refine()) {
    if (refined.feasible) round.refined.push_back(refined);
  }
  statistics.dock_s += watch.lap();
  const std::uint64_t pads = plan.pairs_per_sample > 0 ? library_pads : 0;
  statistics.docking_choices += samples.size() * (pads + plan.tangent_dockings);
  statistics.dockings_evaluated += docked.evaluated;
  statistics.refined += chosen.size();
  statistics.target_samples += samples.size();
  return round;
}

}  // namespace tessera
