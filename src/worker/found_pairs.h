// From all pairs of target samples and a shard's PADs within reach to those that are docked: local minima along the
// shape's curve, the best few of each (sample, shape); select_pairs() of core/matching/pair_selection.h.
#pragma once

#include <span>
#include <vector>

#include "records.h"

namespace tessera::worker {

/// `found`: all pairs of one target sample that are nearer than some reach. A neighbour that is not among them is
/// farther, so that local minima show. Gives them by shape, then best first; the order of `found` changes.
std::vector<PairRecord> docked_pairs(std::span<PairRecord> found, const MatchRecord& match);

}  // namespace tessera::worker
