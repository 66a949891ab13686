// One round of matching (paper section 3.3): target samples in, refined candidates of the whole library out.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/run_statistics.h"
#include "core/matching/matcher.h"

namespace tessera {

struct MatchPlan {
  std::uint64_t pairs_per_sample = 0;  // top K % of the library's PADs, capped by match.most_pairs; 0 = no PAD dockings
  std::uint32_t tangent_dockings = 0;
  bool first_drawn = false;  // as in DockRequest
};

MatchPlan match_plan(const MatchSettings& settings, std::uint64_t library_pads);

struct MatchRound {
  /// The feasible dockings, at most kRefined for each sample, in the order of the samples.
  std::vector<RefinedDocking> refined;
  /// Per sample: true if a limit left something out, so that matching the sample again may find more.
  std::vector<bool> truncated;
};

/// Adds to the counters and times of `statistics`. Calls `meanwhile` once while the matcher works on a question.
MatchRound match(
    Matcher& matcher, const std::vector<TargetSample>& samples, const MatchPlan& plan, std::uint64_t library_pads,
    RunStatistics& statistics, const std::function<void()>& meanwhile = [] {});

/// Whether two poses of one shape would look the same: their positions, and their rotations with scales, differ by less
/// than `tolerance` times b's scale.
bool near_copy(const Similarity& a, const Similarity& b, float tolerance);

}  // namespace tessera
