#include "bench/baselines/paper_matcher.h"

#include <algorithm>

#include "core/collage/objective.h"
#include "core/pad/pad_index.h"

namespace tessera::bench {
namespace {

/// Equation 1 with signed vectors.
std::uint32_t signed_distance(const QuantisedPad& target, float target_convexity, const ModelSample& sample,
                              int levels) {
  if (target_convexity * sample.convexity >= 0) return pad_distance(target, sample.pad, levels);
  std::uint32_t distance = 0;
  for (int e = 0; e < 2 * (levels - 1); ++e) {
    distance = std::max(distance, std::uint32_t(target.element[e]) + sample.pad.element[e]);
  }
  return distance;
}

/// Calls visit(model, level slot, index in the level, source, distance) for the pairs of a sample below beta.
template <class Visit>
void for_near_pairs(const std::vector<ShapeModel>& models, const TargetSample& sample, const MatchingContext& context,
                    Visit&& visit) {
  const int levels = context.pad.levels;
  const QuantisedPad target = quantised(make_pad(sample.pyramid, levels));
  for (std::size_t m = 0; m < models.size(); ++m) {
    std::uint32_t source = 0;
    for (std::size_t slot = 0; slot < models[m].levels.size(); ++slot) {
      const std::vector<ModelSample>& samples = models[m].levels[slot].samples;
      for (std::size_t j = 0; j < samples.size(); ++j, ++source) {
        const std::uint32_t distance = signed_distance(target, sample.pyramid.convexity, samples[j], levels);
        if (distance < context.beta_steps) visit(std::uint32_t(m), slot, j, source, distance);
      }
    }
  }
}

/// Aligns the ends of the first level: "its two endpoints coincide with the corresponding endpoints".
Similarity align_ends(const Keypoints& shape, const ArclengthPyramid& target, int levels) {
  const Vec2 from = shape[levels - 1];
  const Vec2 to = target.keypoint[levels - 1];
  const Vec2 chord = shape[levels + 1] - from;
  const Vec2 target_chord = target.keypoint[levels + 1] - to;
  const float squared = std::max(dot(chord, chord), 1e-12f);
  Similarity s;
  s.a = dot(chord, target_chord) / squared;
  s.b = cross(chord, target_chord) / squared;
  s.tx = to.x - (s.a * from.x - s.b * from.y);
  s.ty = to.y - (s.b * from.x + s.a * from.y);
  return s;
}

}  // namespace

PaperMatcher::PaperMatcher(const CollageSettings& settings, const MatchingContext& context,
                           std::vector<ShapeModel> models)
    : objective_(settings.objective),
      context_(context),
      all_stances_(context.stances),
      models_(std::move(models)) {}

void PaperMatcher::start_field(int width, int height, Vec2 origin) {
  field_.value = Grid<float>(width, height);
  field_.origin = origin;
}

void PaperMatcher::update_field(const std::vector<FieldPatch>& patches) { write_patches(patches, field_.value); }

void PaperMatcher::limit(const StanceLimits& limits) { tessera::limit(context_, all_stances_, limits); }

void PaperMatcher::post_count(const CountRequest& request) {
  if (!request.samples.empty()) counted_ = request.samples;
  expect_bins_of(counted_.size(), request.bins);
  histograms_.clear();
  for (std::size_t t = 0; t < request.bins.size(); ++t) {
    if (request.bins[t] == 0) continue;
    DistanceHistogram& histogram = histograms_.emplace_back();
    for_near_pairs(models_, counted_[t], context_,
                   [&](std::uint32_t m, std::size_t, std::size_t, std::uint32_t, std::uint32_t distance) {
                     const std::uint32_t bin = distance_bin(distance, context_.beta_steps);
                     if (m / kSegmentShapes % request.segment_stride == 0 && bin < request.bins[t]) ++histogram[bin];
                   });
  }
}

float PaperMatcher::score(const ShapeModel& model, const Similarity& canvas_from_shape) const {
  const float scale = canvas_from_shape.scale();
  const DockingTerms terms = docking_terms(canvas_from_shape, model, FieldView(field_), context_);
  return objective(terms, {scale, model.perimeter * scale, context_.max_scale_px}, objective_);
}

void PaperMatcher::dock_sample(const DockRequest& request, std::uint32_t t) {
  const TargetSample& target = request.samples[t];
  std::vector<Docking> dockings;
  for_near_pairs(models_, target, context_,
                 [&](std::uint32_t m, std::size_t slot, std::size_t j, std::uint32_t source, std::uint32_t distance) {
                   if (distance_bin(distance, context_.beta_steps) >= request.bin_limit[t]) return;
                   const ShapeModel& model = models_[m];
                   const Similarity pose =
                       align_ends(keypoints(model.levels[slot].samples[j], keypoint_step(model.radius)), target.pyramid,
                                  context_.pad.levels);
                   const ScaleRange& range = context_.level_range[slot];
                   const float scale = pose.scale();
                   const std::span<const Stance> stances = context_.stances.of(context_.stances.list(ShapeId{m}));
                   const bool stands = std::any_of(stances.begin(), stances.end(),
                                                   [&](const Stance& s) { return s.poses.contains(pose); });
                   if (scale < range.low || scale > range.high || !stands) return;
                   ++docked_.evaluated;
                   dockings.push_back({t, ShapeId{m}, source, 0, score(model, pose), pose});
                 });
  keep_shortlist(dockings);
  docked_.dockings.insert(docked_.dockings.end(), dockings.begin(), dockings.end());
}

void PaperMatcher::post_dock(const DockRequest& request) {
  docked_ = {};
  for (std::uint32_t t = 0; t < request.samples.size(); ++t) dock_sample(request, t);
}

void PaperMatcher::post_refine(const std::vector<Docking>& dockings) {
  refined_.clear();
  for (const Docking& docking : dockings) {
    refined_.push_back(feasible_docking(docking, terms_of(docking), models_[index_of(docking.shape)]));
  }
}

void PaperMatcher::post_measure(const std::vector<Docking>& dockings) {
  measured_.clear();
  for (const Docking& docking : dockings) measured_.push_back(terms_of(docking));
}

DockingTerms PaperMatcher::terms_of(const Docking& docking) const {
  return docking_terms(docking.canvas_from_shape, models_[index_of(docking.shape)], FieldView(field_), context_);
}

CollageSettings paper_settings(CollageSettings settings) {
  settings.match.top_percent = 1;
  settings.match.most_pairs = 0;
  settings.match.beta = 0.4f;
  settings.match.delta_px = 4;
  settings.match.tangent_dockings = 0;
  settings.objective.kind = Objective::paper;
  settings.objective.scale_exponent = 0;
  settings.objective.repetition_exponent = 0;
  settings.objective.near_twin_factor = 1;
  settings.settle = false;
  return settings;
}

}  // namespace tessera::bench
