/// @file
/// The best partial matches of two outlines.
#pragma once

#include <cstddef>
#include <vector>

#include "tessera/matching/export.h"
#include "tessera/matching/outline.h"
#include "tessera/matching/similarity.h"

namespace tessera::matching {

/// A part of a curve, as arclengths from the curve's first point in its units; from < to. `to` exceeds the curve's length
/// where the part continues over the first point of a closed curve.
struct CurvePart {
  std::size_t curve = 0;  ///< index of the curve in its outline
  double from = 0;
  double to = 0;
};

/// A part of a curve of B that follows a part of a curve of A.
struct MatchedRun {
  CurvePart of_a;
  CurvePart of_b;
  bool reversed = false;  ///< B runs in the opposite direction, which is possible for lines without an interior
};

/// One way to lay B onto A.
struct Match {
  Similarity a_from_b;
  std::vector<MatchedRun> runs;
  double part_of_a = 0;  ///< matched arclength divided by the length of all of A's curves, 0 to 1
  double part_of_b = 0;
  /// how closely B follows A within the runs: 1 where they are equal, 0 at the largest distance that counts
  double similarity = 0;
  /// How much of both follows one another, and how closely. It is the length that B follows, weighted by closeness and
  /// divided by the geometric mean of both lengths. An outline and itself have 1. Unrelated silhouettes reach 0.2 to 0.4,
  /// because parts of them are similar.
  double score = 0;
};

/// Finds poses of B on A at which as much as possible of their curves follow one another (paper, section 3.3 and Fig. 14).
/// B may be turned, scaled and moved, but not mirrored. It may be a part of A, or have a part in common with A.
///
/// Poses are derived from curves that have at least a 64th of the length of all curves. Shorter curves are followed where
/// such a pose lays them onto each other.
///
/// Returns the `most` best matches with different poses, the best first. Empty where nothing matches. Throws Error as
/// check() does. Several threads may call it at once.
TESSERA_MATCHING_API std::vector<Match> match(const Outline& a, const Outline& b, std::size_t most = 1);

}  // namespace tessera::matching
