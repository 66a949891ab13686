// From all pairs of target samples and a shard's PADs within reach to those that are docked: local minima along the
// shape's curve, the best few of each (sample, shape); select_pairs() of core/matching/pair_selection.h.
#pragma once

#include <span>
#include <vector>

#include "records.h"

namespace tessera::worker {

/// A pair of a known target sample as one number, so that many are sorted fast: by source, then by distance.
using PairKey = u64;
inline PairKey pair_key(const PairRecord& pair) { return PairKey(pair.source) << 32 | pair.distance; }
inline u32 source_of(PairKey key) { return u32(key >> 32); }
inline u32 distance_of(PairKey key) { return u32(key); }

/// `found`: all pairs of target sample `sample` that are nearer than some reach. A neighbour that is not among them is
/// farther, so that local minima show. Gives them by shape, then best first; the order of `found` changes.
std::vector<PairRecord> docked_pairs(u32 sample, std::span<PairKey> found, const MatchRecord& match);

}  // namespace tessera::worker
