// The fixed numbers of the method: tolerances, search radii, limits for giving up, each with its unit and the reason
// for its value. Parameters that a job may set are in settings.h. Three kinds of numbers stand beside their code
// instead: the sampling of shapes and fields, tolerances for rounding, and the portions of parallel work.
// worker/devices/kernel_options.cpp passes the numbers here to the kernels.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/settings/descent.h"
#include "core/settings/settings.h"

namespace tessera {

// Target curve. Lengths are multiples of the smallest piece (pieces.scale_px[0]).
inline constexpr float kOpeningRadius = 0.2f;     // narrower gulfs would only give false features
inline constexpr float kReachableRadius = 0.25f;  // where no such disc fits, no piece ever will
inline constexpr float kTargetSigma = 0.125f;     // pieces of 1 to 16 times the smallest fall into the library's levels
inline constexpr float kSampleSpacing = 0.4f;     // boundary length per target sample (8 px at 20 px)
inline constexpr float kShortestLoop = 2.5f;      // shorter boundary loops enclose no piece

/// Longest walk along the boundary for one side of a PAD, in multiples of the largest piece. No shape has a boundary of
/// this length with so little turning, so walks along straight sides end there. 8 gives 5 % more pieces; 16 changes
/// nothing on canvases of 12 times the largest piece.
inline constexpr float kLongestSide = 16;

/// The width of the smoothing. Below 1.5 px the raster of the field shows through.
inline float target_sigma_px(const PieceSettings& p) { return std::max(1.5f, kTargetSigma * p.min_scale_px); }
inline float opening_radius_px(const PieceSettings& p) { return kOpeningRadius * p.min_scale_px; }
inline float reachable_radius_px(const PieceSettings& p) { return kReachableRadius * p.min_scale_px; }
inline int sample_spacing_px(const PieceSettings& p) {
  return std::max(2, int(kSampleSpacing * p.min_scale_px + 0.5f));
}

/// A sample is matched again when a length of its PAD changed by more than this fraction plus the slack. Coarse levels
/// may change more: they depend on distant boundary and weigh little.
inline constexpr float kChangedFine = 0.15f;
inline constexpr float kChangedCoarse = 0.25f;  // of the second coarsest level
inline constexpr float kChangedCoarsest = 0.4f;
inline constexpr float kChangedSlack_px = 3;  // of a length that is small itself

/// Width of the free field of a seamless canvas beyond one period, in multiples of the largest piece's scale, but at
/// most one more period. A piece docked at the seam may lie beyond it as a whole; a longer piece is found from its
/// other end.
inline constexpr float kSeamlessReach = 2;

/// Width of the band around a piece in which its distances enter the free field. Searches that look farther only need
/// "far".
inline float stamp_band_px(const PieceSettings& p) { return std::max(24.f, 0.25f * p.max_scale_px); }

// Selection of the pairs that are docked.
inline constexpr int kPairsPerShape = 4;     // best local minima kept for a (target sample, shape)
inline constexpr int kDockingsPerShape = 2;  // of these, the best after docking
inline constexpr int kDistanceBins = 64;     // bins of the histogram that finds the global top K percent
/// A first test of the scale by the lengths of level 2, which are noisier than the final alignment.
inline constexpr float kScaleWindowLow = 0.7f;
inline constexpr float kScaleWindowHigh = 1.4f;

// Docking.
inline constexpr int kAlignmentLevels = 3;  // the longest levels; the longest of them that agrees is aligned
/// Largest mean residual of the key points, squared, as a fraction of 4 px times their spread.
inline constexpr float kAlignmentTolerance = 0.64f;
inline constexpr float kAlignmentUnit_px = 4.f;
/// A docking is turned by at most this angle to reach an allowed rotation: as much as frames and PADs of a good fit
/// differ.
inline constexpr float kDockingTurn_rad = 0.2f;
inline constexpr int kRematchTangentDockings = 2000;  // random dockings per target sample when the pool is empty

// The random dockings of a question draw from all shapes that may stand. In libraries with more than kWholeDeck shapes
// they draw from a few runs of shapes. Then one shape is rarely drawn three times for a target sample, and the 2,048
// contours, 10 MB, are read at once.
inline constexpr std::uint32_t kWholeDeck = 65536;
inline constexpr std::uint32_t kDeckRuns = 32;
inline constexpr std::uint32_t kDeckRun = 64;      // shapes that follow one another
inline constexpr std::uint32_t kNearDeckRuns = 4;  // of each list of shapes of similar colour
inline constexpr std::uint32_t kNearDeckRun = 32;

// Early reject, by a few boundary and interior points. The tolerances are the errors that a good docking may have
// before refinement.
inline constexpr float kHopelessDocking_px = 5;  // a point deeper than this, or this fraction of the scale, rejects
inline constexpr float kHopelessDocking = 0.12f;
inline constexpr float kNearDocking_px = 4;   // a point nearer than this, or this fraction of the scale, is a hit
inline constexpr float kNearDocking = 0.06f;  // deeper points are bad
inline constexpr int kMostBadPoints = 4;      // of 32
inline constexpr float kBadPointCost = 1.5f;  // in hits
inline constexpr int kInteriorStride = 3;     // every third interior point is tested
inline constexpr float kCoveredCost = 9;      // times the fraction of the tested interior points that are covered
inline constexpr float kLeastDockingKey = 0.1f;
inline constexpr int kShortlist = 16;         // dockings of a target sample that are compared over the whole library
inline constexpr int kRefined = 6;            // of these, distinct dockings that are refined
inline constexpr float kSameDocking = 0.13f;  // of the scale: refinement would bring both to one pose

// Refinement.
/// First kApproach from far away, then kCloseFit nearby; points outside weigh more and more. The first radius of
/// kApproach is at least this fraction of the scale.
inline constexpr Descent kApproach{6, 6, 3, 3, false};
inline constexpr float kApproachRadius = 0.1f;
inline constexpr Descent kCloseFit{3, 2.5f, 2, 12, false};
inline constexpr Descent kPush{2, 1.5f, 1.5f, 25, true};  // for points that are still too deep
inline constexpr int kPushSteps = 5;
inline constexpr float kPushShrink = 0.994f;  // a piece that is still too deep shrinks a little
inline constexpr float kArm = 0.6f;           // of the piece's radius: lever arm of growth and rotation
inline constexpr int kLeastDrawnPoints = 3;   // with fewer points near the boundary the best pose is uncertain
/// Terms added on the diagonal: fractions of the trace, and weights. Growth is the least certain of the four unknowns.
inline constexpr float kDamping = 0.005f;
inline constexpr float kLeastDamping = 0.05f;
inline constexpr float kGrowthDamping = 0.0125f;

/// The smallest depth at which the fields can tell that a piece lies too deep; less is rounding. Outlines decide about
/// smaller depths.
inline constexpr float kFieldDepth_px = 0.25f;
inline constexpr float kMaxPushDepth_px = 3.f;   // pushing a piece out of a greater depth is not worth the time
inline constexpr float kInteriorDepth_px = 3.f;  // added to an interior point's depth: only thin overlaps reach it

/// The largest depth of a placed piece's boundary point in another piece with its kept distance, by the fields.
inline float hard_depth_px(const PieceSettings& p) {
  return p.padding_px > 0 ? kFieldDepth_px : std::max(p.overlap_px, kFieldDepth_px);
}
/// The distance kept around pieces in the fields so that at least padding_px remains. The addition covers depth and the
/// spacing of boundary points.
inline float kept_distance_px(const PieceSettings& p) {
  return p.padding_px > 0 ? p.padding_px + kFieldDepth_px + 0.1f : 0.f;
}

// Terms of the objective.
inline constexpr float kNoise_px = 0.5f;   // smaller distances along the contour are neither gap nor overlap
inline constexpr float kContact_px = 1.f;  // runs are counted from a point nearer than this, so that no run is cut
inline constexpr float kOverlapDepth_px = 0.25f;  // smaller depths, in counted nodes, are rounding of the fields
inline constexpr float kReachSlack_px = 1.2f;     // a disc counts this much farther, because nodes are counted
inline constexpr float kDefectCost = 5;  // scale_aware: a piece with defects on a fifth of its area counts half
// Additions at pieces.balance = 1 to objective.length_exponent and scale_exponent. The former alone costs a dwarf
// nothing: a dwarf fits into its gap along all of its boundary (docs/decisions/2026-11-23-balance-of-sizes.md).
inline constexpr float kBalanceOfLength = 2;
inline constexpr float kBalanceOfScale = 0.5f;
inline constexpr float kBalanceOfRepetition = 0.5f;  // of objective.repetition_exponent: keeps the variety
/// The part of a dwarf's area that improving counts as lost at balance 1. Dwarfs do not please the eye.
inline constexpr double kDwarfLoss = 0.8;
inline constexpr float kLeastDefect = 0.0025f;  // paper: keeps Z finite for a perfect fit, px² per px² of the piece

// Colours, if a picture is to be shown. Differences are CIEDE2000.
inline constexpr float kColourFading = 0.125f;   // at weight 1 a score halves with every 8
inline constexpr float kColourFootprint = 0.7f;  // of the scale: size of the place compared before refinement
inline constexpr float kNearColourShare = 4;     // at weight 1 one of this number of shapes has a place's colour,
inline constexpr std::uint32_t kLeastNearColours = 64;  // but at least this number
inline constexpr float kOwnContrast = 2;                // weight of a shape's own contrast: restless shapes come later
inline constexpr double kOffColour =
    1 / 192.0;                           // px² lost in improving per px² of piece and unit of difference, at weight 1
inline constexpr float kColourStep = 8;  // of a lattice in CIELAB: places of one lattice point share their shapes
inline constexpr std::uint32_t kAnyColourDraws = 2;  // every second random docking takes a shape of any colour
inline constexpr float kNeighbourReach = 0.75f;      // centres of neighbours are nearer than this times both scales
inline constexpr float kNeighbourFading = 4;  // halvings of the score by the least welcome neighbour, at weight 1
inline constexpr float kOtherColour = 48;     // differences from here on count as this one

// The pool and the choice.
inline constexpr int kPoolPerSample = 4;       // refined candidates kept
inline constexpr float kMaxOverlap = 0.05f;    // of the piece's area, along the contour and, when settled, by nodes
inline constexpr float kLeastMatched = 0.03f;  // of the piece's boundary: it must touch something
inline constexpr float kWindowMargin_px = 3;   // around a candidate's boundary points: the outline bulges between them
inline constexpr int kRefillBelow = 2;         // a target sample with fewer candidates left is matched again
// Two pieces of one shape are near twins if the gap between their circles is less than this times the sum of their
// scales.
inline constexpr float kNearTwinReach = 0.5f;
inline constexpr float kUseInOtherColours = 0.75f;  // weight of a use in other colours: the rarer variant is chosen
inline constexpr int kFinalists = 8;                // candidates checked exactly before a piece
inline constexpr int kFinalistsExamined = 64;       // candidates examined to find the distinct finalists
inline constexpr float kSameCandidate = 0.07f;      // of the scale: two finalists would look the same
inline constexpr int kSearches = 3;  // of each sample, with new random dockings, before the region is full

// Batches: the pieces that are placed before candidates are matched again. Of the first piece's worth another one needs at
// least a part. Where a picture is shown, colours decide about worth, and no neighbour that comes later changes them.
inline constexpr float kBatchWorth = 0.7f;
inline constexpr float kBatchWorthInPicture = 1.f / 64;
inline constexpr float kBatchClearance =
    0.5f;  // of the largest piece: least distance between the windows of two pieces

// The first piece of a canvas without edges: shapes are drawn until one can stand, each draw a little smaller.
inline constexpr std::uint64_t kFirstPieceDraws = 64;
inline constexpr float kFirstPieceShrink = 0.95f;

// Growing outward from standing pieces (start.grow).
inline constexpr float kOnEdge_px = 1;         // target samples nearer to the canvas' edge lie on it
inline constexpr float kOnRoundedEdge = 0.3f;  // of the opening radius, more than that: the curve rounds corners
inline constexpr float kGrowthFading = 1;      // of the largest piece: distance at which a score falls to 1 / e

// Every drawing at least once (pieces.fit = "all").
inline constexpr double kFilledByTheRest = 0.85;    // of the free area, by the shapes that are still to come
inline constexpr float kSizeStep = 0.9f;            // of the ladder of largest sizes
inline constexpr double kNearlyOneSize = 1.001;     // ratio of two sizes that count as one
inline constexpr double kFirstFilling = 0.8;        // of the canvas, by the sizes of the first attempt
inline constexpr double kNearTheTop = 1.3;          // pieces with a range take this many times their mean square size
inline constexpr std::uint32_t kMostAttempts = 12;  // at different sizes (core/matching/size_search)

// Settling of a chosen piece.
inline constexpr Descent kSettle{2, 0.3f, 0.3f, 30, false};  // out of pieces that were placed since the refinement
inline constexpr int kSettleSteps = 20;
inline constexpr float kSettleShrink = 0.99f;
inline constexpr Descent kGrow{4, 1.5f, 1, 20, false};
inline constexpr float kGrowStep = 1.015f;
inline constexpr int kGrowSteps = 12;
inline constexpr float kLeastGrowth = 1.002f;  // a step with less growth is the last
inline constexpr int kExactSteps = 8;          // pushes out of conflicts of outlines that the fields do not show

// Ruin and recreate. Takes out only small pieces, several at a time: the hole of a large piece takes ten rounds to fill
// and hardly ever improves. Measured: 6.5 px² gained per matching, against 1.3 with pieces of any size, and 4.7 with
// one at a time. If every shape must stand once (fit = "all"), only the removed pieces can fill the hole; then pieces
// of any size are taken out.
inline constexpr float kRuinedScale = 2.5f;  // of the smallest piece
inline constexpr int kMostRuined = 4;
inline constexpr int kRuinedExamined = 16;  // small pieces whose distance from the gap is measured
inline constexpr int kGapDraws = 4096;      // random points drawn to hit a gap
inline constexpr float kGapDepth_px = 1.f;  // shallower gaps lie between pieces that touch

// Relaxation in improving: all pieces are relaxed after this number of trials, or after as many as there are pieces if
// there are more.
inline constexpr std::uint32_t kTrialsPerRelaxation = 64;

}  // namespace tessera
