#include "core/matching/deck.h"

#include <algorithm>

#include "core/base/portable_math.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

/// Draws `runs` runs of `length` places out of `all`; runs may overlap. Empty if the runs would cover all places.
std::vector<std::uint32_t> drawn_places(std::uint64_t key, std::uint32_t all, std::uint32_t runs,
                                        std::uint32_t length) {
  std::vector<std::uint32_t> places;
  if (all <= runs * length) return places;
  const std::uint32_t starts = (all + length - 1) / length;
  for (std::uint32_t run = 0; run < runs; ++run) {
    const std::uint64_t bits = mix_bits(key ^ run);
    const std::uint32_t first = std::uint32_t(((bits >> 32) * starts) >> 32) * length;
    for (std::uint32_t place = first; place < std::min(all, first + length); ++place) places.push_back(place);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

}  // namespace

Deck draw_deck(std::uint64_t seed, std::span<const TargetSample> samples, std::uint32_t library_shapes,
               std::uint32_t open_shapes, std::uint32_t near_length) {
  Deck deck;
  if (library_shapes <= kWholeDeck) return deck;
  std::uint64_t key = mix_bits(seed);
  for (const TargetSample& sample : samples) {
    key = mix_bits(key ^ ((std::uint64_t(edge_number(sample.id)) << 32) | sample.pass));
  }
  deck.open = drawn_places(key, open_shapes, kDeckRuns, kDeckRun);
  deck.near = drawn_places(mix_bits(key), near_length, kNearDeckRuns, kNearDeckRun);
  return deck;
}

}  // namespace tessera
