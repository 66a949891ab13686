// The numbers of nesting that no user sets. Measured on albano, jakobs1, shapes0 and swim (docs/measurements/nesting.md).
#pragma once

#include <cstdint>

namespace tessera::nest_tuning {

/// Depth to which pieces may lie in each other, as a part of the strip's height: it lets them touch in spite of rounding. Corners
/// of either piece move by at most 8 times that; 1e-6 is promised.
inline constexpr double kInset = 2e-8;
/// The area that all sides of a search outline may add, as a part of the piece's area.
inline constexpr double kAddedArea = 0.001;
/// Discs for each shape; more cost time and tell little more.
inline constexpr int kPoles = 12;
/// Discs that do not meet, as a part of the larger diameter: the estimate fades out instead of ending.
inline constexpr double kFading = 0.01;

/// Places tried for a piece: anywhere, round its own place, and flush with the boxes of others.
inline constexpr int kAnywhere = 36;
inline constexpr int kNearby = 16;
inline constexpr int kFlush = 16;
/// The number of the best of these places that are moved downhill.
inline constexpr int kDescents = 3;
/// Steps of a descent, as parts of the smaller side of the piece's box: the first, and those at which it ends.
inline constexpr double kFirstStep = 0.25;
inline constexpr double kCoarseStep = 0.02;
inline constexpr double kFineStep = 0.0005;

/// The weights of overlapping pairs grow by these factors, that of the deepest pair by the second; other weights fade.
inline constexpr double kLeastGrowth = 1.2;
inline constexpr double kMostGrowth = 2.0;
inline constexpr double kWeightFading = 0.95;

/// Passes without a smaller overlap after which separation begins again from the least overlap, and how often it does so.
inline constexpr int kPassesWithoutGain = 100;
inline constexpr int kMostRestarts = 3;

/// Factor for the number of places that are tried for a new piece.
inline constexpr int kTimesForNew = 4;
/// Passes after which one more piece on a sheet is given up.
inline constexpr int kSqueezingPatience = 60;

/// Parts of the length that are taken away at a time.
inline constexpr double kShrink = 0.01;
inline constexpr double kFirstCompression = 0.0005;
inline constexpr double kLastCompression = 0.00005;
/// Part of a chain's budget after which it only compresses its best layout.
inline constexpr double kExploring = 0.75;

}  // namespace tessera::nest_tuning
