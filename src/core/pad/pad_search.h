// Finds the PADs of an index that are nearest to a target PAD. Levels of the target may be missing, as along the
// boundary of a shape that is partly hidden. The distance is the largest difference of an element, as in Equation 1,
// but each side is divided by its longest known interval. Elements are the index's bytes: a difference is exact to
// 1/256.
//
// The search visits the index's blocks from the nearest box on and stops when no box can contain a nearer PAD. It finds
// exactly what a scan of all PADs finds (tests/core/pad/test_pad_search.cpp).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/pad/pad_index.h"

namespace tessera {

/// The PAD that a search looks for. Each side has its own number of known levels.
struct PadTarget {
  /// 2^-i times the length of level i, divided by the length of the side's last known level, for all levels below that
  /// one.
  std::array<float, kMaxPadLevels> left{};
  std::array<float, kMaxPadLevels> right{};
  int left_levels = 0;  // 2 .. levels, both sides
  int right_levels = 0;
  std::uint8_t sign = 0;       // sign_byte()
  ScaleWindow scales{0, 255};  // bytes of the lengths that estimate the scale
};

/// `left_levels`, `right_levels`: number of known levels of each side.
PadTarget make_pad_target(const ArclengthPyramid& pyramid, int left_levels, int right_levels);

struct PadHit {
  float distance = 0;
  std::uint32_t place = 0;  // index in the list of PADs that the index was made of

  friend bool operator==(const PadHit&, const PadHit&) = default;
};
inline bool operator<(const PadHit& a, const PadHit& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.place < b.place;
}

class PadSearch {
 public:
  /// `levels`: number of levels of the PADs.
  PadSearch(const PadIndex& index, std::span<const PadBytes> pads, int levels);

  /// The PADs nearest to the target, at most `most`. They are nearer than `reach`, lie within the target's scales,
  /// agree with its sign, and wanted(place) is true for them. Nearest first; ties go by place.
  std::vector<PadHit> nearest(const PadTarget& target, float reach, std::size_t most,
                              const std::function<bool(std::uint32_t place)>& wanted) const;

 private:
  using Row = std::array<std::uint8_t, kIndexFanOut>;
  using Distances = std::array<float, kIndexFanOut>;

  struct PadRows {  // 64 PADs
    std::array<Row, kMaxPadElements> element;
    Row scale;
    Row sign;  // 0: no PAD
  };
  struct BoxRows {  // 64 boxes
    std::array<Row, kMaxPadElements> low;
    std::array<Row, kMaxPadElements> high;
    Row scale_low;
    Row scale_high;
    Row signs;  // 0: no box
  };

  static std::vector<BoxRows> rows_of(const std::vector<PadBox>& boxes);
  void measure(const PadRows& rows, const PadTarget& target, Distances& distance) const;
  void bound(const BoxRows& rows, const PadTarget& target, Distances& distance) const;

  int levels_;
  std::vector<std::uint32_t> order_;
  std::vector<PadRows> pads_;    // by block
  std::vector<BoxRows> blocks_;  // by node: the boxes of its blocks
  std::vector<BoxRows> nodes_;   // in groups of 64 nodes
};

}  // namespace tessera
