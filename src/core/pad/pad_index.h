// An order of PADs in which those that follow one another are alike, with a box round every 64 of them and one round
// every 64 boxes: a search for the pairs within reach of a target skips the boxes that cannot hold any. The distance is
// a maximum norm (Eq. 1), so boxes are its natural bound, and the search finds what a full scan finds
// (kernels/pad_index.cl; tests/core/pad/test_pad_index.cpp).
//
// A k-d tree (Bentley 1975) that splits at the median of the widest element, of bytes, laid out without pointers:
// block b holds the places [64 b, 64 b + 64) of the order, node n the blocks [64 n, 64 n + 64).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/pad/pad_filter.h"

namespace tessera {

inline constexpr std::uint32_t kIndexFanOut = 64;

/// Each level of so many shapes of a library has an index of its own, so that it can be made, kept and read piece by
/// piece. The more, the tighter are the boxes, and the more memory it takes to make one.
inline constexpr std::uint32_t kSegmentShapes = 2048;

/// What the filter knows of a PAD.
struct PadBytes {
  std::array<std::uint8_t, kMaxPadElements> element{};  // pad_byte()
  std::uint8_t scale = 0;                               // scale_byte()
  std::uint8_t sign = 0;                                // sign_byte(), never 0
};

PadBytes pad_bytes(const QuantisedPad& pad, float scale_length, float convexity);

/// Bounds of the bytes of some PADs, inclusive. As it is made it holds none.
struct PadBox {
  PadBox() {
    low.fill(255);
    high.fill(0);
  }

  std::array<std::uint8_t, kMaxPadElements> low;
  std::array<std::uint8_t, kMaxPadElements> high;
  std::uint8_t scale_low = 255;
  std::uint8_t scale_high = 0;
  std::uint8_t signs = 0;  // all that occur

  friend bool operator==(const PadBox&, const PadBox&) = default;
};

struct PadIndex {
  std::vector<std::uint32_t> order;  // places in what the index was made of
  std::vector<PadBox> blocks;
  std::vector<PadBox> nodes;
};

/// How much the variance of the scales counts beside that of an element, when a branch of the tree is split. Pairs that
/// are docked agree in their elements to a few percent, and their window of scales is an octave wide: here it hardly
/// matters (3,000 shapes, shares of 1, 1/4, 1/16, 1/64: 1.57, 1.52, 1.47, 1.47 % of the blocks are visited).
inline constexpr double kDockingScaleShare = 1.0 / 16;
/// Recognition looks for PADs of which few elements are known, at scales of half an octave: the scale tells most (700
/// shapes, shares of 1/16, 1, 10: 95, 68, 48 microseconds a search).
inline constexpr double kRecognitionScaleShare = 10;

/// The order of an index. `elements`: of a PAD, from the first on. The same PADs give the same order.
std::vector<std::uint32_t> pad_order(std::span<const PadBytes> pads, int elements,
                                     double scale_share = kDockingScaleShare);

/// The index with an order of all these PADs. Whatever the order, a search finds the same; it decides how fast.
PadIndex boxed(std::vector<std::uint32_t> order, std::span<const PadBytes> pads);

PadIndex make_pad_index(std::span<const PadBytes> pads, int elements, double scale_share = kDockingScaleShare);

}  // namespace tessera
