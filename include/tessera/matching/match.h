/// @file
/// The best partial matches of two outlines.
#pragma once

#include <cstddef>
#include <vector>

#include "tessera/matching/export.h"
#include "tessera/matching/outline.h"
#include "tessera/matching/similarity.h"

namespace tessera::matching {

/// A part of a curve, as arclengths from its first point in its units, from < to. `to` is larger than the curve's length where
/// the part goes on beyond the first point of a closed curve.
struct CurvePart {
  std::size_t curve = 0;  ///< of the outline
  double from = 0;
  double to = 0;
};

/// A part of a curve of B that follows a part of a curve of A.
struct MatchedRun {
  CurvePart of_a;
  CurvePart of_b;
  bool reversed = false;  ///< B runs against A's direction, as lines without an interior may
};

/// One way to lay B onto A.
struct Match {
  Similarity a_from_b;
  std::vector<MatchedRun> runs;
  double part_of_a = 0;  ///< matched arclength as a part of the length of all of A's curves, 0 to 1
  double part_of_b = 0;
  double similarity = 0;  ///< how closely B follows A within the runs: 1 on it, 0 at the largest distance that counts
  /// How much follows one another, and how closely: 1 of an outline and itself. The length that B follows, by closeness, as a
  /// part of the geometric mean of both lengths. Unrelated silhouettes reach 0.2 to 0.4 by parts that are alike.
  double score = 0;
};

/// Lays B onto A, where as much as possible of their curves follow one another (paper, section 3.3 and Fig. 14). B may be
/// turned, scaled and moved, but not mirrored; it may be a part of A, or have a part in common with it.
///
/// Poses come from curves that have a 64th of the length of all curves, or more; shorter ones are followed where such a pose
/// lays them onto each other.
///
/// Returns the `most` best matches, the best first; their poses differ. Empty where nothing matches. Throws Error as
/// check() does. It may be called by several threads at once.
TESSERA_MATCHING_API std::vector<Match> match(const Outline& a, const Outline& b, std::size_t most = 1);

}  // namespace tessera::matching
