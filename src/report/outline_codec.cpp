#include "report/outline_codec.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/geometry/curve_corners.h"

namespace tessera {
namespace {

constexpr float kUnitsPerPx = 8;
constexpr float kDistanceUnitsPerPx = 16;
constexpr float kTolerance_px = 0.1f;
constexpr std::uint8_t kFar = 255;

void append_number(std::uint64_t number, std::vector<std::uint8_t>& bytes) {
  for (; number >= 128; number >>= 7) bytes.push_back(std::uint8_t(number | 128));
  bytes.push_back(std::uint8_t(number));
}

/// A signed number, small ones of either sign in few bytes (zigzag).
void append_step(std::int64_t step, std::vector<std::uint8_t>& bytes) {
  append_number(std::uint64_t(step) << 1 ^ std::uint64_t(step >> 63), bytes);
}

std::int64_t units(float px) { return std::llround(double(px) * double(kUnitsPerPx)); }

/// The mean of the distances from one kept point up to the next one, which may be past the ring's end.
std::uint8_t mean_distance(const float* distances_px, std::size_t from, std::size_t to, float reach_px) {
  float sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += distances_px[i];
  const float mean_px = sum / float(to - from);
  if (mean_px >= reach_px) return kFar;
  return std::uint8_t(std::min(std::round(mean_px * kDistanceUnitsPerPx), float(kFar - 1)));
}

}  // namespace

void append_outline(const std::vector<std::vector<Vec2>>& rings, std::vector<std::uint8_t>& bytes) {
  append_number(rings.size(), bytes);
  std::int64_t x = 0, y = 0;
  for (const std::vector<Vec2>& ring : rings) {
    append_number(ring.size(), bytes);
    for (const Vec2 p : ring) {
      append_step(units(p.x) - x, bytes);
      append_step(units(p.y) - y, bytes);
      x = units(p.x);
      y = units(p.y);
    }
  }
}

PieceBlocks piece_blocks(const std::vector<JudgedPiece>& pieces, const std::vector<float>& distances_px,
                         float reach_px) {
  PieceBlocks blocks;
  const float* distances = distances_px.data();
  for (const JudgedPiece& piece : pieces) {
    std::vector<std::vector<Vec2>> rings;
    for (const std::vector<Vec2>& curve : piece.outline_px.curves) {
      if (curve.empty()) continue;
      const std::vector<std::size_t> corners = curve_corners(curve, kTolerance_px);
      std::vector<Vec2>& ring = rings.emplace_back();
      for (std::size_t c = 0; c < corners.size(); ++c) {
        ring.push_back(curve[corners[c]]);
        const std::size_t next = c + 1 < corners.size() ? corners[c + 1] : curve.size();
        blocks.contact.push_back(mean_distance(distances, corners[c], next, reach_px));
      }
      distances += curve.size();
    }
    append_outline(rings, blocks.outlines);
  }
  return blocks;
}

}  // namespace tessera
