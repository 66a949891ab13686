#include "core/matching/reference_matcher.h"

#include <algorithm>

#include "core/matching/colour_fit.h"
#include "core/matching/refinement.h"
#include "core/pad/pad_index.h"

namespace tessera {
namespace {}  // namespace

ReferenceMatcher::ReferenceMatcher(const MatchingContext& context, std::uint32_t first_shape,
                                   std::vector<ShapeModel> models)
    : context_(context),
      all_stances_(context.stances),
      first_shape_(first_shape),
      near_colours_(context.colour, context.colour_depth_px),
      models_(std::move(models)) {
  near_colours_.start(context_.stances);
}

ShapeRange ReferenceMatcher::shapes() const { return {first_shape_, first_shape_ + std::uint32_t(models_.size())}; }

const ShapeModel& ReferenceMatcher::model_of(ShapeId shape) const { return models_[shapes().position_of(shape)]; }

void ReferenceMatcher::start_field(int width, int height, Vec2 origin) {
  field_.value = Grid<float>(width, height);
  field_.origin = origin;
}

void ReferenceMatcher::update_field(const std::vector<FieldPatch>& patches) { write_patches(patches, field_.value); }

void ReferenceMatcher::limit(const StanceLimits& limits) {
  tessera::limit(context_, all_stances_, limits);
  near_colours_.set_depth(context_.colour_depth_px);
  near_colours_.start(context_.stances);
}

std::vector<PadPair> ReferenceMatcher::pairs_of(std::size_t model, const TargetSample& sample,
                                                std::uint32_t reach_steps) {
  const ShapeId shape = shapes().at(std::uint32_t(model));
  if (!near_colours_.holds(near_colours_.list_for(sample), shape)) return {};
  return select_pairs(models_[model], sample, context_.stances.list(shape), context_, reach_steps);
}

/// The key of the fit, faded by the difference of the mean colours.
float ReferenceMatcher::key_of(const ShapeModel& model, const Similarity& pose) const {
  const float key = docking_key(model, pose, FieldView(field_), context_.max_scale_px);
  if (key < kLeastDockingKey) return kRejectedDocking;
  if (!context_.colour) return key;
  const float difference = mean_colour_difference(model.colour, pose, *context_.colour.target);
  return key * colour_worth(difference, context_.colour.weight);
}

void ReferenceMatcher::post_count(const CountRequest& request) {
  if (!request.samples.empty()) counted_ = request.samples;
  expect_bins_of(counted_.size(), request.bins);
  histograms_.clear();
  for (std::size_t t = 0; t < request.bins.size(); ++t) {
    if (request.bins[t] == 0) continue;
    DistanceHistogram& histogram = histograms_.emplace_back();
    const std::uint32_t reach = reach_of_bins(request.bins[t], context_.beta_steps);
    for (std::size_t m = 0; m < models_.size(); ++m) {
      if ((first_shape_ + m) / kSegmentShapes % request.segment_stride != 0) continue;
      for (const PadPair& pair : pairs_of(m, counted_[t], reach)) {
        ++histogram[distance_bin(pair.distance, context_.beta_steps)];
      }
    }
  }
}

std::vector<DistanceHistogram> ReferenceMatcher::take_count() { return std::move(histograms_); }

std::vector<Docking> ReferenceMatcher::pad_dockings(const DockRequest& request, std::uint32_t t, DockReply& reply) {
  std::vector<Docking> kept;
  const std::uint32_t reach = reach_of_bins(request.bin_limit[t], context_.beta_steps);
  for (std::size_t m = 0; m < models_.size(); ++m) {
    std::vector<Docking> of_shape;
    const ShapeId shape = shapes().at(std::uint32_t(m));
    const StanceList& list = context_.stances.list(shape);
    std::vector<Stance> stances;
    for (const Stance& stance : context_.stances.of(list)) {
      stances.push_back(sized_at(context_, stance, request.samples[t].position));
    }
    for (const PadPair& pair : pairs_of(m, request.samples[t], reach)) {
      const SourceLocation at = locate_source(context_.levels, pair.source);
      const ModelSample& source = models_[m].levels[at.level_slot].samples[at.index];
      const Alignment aligned =
          align_pyramids(keypoints(source, keypoint_step(models_[m].radius)), request.samples[t].pyramid,
                         context_.pad.levels, context_.level_range[at.level_slot], stances);
      if (!aligned.valid) continue;
      ++reply.evaluated;
      const std::uint32_t stance = list.first + aligned.stance;
      const float key = key_of(models_[m], aligned.canvas_from_shape);
      if (key == kRejectedDocking) continue;
      of_shape.push_back(
          {t, shape, pair.source, stance, key * context_.stances[stance].weight, aligned.canvas_from_shape});
    }
    std::sort(of_shape.begin(), of_shape.end(), docks_better);
    if (of_shape.size() > kDockingsPerShape) of_shape.resize(kDockingsPerShape);
    kept.insert(kept.end(), of_shape.begin(), of_shape.end());
  }
  return kept;
}

std::vector<Docking> ReferenceMatcher::tangent_dockings(const DockRequest& request, std::uint32_t t, DockReply& reply) {
  std::vector<Docking> kept;
  const NearColours::List list = near_colours_.list_for(request.samples[t]);
  const std::span<const std::uint32_t> near =
      list == NearColours::kAny ? std::span<const std::uint32_t>() : near_colours_.shapes(list);
  for (std::uint32_t i = 0; i < request.tangent_dockings; ++i) {
    const TangentDraw draw = draw_tangent(context_, request.samples[t], i, near, deck_);
    if (!draw.drawn || !shapes().contains(draw.shape)) continue;
    const ShapeModel& model = model_of(draw.shape);
    const Stance stance = sized_at(context_, context_.stances[draw.stance], request.samples[t].position);
    const int point = docked_point(model, draw, request.samples[t], stance.docked_rotations);
    if (point == kNoPoint) continue;
    const Similarity pose = tangent_docking(model, point, draw.scale_px, request.samples[t], stance.poses);
    ++reply.evaluated;
    const float key = key_of(model, pose);
    if (key == kRejectedDocking) continue;
    kept.push_back({t, draw.shape, kTangentSource + i, draw.stance, key * stance.weight, pose});
  }
  return kept;
}

void ReferenceMatcher::post_dock(const DockRequest& request) {
  docked_ = {};
  deck_ = draw_deck(context_.seed, request.samples, context_.library_shapes, context_.stances.open_shapes(),
                    near_colours_.length());
  for (std::uint32_t t = 0; t < request.samples.size(); ++t) {
    std::vector<Docking> all = pad_dockings(request, t, docked_);
    const std::vector<Docking> tangent = tangent_dockings(request, t, docked_);
    all.insert(all.end(), tangent.begin(), tangent.end());
    if (request.first_drawn) rank_by_draw(all);
    keep_shortlist(all);
    docked_.dockings.insert(docked_.dockings.end(), all.begin(), all.end());
  }
}

DockReply ReferenceMatcher::take_dock() { return std::move(docked_); }

DockingTerms ReferenceMatcher::terms_of(const Docking& docking) const {
  return docking_terms(docking.canvas_from_shape, model_of(docking.shape), FieldView(field_), context_);
}

void ReferenceMatcher::post_refine(const std::vector<Docking>& dockings) {
  refined_.clear();
  for (const Docking& docking : dockings) {
    const ShapeModel& model = model_of(docking.shape);
    Docking moved = docking;
    const Vec2 centre = docking.canvas_from_shape.translation();
    const PoseRange poses = sized_at(context_, context_.stances[docking.stance], centre).poses;
    const bool feasible = refine(moved.canvas_from_shape, model, FieldView(field_), poses, context_.hard_depth_px);
    refined_.push_back(feasible ? feasible_docking(moved, terms_of(moved), model) : RefinedDocking{moved});
  }
}

std::vector<RefinedDocking> ReferenceMatcher::take_refine() { return std::move(refined_); }

void ReferenceMatcher::post_measure(const std::vector<Docking>& dockings) {
  measured_.clear();
  for (const Docking& docking : dockings) measured_.push_back(terms_of(docking));
}

std::vector<DockingTerms> ReferenceMatcher::take_measure() { return std::move(measured_); }

}  // namespace tessera
