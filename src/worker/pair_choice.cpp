#include "worker/pair_choice.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace tessera::worker {
namespace {

constexpr u32 kFar = ~0u;

/// Sorts by digits of 11 bits, from the lowest on. For the thousand pairs of a sample it takes a third of the time of
/// std::sort.
void sort_by_source(std::span<PairKey> keys) {
  constexpr u32 kDigitBits = 11;
  constexpr u32 kDigits = 1 << kDigitBits;
  constexpr std::size_t kFew = 128;
  if (keys.size() < kFew) return std::sort(keys.begin(), keys.end());
  u32 bits = 0;
  for (const PairKey key : keys) bits |= source_of(key);
  std::vector<PairKey> other(keys.size());
  std::array<u32, kDigits> next;
  for (u32 shift = 0; shift < 32 && bits >> shift != 0; shift += kDigitBits) {
    const auto digit = [&](PairKey key) { return source_of(key) >> shift & (kDigits - 1); };
    next.fill(0);
    for (const PairKey key : keys) ++next[digit(key)];
    std::exclusive_scan(next.begin(), next.end(), next.begin(), 0u);
    for (const PairKey key : keys) other[next[digit(key)]++] = key;
    std::copy(other.begin(), other.end(), keys.begin());
  }
}

/// The best pairs of one shape, by distance, then by source.
class BestPairs {
 public:
  /// Keeps the pair if it is among the best. Sources come in ascending order, so of equal distances the later pair comes
  /// behind.
  void keep(PairKey pair) {
    std::size_t at = count_;
    for (; at > 0 && distance_of(best_[at - 1]) > distance_of(pair); --at) {
      if (at < best_.size()) best_[at] = best_[at - 1];
    }
    if (at == best_.size()) return;
    best_[at] = pair;
    count_ = std::min(count_ + 1, best_.size());
  }

  std::span<const PairKey> all() const { return std::span(best_).first(count_); }

 private:
  std::array<PairKey, kPairsPerShape> best_{};
  std::size_t count_ = 0;
};

/// The distance of `source`, or kFar where it was not found. `of_level` is sorted by source.
u32 distance_at(u32 source, std::span<const PairKey> of_level) {
  const auto at = std::lower_bound(of_level.begin(), of_level.end(), PairKey(source) << 32);
  return at != of_level.end() && source_of(*at) == source ? distance_of(*at) : kFar;
}

/// Keeps the local minima of a level. `of_level`: the pairs of one shape, by source. The level's sources are [first, first
/// + count) and lie on a closed curve. Of equal neighbours the last one is the minimum.
void keep_minima(std::span<const PairKey> of_level, u32 first, u32 count, BestPairs& best) {
  for (std::size_t i = 0; i < of_level.size(); ++i) {
    const u32 source = source_of(of_level[i]);
    const u32 distance = distance_of(of_level[i]);
    const u32 before = source == first                                     ? distance_at(first + count - 1, of_level)
                       : i > 0 && source_of(of_level[i - 1]) == source - 1 ? distance_of(of_level[i - 1])
                                                                           : kFar;
    if (distance > before) continue;
    const bool next_is_found = i + 1 < of_level.size() && source_of(of_level[i + 1]) == source + 1;
    const u32 after = source == first + count - 1 ? distance_at(first, of_level)
                      : next_is_found             ? distance_of(of_level[i + 1])
                                                  : kFar;
    if (distance < after) best.keep(of_level[i]);
  }
}

}  // namespace

std::vector<PairRecord> docked_pairs(u32 sample, std::span<PairKey> found, const MatchRecord& match) {
  sort_by_source(found);
  std::vector<PairRecord> docked;
  for (std::size_t i = 0; i < found.size();) {
    const u32 of_shape = source_of(found[i]) / match.sources * match.sources;
    BestPairs best;
    for (u32 k = 0; k < match.level_count; ++k) {
      const u32 first = of_shape + match.level[k].first;
      const std::size_t begin = i;
      while (i < found.size() && source_of(found[i]) - first < match.level[k].count) ++i;
      keep_minima(found.subspan(begin, i - begin), first, match.level[k].count, best);
    }
    for (const PairKey pair : best.all()) docked.push_back({sample, source_of(pair), distance_of(pair)});
  }
  return docked;
}

}  // namespace tessera::worker
