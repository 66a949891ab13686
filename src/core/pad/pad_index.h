// A spatial index of PADs: an order in which similar PADs follow one another, with a box around every 64 of them and
// one around every 64 boxes. A search for the pairs within reach of a target skips the boxes that cannot contain any.
// The distance is a maximum norm (Eq. 1), for which boxes give tight bounds. The search finds exactly what a full scan
// finds (kernels/pad_index.cl; tests/core/pad/test_pad_index.cpp).
//
// It is a k-d tree (Bentley 1975) on bytes that splits at the median of the widest element, stored without pointers:
// block b holds the places [64 b, 64 b + 64) of the order, node n the blocks [64 n, 64 n + 64).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/pad/pad_filter.h"

namespace tessera {

inline constexpr std::uint32_t kIndexFanOut = 64;

/// The number of shapes in a segment of the library. Each level of a segment has an index of its own, so that indexes
/// are made, kept and read piece by piece. Larger segments give tighter boxes but need more memory.
inline constexpr std::uint32_t kSegmentShapes = 2048;

/// The bytes of a PAD that the filter tests.
struct PadBytes {
  std::array<std::uint8_t, kMaxPadElements> element{};  // pad_byte()
  std::uint8_t scale = 0;                               // scale_byte()
  std::uint8_t sign = 0;                                // sign_byte(), never 0
};

PadBytes pad_bytes(const QuantisedPad& pad, float scale_length, float convexity);

/// Inclusive bounds of the bytes of some PADs. A new box contains none.
struct PadBox {
  PadBox() {
    low.fill(255);
    high.fill(0);
  }

  std::array<std::uint8_t, kMaxPadElements> low;
  std::array<std::uint8_t, kMaxPadElements> high;
  std::uint8_t scale_low = 255;
  std::uint8_t scale_high = 0;
  std::uint8_t signs = 0;  // all signs that occur

  friend bool operator==(const PadBox&, const PadBox&) = default;
};

struct PadIndex {
  std::vector<std::uint32_t> order;  // indices in the list of PADs that the index was made of
  std::vector<PadBox> blocks;
  std::vector<PadBox> nodes;
};

/// Weight of the scales' variance against that of an element, when a branch of the tree is split. Docked pairs agree in
/// their elements to a few percent, and their window of scales is an octave wide: here the weight hardly matters (3,000
/// shapes, shares of 1, 1/4, 1/16, 1/64: 1.57, 1.52, 1.47, 1.47 % of the blocks are visited).
inline constexpr double kDockingScaleShare = 1.0 / 16;
/// Weight of the scales' variance for recognition, which searches PADs with few known elements at scales of half an
/// octave. Here the scale tells most (700 shapes, shares of 1/16, 1, 10: 95, 68, 48 microseconds a search).
inline constexpr double kRecognitionScaleShare = 10;

/// The order of an index. The first `elements` elements of a PAD count. The same PADs give the same order.
std::vector<std::uint32_t> pad_order(std::span<const PadBytes> pads, int elements,
                                     double scale_share = kDockingScaleShare);

/// The index with an order of all these PADs. Any order gives the same search results; a good one is faster.
PadIndex boxed(std::vector<std::uint32_t> order, std::span<const PadBytes> pads);

PadIndex make_pad_index(std::span<const PadBytes> pads, int elements, double scale_share = kDockingScaleShare);

}  // namespace tessera
