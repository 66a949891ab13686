// Poses in which some curves may lie on others, by the PADs of both, pair by pair (paper, section 3.3): for two drawings
// that no index was made of.
#pragma once

#include <vector>

#include "core/geometry/similarity.h"
#include "core/recognition/query.h"

namespace tessera {

/// One or two poses (a_from_b) for each pair of PADs that are alike, without order. Two PADs are compared by the levels
/// that both have, and only where both curves were smoothed alike: smoothing by one width of A and one of B belongs to
/// scales of half an octave. Least squares over all key points lays parts of the same shape onto each other. Where
/// these leave a residual, as between different shapes, the point and the ends of levels 0 and 1 give a second pose.
std::vector<Similarity> curve_poses(const Query& a, const Query& b, int pad_levels);

/// One pose for each pair of arcs of A and B that run alike: parts without corners, on which PADs find few levels.
std::vector<Similarity> arc_pair_poses(const Query& a, const Query& b);

/// Poses that lay the open curves of B that are nearly straight onto those of A, end to end and both ways round. Such
/// curves turn too little for a PAD: the paper's first limitation.
std::vector<Similarity> straight_poses(const std::vector<Curve>& a, const std::vector<Curve>& b);

}  // namespace tessera
