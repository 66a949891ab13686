// Every fixed tunable of the algorithm, with its unit and why it has that value. What a user may want to change is in
// settings.h; what a device may want to change is in kernels/.
#pragma once

#include <algorithm>

#include "core/settings.h"

namespace tessera {

// Target curve. Lengths in parts of the smallest piece (pieces.scale_px[0]).
inline constexpr float kOpeningRadius = 0.2f;     // narrower gulfs would only give false features
inline constexpr float kReachableRadius = 0.25f;  // where no such disc fits, no piece ever will
inline constexpr float kTargetSigma = 0.125f;     // puts pieces of 1 to 16 times the smallest into the library's levels
inline constexpr float kSampleSpacing = 0.4f;     // one target sample for so much boundary (8 px at 20 px)
inline constexpr float kShortestLoop = 2.5f;      // shorter boundary loops enclose no piece

/// Below 1.5 px the raster of the field shows through.
inline float target_sigma_px(const PieceSettings& p) { return std::max(1.5f, kTargetSigma * p.min_scale_px); }
inline float opening_radius_px(const PieceSettings& p) { return kOpeningRadius * p.min_scale_px; }
inline float reachable_radius_px(const PieceSettings& p) { return kReachableRadius * p.min_scale_px; }
inline int sample_spacing_px(const PieceSettings& p) {
  return std::max(2, int(kSampleSpacing * p.min_scale_px + 0.5f));
}

/// How far around a piece its distances enter the free field; what looks further ahead only needs "far".
inline float stamp_band_px(const PieceSettings& p) { return std::max(24.f, 0.25f * p.max_scale_px); }

// Matching.
inline constexpr int kPairsPerShape = 4;     // best local minima kept for a (target sample, shape)
inline constexpr int kDockingsPerShape = 2;  // of these, the best after docking
inline constexpr int kDistanceBins = 64;     // of the histogram that finds the global top K percent
inline constexpr int kShortlist = 16;        // dockings of a target sample that are compared over the whole library
inline constexpr int kRefined = 6;           // of these, distinct ones that are refined
inline constexpr int kPoolPerSample = 4;     // refined candidates kept
inline constexpr int kRematchTangentDockings = 2000;  // when the pool is dry
/// A pre-test of the scale by the lengths of level 2, which are noisier than the final alignment.
inline constexpr float kScaleWindowLow = 0.7f;
inline constexpr float kScaleWindowHigh = 1.4f;
inline constexpr int kChordLevel = 2;        // whose chord tells scale and rotation before any alignment
inline constexpr float kLevelSliver = 1.1f;    // less of a level at the end of the scales is not worth its PADs
inline constexpr float kLevelSlack = 1.05f;  // a level serves its octave and so much beyond
/// Largest mean residual of the key points: squared, in units of 4 px times their spread.
inline constexpr float kAlignmentTolerance = 0.64f;

/// A docking is turned so far to a rotation that is allowed: as much as frames and PADs of a good fit differ.
inline constexpr float kDockingTurn_rad = 0.2f;

// Early reject.
inline constexpr float kLeastDockingKey = 0.1f;

// Refinement.
inline constexpr float kHardDepth_px = 1.4f;     // no boundary point of a placed piece lies deeper in another
inline constexpr float kPaddedDepth_px = 0.25f;   // nor where a distance is to be kept, in what is kept around others
inline constexpr float kHopelessDepth_px = 3.f;  // deeper than this, pushing is not worth the time
inline constexpr int kPushSteps = 5;
inline constexpr float kPushShrink = 0.994f;  // a piece that is still stuck gives way a little

inline float hard_depth_px(const PieceSettings& p) { return p.padding_px > 0 ? kPaddedDepth_px : kHardDepth_px; }
/// Kept around pieces so that at least padding_px is left: what depth and the spacing of boundary points take is added.
inline float kept_distance_px(const PieceSettings& p) {
  return p.padding_px > 0 ? p.padding_px + kPaddedDepth_px + 0.1f : 0.f;
}

// Candidates.
inline constexpr float kMaxOverlap = 0.05f;    // of the piece's area, estimated along the contour
inline constexpr float kLeastMatched = 0.03f;  // of the piece's boundary: it must touch something
inline constexpr int kFinalists = 8;          // candidates checked exactly in a round
inline constexpr float kGrowStep = 1.015f;
inline constexpr int kGrowSteps = 12;
inline constexpr int kRefillBelow = 2;  // a target sample with fewer candidates left is matched again

}  // namespace tessera
