// The best partial matches of two sets of curves, by comparing their PADs pair by pair, without an index (paper,
// section 3.3 and Fig. 14). The result is the poses in which B lies along A, and the parts of both that follow one
// another.
#pragma once

#include <cstddef>
#include <vector>

#include "core/recognition/matched_runs.h"
#include "core/recognition/query.h"

namespace tessera {

/// A set of curves, at least one, each without a curve_fault(). `least_sigma`: the narrowest smoothing that their noise
/// needs, in their units (QuerySettings::least_sigma).
struct MatchedCurves {
  std::vector<Curve> curves;
  float least_sigma = 1.5f;
};

struct CurveMatch {
  Similarity a_from_b;
  std::vector<MatchedRun> runs;  // arclengths of the curves as they were given
  float part_of_a = 0;           // matched arclength as a fraction of A's total, 0 to 1
  float part_of_b = 0;
  float similarity = 0;  // how closely B follows A within the runs: 1 on it, 0 at the largest distance that counts
  /// The matched length, weighted by closeness, as a fraction of the geometric mean of both lengths: 1 for a shape and
  /// itself. The mean prevents that a tiny or a huge B wins.
  float score = 0;
};

/// The `most` best matches with different poses, the best first. Empty if nothing matches. If a curve of A or B is
/// open, the directions of curves do not count.
std::vector<CurveMatch> matched_curves(const MatchedCurves& a, const MatchedCurves& b, std::size_t most,
                                       const PadParameters& pad = {});

}  // namespace tessera
