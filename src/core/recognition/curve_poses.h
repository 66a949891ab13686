// Poses in which some curves may lie on others, by comparing their PADs pair by pair (paper, section 3.3), for two
// drawings without an index.
#pragma once

#include <vector>

#include "core/geometry/similarity.h"
#include "core/recognition/query.h"

namespace tessera {

/// One or two poses (a_from_b) for each pair of similar PADs, in no order. Two PADs are compared by the levels that
/// both have, and only if both curves were smoothed alike. So a pair of widths of A and B belongs to scales within half
/// an octave. Least squares over all key points fits parts of the same shape. If a residual remains, as between
/// different shapes, the point and the ends of levels 0 and 1 give a second pose.
std::vector<Similarity> curve_poses(const Query& a, const Query& b, int pad_levels);

/// One pose for each pair of similar arcs of A and B. Arcs find parts without corners, where PADs have few levels.
std::vector<Similarity> arc_pair_poses(const Query& a, const Query& b);

/// Poses that lay nearly straight open curves of B on those of A, end to end, in both directions. Such curves turn too
/// little for a PAD: the paper's first limitation.
std::vector<Similarity> straight_poses(const std::vector<Curve>& a, const std::vector<Curve>& b);

}  // namespace tessera
