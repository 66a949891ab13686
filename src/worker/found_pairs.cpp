#include "worker/found_pairs.h"

#include <algorithm>
#include <tuple>

namespace tessera::worker {
namespace {

const LevelRecord& level_of(u32 source_of_shape, const MatchRecord& match) {
  const LevelRecord* level = match.level;
  while (source_of_shape >= level->first + level->count) ++level;
  return *level;
}

bool by_source(const PairRecord& a, const PairRecord& b) { return a.source < b.source; }

/// `of_shape`: by source. Not found: farther than all that were.
u32 distance_at(u32 source, std::span<const PairRecord> of_shape) {
  const auto at = std::lower_bound(of_shape.begin(), of_shape.end(), PairRecord{0, source, 0}, by_source);
  return at != of_shape.end() && at->source == source ? at->distance : ~0u;
}

/// Along its level's closed curve; of equal neighbours the last one is.
bool is_minimum(const PairRecord& pair, std::span<const PairRecord> of_shape, const MatchRecord& match) {
  const u32 of_curve = pair.source % match.sources;
  const LevelRecord& level = level_of(of_curve, match);
  const u32 last = level.count - 1;
  const u32 place = of_curve - level.first;
  const u32 before = place == 0 ? pair.source + last : pair.source - 1;
  const u32 after = place == last ? pair.source - last : pair.source + 1;
  return pair.distance <= distance_at(before, of_shape) && pair.distance < distance_at(after, of_shape);
}

void append_best(std::vector<PairRecord>& docked, std::span<const PairRecord> of_shape, const MatchRecord& match) {
  const std::size_t first = docked.size();
  for (const PairRecord& pair : of_shape) {
    if (is_minimum(pair, of_shape, match)) docked.push_back(pair);
  }
  std::sort(docked.begin() + std::ptrdiff_t(first), docked.end(), [](const PairRecord& a, const PairRecord& b) {
    return std::tie(a.distance, a.source) < std::tie(b.distance, b.source);
  });
  docked.resize(std::min(docked.size(), first + std::size_t(kPairsPerShape)));
}

}  // namespace

std::vector<PairRecord> docked_pairs(std::span<PairRecord> found, const MatchRecord& match) {
  std::sort(found.begin(), found.end(), by_source);
  std::vector<PairRecord> docked;
  for (std::size_t first = 0, end = 0; first < found.size(); first = end) {
    const u32 next_shape = (found[first].source / match.sources + 1) * match.sources;
    while (end < found.size() && found[end].source < next_shape) ++end;
    append_best(docked, found.subspan(first, end - first), match);
  }
  return docked;
}

}  // namespace tessera::worker
