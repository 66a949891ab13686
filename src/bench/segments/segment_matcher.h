// A matcher that finds pairs by a descriptor of whole shapes, extended naively to parts: it compares segments of the
// target curve with segments of every shape's curve (paper, section 2, and section 5 for Fig. 28). It is compared with
// the engine's PADs. Field, docking, early reject, refinement, objective and merging are those of the engine.
//
// Naive means: a target sample has three segments, between the ends of its longest PAD levels. Each is compared with
// each segment of each shape that may still be placed: kSegmentLengths lengths, from each place where the shape has a
// PAD. There is no index. For each shape the nearest kPairsPerShape local minima are docked, over all shapes the
// nearest `pairs`.
//
// Advantages that it has here (the paper does not say which advantages its baselines had):
// - The segments of shapes are described in advance, and that time is not counted.
// - Both sides are smoothed as in the engine.
// - Segments are not compared where their lengths imply a size that is not allowed, or where only one of them bulges.
// - The distance has no limit: the nearest pairs are docked, however different they are.
// - Docking aligns evenly spaced points by least squares, as the engine aligns key points.
// A disadvantage: each request traces the whole target curve again; the engine traces only what has changed.
// There are no random dockings and no colours. Matching runs on one thread.
#pragma once

#include <memory>
#include <vector>

#include "bench/segments/shape_segments.h"
#include "bench/segments/target_stretches.h"
#include "core/base/stop.h"
#include "core/matching/reference_matcher.h"

namespace tessera::bench {

struct SegmentMatching {
  std::unique_ptr<ShapeDescriptor> descriptor;
  std::size_t pairs = 200;            // most pairs docked for a target sample
  StopCheck check_stop = never_stop;  // called every few thousand comparisons; may throw Interrupted
};

class SegmentMatcher : public Matcher {
 public:
  /// `shapes[i]`, with its level curves, is library shape i, and `models[i]` its model. `context` belongs to
  /// `settings`. Describes all segments of the shapes, on all cores.
  SegmentMatcher(const CollageSettings& settings, const MatchingContext& context, const std::vector<Shape>& shapes,
                 std::vector<ShapeModel> models, SegmentMatching matching);

  ShapeRange shapes() const override { return reference_.shapes(); }
  void start_field(int width, int height, Vec2 origin) override;
  void update_field(const std::vector<FieldPatch>& patches) override;
  void limit(const StanceLimits& limits) override;
  /// Must not be called: these settings have match.top_percent = 0 (segment_settings). Throws std::logic_error.
  void post_count(const CountRequest& request) override;
  std::vector<DistanceHistogram> take_count() override { return {}; }
  /// Ignores the request's limits of bins, which are for PADs.
  void post_dock(const DockRequest& request) override;
  DockReply take_dock() override { return std::move(docked_); }
  void post_refine(const std::vector<Docking>& dockings) override { reference_.post_refine(dockings); }
  std::vector<RefinedDocking> take_refine() override { return reference_.take_refine(); }
  void post_measure(const std::vector<Docking>& dockings) override { reference_.post_measure(dockings); }
  std::vector<DockingTerms> take_measure() override { return reference_.take_measure(); }

  /// The number of computed distances of descriptors.
  std::uint64_t compared() const { return compared_; }

 private:
  /// A target segment and a shape's segment, to be docked.
  struct SegmentPair {
    float distance = 0;
    std::uint32_t shape = 0;
    std::size_t level_slot = 0;
    std::uint32_t place = 0;  // in LevelSegments::segments
    std::size_t target = 0;   // index in the sample's segments
  };

  std::vector<CurveSegment> target_segments(const TargetSample& sample);
  std::vector<SegmentPair> pairs_of_shape(std::uint32_t shape, const std::vector<CurveSegment>& targets);
  void add_minima(const CurveSegment& target, const LevelSegments& level, int length, SegmentPair pair,
                  std::vector<SegmentPair>& best);
  std::vector<SegmentPair> nearest_pairs(const std::vector<CurveSegment>& targets);
  std::vector<Docking> dockings_of(std::uint32_t t, const TargetSample& sample);

  MatchingContext context_;
  StanceTable all_stances_;
  ReferenceMatcher reference_;  // refines and measures
  std::vector<ShapeModel> models_;
  SegmentMatching matching_;
  std::vector<std::vector<LevelSegments>> segments_;  // by shape
  TargetStretches target_;
  CanvasField field_;
  DockReply docked_;
  std::uint64_t compared_ = 0;
};

/// The settings of this matcher: no pairs of PADs, no random dockings.
CollageSettings segment_settings(CollageSettings settings);

}  // namespace tessera::bench
