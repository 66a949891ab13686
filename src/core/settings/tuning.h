// The fixed numbers of the method: what counts as fitting, how far is looked, when something is given up, each with its
// unit and why it has that value. What a job may set is in settings.h. Beside their code stand how finely shapes and
// fields are sampled, what rounding needs, and how work is portioned. worker/devices/kernel_options.cpp hands them to the
// kernels.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/settings/descent.h"
#include "core/settings/settings.h"

namespace tessera {

// Target curve. Lengths in parts of the smallest piece (pieces.scale_px[0]).
inline constexpr float kOpeningRadius = 0.2f;     // narrower gulfs would only give false features
inline constexpr float kReachableRadius = 0.25f;  // where no such disc fits, no piece ever will
inline constexpr float kTargetSigma = 0.125f;     // puts pieces of 1 to 16 times the smallest into the library's levels
inline constexpr float kSampleSpacing = 0.4f;     // one target sample for so much boundary (8 px at 20 px)
inline constexpr float kShortestLoop = 2.5f;      // shorter boundary loops enclose no piece

/// Of the largest piece: no shape goes so far with so little turning, so that walks along straight sides end there. 8
/// gives 5 % more pieces, 16 changes nothing on canvases of 12 times the largest piece.
inline constexpr float kLongestSide = 16;

/// Below 1.5 px the raster of the field shows through.
inline float target_sigma_px(const PieceSettings& p) { return std::max(1.5f, kTargetSigma * p.min_scale_px); }
inline float opening_radius_px(const PieceSettings& p) { return kOpeningRadius * p.min_scale_px; }
inline float reachable_radius_px(const PieceSettings& p) { return kReachableRadius * p.min_scale_px; }
inline int sample_spacing_px(const PieceSettings& p) {
  return std::max(2, int(kSampleSpacing * p.min_scale_px + 0.5f));
}

/// A PAD that changed by more than this part of a length, plus the slack, is matched again. Coarse levels may change
/// more: they see far and weigh little.
inline constexpr float kChangedFine = 0.15f;
inline constexpr float kChangedCoarse = 0.25f;  // of the coarsest level but one
inline constexpr float kChangedCoarsest = 0.4f;
inline constexpr float kChangedSlack_px = 3;  // of a length that is small itself

/// How far the free field of a seamless canvas goes on beyond one period, in parts of the largest piece's scale, up to
/// another whole period. A piece that is docked at the seam may lie beyond it as a whole; one that is longer is found
/// from its other end.
inline constexpr float kSeamlessReach = 2;

/// How far around a piece its distances enter the free field; what looks further ahead only needs "far".
inline float stamp_band_px(const PieceSettings& p) { return std::max(24.f, 0.25f * p.max_scale_px); }

// Which pairs are docked.
inline constexpr int kPairsPerShape = 4;     // best local minima kept for a (target sample, shape)
inline constexpr int kDockingsPerShape = 2;  // of these, the best after docking
inline constexpr int kDistanceBins = 64;     // of the histogram that finds the global top K percent
/// A pre-test of the scale by the lengths of level 2, which are noisier than the final alignment.
inline constexpr float kScaleWindowLow = 0.7f;
inline constexpr float kScaleWindowHigh = 1.4f;

// Docking.
inline constexpr int kAlignmentLevels = 3;  // the longest ones, of which the longest that agrees is aligned
/// Largest mean residual of the key points: squared, in units of 4 px times their spread.
inline constexpr float kAlignmentTolerance = 0.64f;
inline constexpr float kAlignmentUnit_px = 4.f;
/// A docking is turned so far to a rotation that is allowed: as much as frames and PADs of a good fit differ.
inline constexpr float kDockingTurn_rad = 0.2f;
inline constexpr int kRematchTangentDockings = 2000;  // when the pool is dry

// Random dockings of a question draw from all shapes that may stand, or, of libraries with more shapes than kWholeDeck,
// from runs of them: three draws of one shape a target sample are rare, and 2,048 contours, 10 MB, are read at once.
inline constexpr std::uint32_t kWholeDeck = 65536;
inline constexpr std::uint32_t kDeckRuns = 32;
inline constexpr std::uint32_t kDeckRun = 64;      // shapes that follow one another
inline constexpr std::uint32_t kNearDeckRuns = 4;  // of each list of shapes of about one colour
inline constexpr std::uint32_t kNearDeckRun = 32;

// Early reject, by some boundary and interior points: before refinement a good docking may be off by so much.
inline constexpr float kHopelessDocking_px = 5;  // a point deeper than this, or this part of the scale, ends it
inline constexpr float kHopelessDocking = 0.12f;
inline constexpr float kNearDocking_px = 4;   // a point within this, or this part of the scale, is a hit
inline constexpr float kNearDocking = 0.06f;  // deeper ones are bad
inline constexpr int kMostBadPoints = 4;      // of 32
inline constexpr float kBadPointCost = 1.5f;  // hits
inline constexpr int kInteriorStride = 3;     // every third interior point is looked at
inline constexpr float kCoveredCost = 9;      // for the part of all interior points that was seen covered
inline constexpr float kLeastDockingKey = 0.1f;
inline constexpr int kShortlist = 16;         // dockings of a target sample that are compared over the whole library
inline constexpr int kRefined = 6;            // of these, distinct ones that are refined
inline constexpr float kSameDocking = 0.13f;  // of the scale: refinement would bring both to one pose

// Refinement.
/// First from afar, then close by: points outside weigh more and more. `kApproach` begins at this part of the scale
/// where that is more.
inline constexpr Descent kApproach{6, 6, 3, 3, false};
inline constexpr float kApproachRadius = 0.1f;
inline constexpr Descent kNestle{3, 2.5f, 2, 12, false};
inline constexpr Descent kPush{2, 1.5f, 1.5f, 25, true};  // what is still too deep
inline constexpr int kPushSteps = 5;
inline constexpr float kPushShrink = 0.994f;  // a piece that is still stuck gives way a little
inline constexpr float kArm = 0.6f;           // of the piece's radius: where growth and rotation are measured
inline constexpr int kLeastDrawnPoints = 3;   // fewer do not tell where the piece belongs
/// What is added on the diagonal: parts of the trace, and weights. Growth is the least certain of the four unknowns.
inline constexpr float kDamping = 0.005f;
inline constexpr float kLeastDamping = 0.05f;
inline constexpr float kGrowthDamping = 0.0125f;

/// The least depth at which fields tell a piece that lies too deep: less is rounding. Outlines decide what is finer.
inline constexpr float kFieldDepth_px = 0.25f;
inline constexpr float kHopelessDepth_px = 3.f;  // deeper than this, pushing is not worth the time
inline constexpr float kInteriorDepth_px = 3.f;  // what an interior point counts deeper: only something thin, and so
                                                 // certainly visible, reaches it

/// No boundary point of a placed piece lies deeper in what fields keep around another.
inline float hard_depth_px(const PieceSettings& p) {
  return p.padding_px > 0 ? kFieldDepth_px : std::max(p.overlap_px, kFieldDepth_px);
}
/// Kept around pieces so that at least padding_px is left: what depth and the spacing of boundary points take is added.
inline float kept_distance_px(const PieceSettings& p) {
  return p.padding_px > 0 ? p.padding_px + kFieldDepth_px + 0.1f : 0.f;
}

// Terms of the objective.
inline constexpr float kNoise_px = 0.5f;          // smaller distances along the contour are neither gap nor overlap
inline constexpr float kContact_px = 1.f;         // runs are counted from a point nearer than this, so that none is cut
inline constexpr float kOverlapDepth_px = 0.25f;  // less, where nodes are counted, is rounding of the fields
inline constexpr float kReachSlack_px = 1.2f;  // what a disc of the reachable radius covers beyond it, counted in nodes
inline constexpr float kDefectCost = 5;        // scale_aware: a piece that spoils a fifth of its area counts half
// What pieces.balance = 1 adds to objective.length_exponent and scale_exponent. The first alone costs a dwarf nothing:
// it fits into its gap along all of its boundary (docs/decisions/2026-11-23-balance-of-sizes.md).
inline constexpr float kBalanceOfLength = 2;
inline constexpr float kBalanceOfScale = 0.5f;
inline constexpr float kBalanceOfRepetition = 0.5f;  // of objective.repetition_exponent: so variety stays
inline constexpr double kDwarfLoss = 0.8;            // of a dwarf's area, in improving: they please nobody
inline constexpr float kLeastDefect = 0.0025f;  // paper: keeps Z finite for a perfect fit, px² per px² of the piece

// Colour, where a picture is to be shown. Differences are CIEDE2000.
inline constexpr float kColourFading = 0.125f;   // at weight 1 a score halves with every 8
inline constexpr float kColourFootprint = 0.7f;  // of the scale: the place whose mean is compared before refinement
inline constexpr float kNearColourShare = 4;     // at weight 1 one in so many shapes has the colour of a place,
inline constexpr std::uint32_t kLeastNearColours = 64;  // but so many at least
inline constexpr float kOwnContrast = 2;  // of a shape, beside its mean's difference: restless ones come later
inline constexpr double kOffColour =
    1 / 192.0;                           // of a px², at weight 1, for each px² and a difference of 1: in improving
inline constexpr float kColourStep = 8;  // of a lattice in CIELAB: places of one lattice point share their shapes
inline constexpr std::uint32_t kAnyColourDraws = 2;  // every so-many-th random docking takes a shape of any colour
inline constexpr float kNeighbourReach = 0.75f;      // of the scales: pieces whose centres are nearer are neighbours
inline constexpr float kNeighbourFading = 4;         // halvings by the least welcome neighbour, at a weight of 1
inline constexpr float kOtherColour = 48;            // from here on colours are as unlike as any

// The pool and the choice.
inline constexpr int kPoolPerSample = 4;       // refined candidates kept
inline constexpr float kMaxOverlap = 0.05f;    // of the piece's area, along the contour and, when settled, by nodes
inline constexpr float kLeastMatched = 0.03f;  // of the piece's boundary: it must touch something
inline constexpr float kWindowMargin_px = 3;   // round a candidate's boundary points: the outline bulges between them
inline constexpr int kRefillBelow = 2;         // a target sample with fewer candidates left is matched again
// Two of a shape are near twins with no more than this between, times scale.
inline constexpr float kNearTwinReach = 0.5f;
inline constexpr float kUseInOtherColours = 0.75f;  // as repetition: of variants that fit alike the rarer one is chosen
inline constexpr int kFinalists = 8;                // candidates checked exactly in a round
inline constexpr int kFinalistsLookedAt = 64;       // to find so many that differ
inline constexpr float kSameCandidate = 0.07f;      // of the scale: two finalists that would look the same
inline constexpr int kEmptyPasses = 2;  // over all samples, with new random dockings each, before the region is full

// The first piece of a canvas without edges: shapes are drawn until one stands, each a little smaller.
inline constexpr std::uint64_t kFirstPieceDraws = 64;
inline constexpr float kFirstPieceShrink = 0.95f;

// Growing outward from what stands (start.grow).
inline constexpr float kOnEdge_px = 1;         // target samples that near to the canvas' edge lie on it
inline constexpr float kOnRoundedEdge = 0.3f;  // of the opening radius, beyond: the curve cuts its corners
inline constexpr float kGrowthFading = 1;      // of the largest piece: over which nearness to the seed falls to 1 / e

// Every drawing at least once (pieces.fit = "all").
inline constexpr double kFilledByTheRest = 0.85;  // of the free area, by the shapes that are still to come
inline constexpr float kSizeStep = 0.9f;          // of the ladder of largest sizes: each step drops what is too large
inline constexpr double kNearlyOneSize = 1.001;   // ratio of two sizes
inline constexpr double kFirstFilling = 0.8;      // of the canvas, by the sizes of the first attempt
inline constexpr double kNearTheTop = 1.3;  // pieces that may choose become so much larger than by the mean square
inline constexpr std::uint32_t kMostAttempts = 12;  // at other sizes each (core/matching/size_search)

// Settling of a chosen piece.
inline constexpr Descent kSettle{2, 0.3f, 0.3f, 30, false};  // out of what was placed since it was refined
inline constexpr int kSettleSteps = 20;
inline constexpr float kSettleShrink = 0.99f;
inline constexpr Descent kGrow{4, 1.5f, 1, 20, false};
inline constexpr float kGrowStep = 1.015f;
inline constexpr int kGrowSteps = 12;
inline constexpr float kLeastGrowth = 1.002f;  // a step that gives less is the last
inline constexpr int kExactSteps = 8;          // out of the outlines that fields and boundary points did not see

// Ruin and recreate. Small pieces alone, some at once: the hole of a large one takes ten rounds to fill and hardly ever
// ends better. Measured: 6.5 px² gained a matching, against 1.3 with pieces of any size, and 4.7 with one at a time.
// Where every shape is to stand once (fit = "all") a hole has nothing but the pieces that were there: those of any
// size.
inline constexpr float kRuinedScale = 2.5f;  // of the smallest piece
inline constexpr int kMostRuined = 4;
inline constexpr int kRuinedLookedAt = 16;  // small pieces whose distance from the gap is measured
inline constexpr int kGapDraws = 4096;      // to hit a gap
inline constexpr float kGapDepth_px = 1.f;  // what is shallower lies between coupled pieces

// Relaxation in improving: of all pieces after so many trials, or as many as there are pieces.
inline constexpr std::uint32_t kTrialsPerRelaxation = 64;

}  // namespace tessera
