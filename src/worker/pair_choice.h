// Chooses the pairs that are docked from all pairs of target samples and a shard's PADs within reach: local minima along
// the shape's curve, and of these the best few of each sample and shape. It is select_pairs() of
// core/matching/pair_selection.h.
#pragma once

#include <span>
#include <vector>

#include "records.h"

namespace tessera::worker {

/// A pair of a known target sample as one number, for fast sorting by source, then by distance.
using PairKey = u64;
inline PairKey pair_key(const PairRecord& pair) { return PairKey(pair.source) << 32 | pair.distance; }
inline u32 source_of(PairKey key) { return u32(key >> 32); }
inline u32 distance_of(PairKey key) { return u32(key); }

/// `found`: all pairs of target sample `sample` within some reach. A neighbour that is not in `found` is farther away, so
/// local minima can be seen. Returns the chosen pairs by shape, then best first. Changes the order of `found`.
std::vector<PairRecord> docked_pairs(u32 sample, std::span<PairKey> found, const MatchRecord& match);

}  // namespace tessera::worker
