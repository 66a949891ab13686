#include "bench/segments/segment_matcher.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "core/base/rank_pool.h"
#include "core/settings/tuning.h"

namespace tessera::bench {
namespace {

constexpr float kNotCompared = std::numeric_limits<float>::infinity();

/// The evenly spaced points of a segment as the key points of a pyramid, for docking.
ArclengthPyramid pyramid_of(const CurveSegment& segment) {
  ArclengthPyramid pyramid;
  pyramid.keypoint = segment.points;
  return pyramid;
}

}  // namespace

SegmentMatcher::SegmentMatcher(const CollageSettings& settings, const MatchingContext& context,
                               const std::vector<Shape>& shapes, std::vector<ShapeModel> models,
                               SegmentMatching matching)
    : context_(context),
      all_stances_(context.stances),
      reference_(context, 0, models),
      models_(std::move(models)),
      matching_(std::move(matching)),
      segments_(shapes.size()),
      target_(settings.pieces) {
  parallel_for(shapes.size(), [&](std::size_t i) {
    segments_[i] = make_shape_segments(shapes[i], context.levels, *matching_.descriptor);
  });
}

void SegmentMatcher::start_field(int width, int height, Vec2 origin) {
  field_.value = Grid<float>(width, height);
  field_.origin = origin;
  reference_.start_field(width, height, origin);
}

void SegmentMatcher::update_field(const std::vector<FieldPatch>& patches) {
  write_patches(patches, field_.value);
  reference_.update_field(patches);
}

void SegmentMatcher::limit(const StanceLimits& limits) {
  tessera::limit(context_, all_stances_, limits);
  reference_.limit(limits);
}

void SegmentMatcher::post_count(const CountRequest&) {
  throw std::logic_error("a matcher by segments counts no pairs of PADs: its settings are those of segment_settings()");
}

std::vector<CurveSegment> SegmentMatcher::target_segments(const TargetSample& sample) {
  const int levels = context_.pad.levels;
  std::vector<CurveSegment> segments;
  for (int level = std::max(0, levels - kAlignmentLevels); level < levels; ++level) {
    std::vector<Vec2> stretch = target_.around(sample, level);
    if (stretch.size() > 2) segments.push_back(make_segment(std::move(stretch), *matching_.descriptor));
  }
  return segments;
}

/// Compares a target segment with all segments of one length, and keeps the local minima along the shape's curve that
/// are among the nearest kPairsPerShape of the shape.
void SegmentMatcher::add_minima(const CurveSegment& target, const LevelSegments& level, int length, SegmentPair pair,
                                std::vector<SegmentPair>& best) {
  std::vector<float> distances(level.starts, kNotCompared);
  for (std::size_t start = 0; start < level.starts; ++start) {
    const CurveSegment& known = level.at(length, start);
    if (known.bulges != target.bulges) continue;
    distances[start] = matching_.descriptor->distance(target.description, known.description);
    ++compared_;
  }
  for (std::size_t start = 0; start < level.starts; ++start) {
    pair.distance = distances[start];
    if (pair.distance == kNotCompared || pair.distance > distances[start == 0 ? level.starts - 1 : start - 1] ||
        pair.distance >= distances[start + 1 == level.starts ? 0 : start + 1])
      continue;
    pair.place = std::uint32_t(std::size_t(length) * level.starts + start);
    best.insert(std::upper_bound(best.begin(), best.end(), pair,
                                 [](const SegmentPair& a, const SegmentPair& b) { return a.distance < b.distance; }),
                pair);
    if (best.size() > kPairsPerShape) best.pop_back();
  }
}

std::vector<SegmentMatcher::SegmentPair> SegmentMatcher::pairs_of_shape(std::uint32_t shape,
                                                                        const std::vector<CurveSegment>& targets) {
  const StanceList& list = context_.stances.list(ShapeId{shape});
  std::vector<SegmentPair> best;
  if (list.count == 0) return best;
  for (std::size_t slot = 0; slot < segments_[shape].size(); ++slot) {
    const LevelSegments& level = segments_[shape][slot];
    const float least_px = std::max(context_.level_range[slot].low, list.min_scale_px);
    const float most_px = std::min(context_.level_range[slot].high, list.max_scale_px);
    for (std::size_t target = 0; target < targets.size(); ++target) {
      for (int length = 0; length < kSegmentLengths; ++length) {
        const float scale_px = targets[target].length / level.at(length, 0).length;
        if (scale_px < least_px || scale_px > most_px) continue;
        add_minima(targets[target], level, length, {0, shape, slot, 0, target}, best);
      }
    }
  }
  return best;
}

std::vector<SegmentMatcher::SegmentPair> SegmentMatcher::nearest_pairs(const std::vector<CurveSegment>& targets) {
  std::vector<SegmentPair> all;
  for (std::uint32_t shape = 0; shape < segments_.size(); ++shape) {
    matching_.check_stop();
    const std::vector<SegmentPair> pairs = pairs_of_shape(shape, targets);
    all.insert(all.end(), pairs.begin(), pairs.end());
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const SegmentPair& a, const SegmentPair& b) { return a.distance < b.distance; });
  if (all.size() > matching_.pairs) all.resize(matching_.pairs);
  // Dockings are ordered by shape, as in the engine.
  std::stable_sort(all.begin(), all.end(),
                   [](const SegmentPair& a, const SegmentPair& b) { return a.shape < b.shape; });
  return all;
}

std::vector<Docking> SegmentMatcher::dockings_of(std::uint32_t t, const TargetSample& sample) {
  const std::vector<CurveSegment> targets = target_segments(sample);
  std::vector<Docking> kept;
  std::vector<Docking> of_shape;
  const auto keep_best_of_shape = [&] {
    std::sort(of_shape.begin(), of_shape.end(), docks_better);
    if (of_shape.size() > kDockingsPerShape) of_shape.resize(kDockingsPerShape);
    kept.insert(kept.end(), of_shape.begin(), of_shape.end());
    of_shape.clear();
  };
  for (const SegmentPair& pair : nearest_pairs(targets)) {
    const ShapeId shape{pair.shape};
    if (!of_shape.empty() && of_shape.front().shape != shape) keep_best_of_shape();
    const StanceList& list = context_.stances.list(shape);
    const CurveSegment& known = segments_[pair.shape][pair.level_slot].segments[pair.place];
    const Alignment aligned = align_pyramids(known.points, pyramid_of(targets[pair.target]), kMaxPadLevels,
                                             context_.level_range[pair.level_slot], context_.stances.of(list));
    if (!aligned.valid) continue;
    ++docked_.evaluated;
    const float key =
        docking_key(models_[pair.shape], aligned.canvas_from_shape, FieldView(field_), context_.max_scale_px);
    if (key < kLeastDockingKey) continue;
    const std::uint32_t stance = list.first + aligned.stance;
    of_shape.push_back(
        {t, shape, pair.place, stance, key * context_.stances[stance].weight, aligned.canvas_from_shape});
  }
  keep_best_of_shape();
  return kept;
}

void SegmentMatcher::post_dock(const DockRequest& request) {
  docked_ = {};
  target_.trace(field_);
  for (std::uint32_t t = 0; t < request.samples.size(); ++t) {
    std::vector<Docking> dockings = dockings_of(t, request.samples[t]);
    keep_shortlist(dockings);
    docked_.dockings.insert(docked_.dockings.end(), dockings.begin(), dockings.end());
  }
}

CollageSettings segment_settings(CollageSettings settings) {
  settings.match.top_percent = 0;
  settings.match.tangent_dockings = 0;
  return settings;
}

}  // namespace tessera::bench
