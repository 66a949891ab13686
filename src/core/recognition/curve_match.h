// The best partial matches of two sets of curves, pair by pair of their PADs, without an index (paper, section 3.3 and
// Fig. 14): in which poses B lies along A, and which parts of both follow one another.
#pragma once

#include <cstddef>
#include <vector>

#include "core/recognition/matched_runs.h"
#include "core/recognition/query.h"

namespace tessera {

/// Some curves, at least one, each without a curve_fault(), and the narrowest smoothing that their noise needs, in their
/// units (QuerySettings::least_sigma).
struct MatchedCurves {
  std::vector<Curve> curves;
  float least_sigma = 1.5f;
};

struct CurveMatch {
  Similarity a_from_b;
  std::vector<MatchedRun> runs;  // arclengths of the curves as they were given
  float part_of_a = 0;           // matched arclength in parts of all of A's, 0 to 1
  float part_of_b = 0;
  float similarity = 0;  // how closely B follows A within the runs: 1 on it, 0 at the largest distance that counts
  /// How much follows one another, and how closely: 1 of a shape and itself. The length that B follows, by closeness, in
  /// parts of the geometric mean of both lengths, so that neither a tiny B nor a huge one wins.
  float score = 0;
};

/// The `most` best matches, the best first; their poses differ. Empty where nothing matches. Where a curve of A or B is
/// open, directions of curves do not count.
std::vector<CurveMatch> matched_curves(const MatchedCurves& a, const MatchedCurves& b, std::size_t most,
                                       const PadParameters& pad = {});

}  // namespace tessera
