// All segments of a library shape's outer curve, which target segments are compared with.
#pragma once

#include <cstddef>
#include <vector>

#include "bench/segments/curve_segment.h"
#include "core/shape/shape.h"

namespace tessera::bench {

/// Number of lengths of segments, relative to the curve: from a few hundredths to more than half of it, four in each
/// octave. The scale that a pair of segments implies is then at most 9 % off; refinement corrects that.
inline constexpr int kSegmentLengths = 14;
float segment_part(int length);  // 0..1, of length 0..kSegmentLengths - 1

/// The segments at one smoothing level. They begin where the level has its PADs, with each of the lengths.
struct LevelSegments {
  std::size_t starts = 0;
  std::vector<CurveSegment> segments;  // in shape units; ordered by length, then by start

  const CurveSegment& at(int length, std::size_t start) const { return segments[std::size_t(length) * starts + start]; }
};

/// The segments at these smoothing levels (indices into kSmoothingLevels), in their order. `shape` has its level
/// curves.
std::vector<LevelSegments> make_shape_segments(const Shape& shape, const std::vector<int>& levels,
                                               const ShapeDescriptor& descriptor);

}  // namespace tessera::bench
