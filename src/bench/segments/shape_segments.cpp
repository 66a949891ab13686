#include "bench/segments/shape_segments.h"

#include <cmath>

namespace tessera::bench {
namespace {

constexpr float kShortestPart = 0.06f;
constexpr float kLengthsInOctave = 4;

/// `count` points of the closed curve from `first` on.
std::vector<Vec2> stretch(const std::vector<Vec2>& curve, std::size_t first, std::size_t count) {
  std::vector<Vec2> line;
  line.reserve(count);
  for (std::size_t i = 0; i < count; ++i) line.push_back(curve[(first + i) % curve.size()]);
  return line;
}

}  // namespace

float segment_part(int length) { return kShortestPart * std::exp2(float(length) / kLengthsInOctave); }

std::vector<LevelSegments> make_shape_segments(const Shape& shape, const std::vector<int>& levels,
                                               const ShapeDescriptor& descriptor) {
  std::vector<LevelSegments> all;
  for (const int level : levels) {
    const std::vector<Vec2>& curve = shape.levels[std::size_t(level)].points;
    LevelSegments& made = all.emplace_back();
    made.starts = std::size_t(kSmoothingLevels[std::size_t(level)].samples);
    for (int length = 0; length < kSegmentLengths; ++length) {
      const auto edges = std::size_t(std::lround(segment_part(length) * float(curve.size())));
      for (std::size_t start = 0; start < made.starts; ++start) {
        made.segments.push_back(
            make_segment(stretch(curve, start * curve.size() / made.starts, edges + 1), descriptor));
      }
    }
  }
  return all;
}

}  // namespace tessera::bench
