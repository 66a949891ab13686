// The numbers of nesting that no user sets. Measured on albano, jakobs1, shapes0 and swim (docs/measurements/nesting.md).
#pragma once

#include <cstdint>

namespace tessera::nest_tuning {

/// Depth to which pieces may lie in each other, parts of the strip's height: what lets them touch in spite of rounding.
/// Corners are moved by 8 times that at most, of either piece: 1e-6 is what is promised.
inline constexpr double kInset = 2e-8;
/// What all sides of a search outline may add, parts of the piece's area.
inline constexpr double kAddedArea = 0.001;
/// Discs a shape: more cost time and tell little more.
inline constexpr int kPoles = 12;
/// Where discs do not meet, parts of the larger diameter: the estimate fades instead of ending.
inline constexpr double kFading = 0.01;

/// Places tried for a piece: anywhere, round its own, and flush with the boxes of others.
inline constexpr int kAnywhere = 36;
inline constexpr int kNearby = 16;
inline constexpr int kFlush = 16;
/// The best of these that are moved downhill.
inline constexpr int kDescents = 3;
/// Steps of a descent, parts of the smaller side of the piece's box: the first, and where it ends.
inline constexpr double kFirstStep = 0.25;
inline constexpr double kCoarseStep = 0.02;
inline constexpr double kFineStep = 0.0005;

/// Weights of pairs that overlap grow by these factors, the deepest pair by the second; others fade.
inline constexpr double kLeastGrowth = 1.2;
inline constexpr double kMostGrowth = 2.0;
inline constexpr double kWeightFading = 0.95;

/// Passes without a smaller overlap after which separating begins anew from the least, and how often.
inline constexpr int kPatience = 100;
inline constexpr int kStrikes = 3;

/// So many times as many places are tried for a piece that comes anew.
inline constexpr int kTimesForNew = 4;
/// Passes until one more piece on a sheet is given up.
inline constexpr int kSqueezingPatience = 60;

/// Parts of the length taken away at a time.
inline constexpr double kShrink = 0.01;
inline constexpr double kFirstCompression = 0.0005;
inline constexpr double kLastCompression = 0.00005;
/// Part of a chain's budget after which it only compresses its best.
inline constexpr double kExploring = 0.75;

}  // namespace tessera::nest_tuning
