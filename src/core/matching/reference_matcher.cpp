#include "core/matching/reference_matcher.h"

#include <algorithm>

#include "core/matching/pair_selection.h"
#include "core/matching/refinement.h"

namespace tessera {

ReferenceMatcher::ReferenceMatcher(const MatchingContext& context, std::uint32_t first_shape,
                                   std::vector<ShapeModel> models)
    : context_(context),
      all_stances_(context.stances),
      first_shape_(first_shape),
      models_(std::move(models)) {}

ShapeRange ReferenceMatcher::shapes() const { return {first_shape_, first_shape_ + std::uint32_t(models_.size())}; }

const ShapeModel& ReferenceMatcher::model_of(ShapeId shape) const { return models_[shapes().position_of(shape)]; }

void ReferenceMatcher::start_field(int width, int height, Vec2 origin) {
  field_.value = Grid<float>(width, height);
  field_.origin = origin;
}

void ReferenceMatcher::update_field(const FieldPatch& patch) { write_patch(patch, field_.value); }

void ReferenceMatcher::limit(const StandingLimits& limits) { context_.stances = all_stances_.limited(limits); }

void ReferenceMatcher::post_count(const CountRequest& request) {
  histograms_.assign(request.samples.size(), {});
  for (std::size_t t = 0; t < request.samples.size(); ++t) {
    const std::uint32_t reach = reach_of_bins(request.bin_reach[t], context_.beta_steps);
    for (std::size_t m = 0; m < models_.size(); ++m) {
      const StanceList& list = context_.stances.list(shapes().at(std::uint32_t(m)));
      for (const PadPair& pair : select_pairs(models_[m], request.samples[t], list, context_, reach)) {
        ++histograms_[t][distance_bin(pair.distance, context_.beta_steps)];
      }
    }
  }
}

std::vector<DistanceHistogram> ReferenceMatcher::take_count() { return std::move(histograms_); }

std::vector<Docking> ReferenceMatcher::pad_dockings(const DockRequest& request, std::uint32_t t,
                                                    DockReply& reply) const {
  std::vector<Docking> kept;
  const std::uint32_t reach = reach_of_bins(request.bin_limit[t], context_.beta_steps);
  for (std::size_t m = 0; m < models_.size(); ++m) {
    std::vector<Docking> of_shape;
    const ShapeId shape = shapes().at(std::uint32_t(m));
    const StanceList& list = context_.stances.list(shape);
    for (const PadPair& pair : select_pairs(models_[m], request.samples[t], list, context_, reach)) {
      const SourceLocation at = locate_source(models_[m], pair.source);
      const ModelSample& source = models_[m].levels[at.level_slot].samples[at.index];
      const Alignment aligned =
          align_pyramids(keypoints(source, keypoint_step(models_[m].radius)), request.samples[t].pyramid,
                         context_.pad.levels, context_.level_range[at.level_slot], context_.stances.of(list));
      if (!aligned.valid) continue;
      ++reply.evaluated;
      const std::uint32_t stance = list.first + aligned.stance;
      const float key = docking_key(models_[m], aligned.canvas_from_shape, FieldView(field_), context_.max_scale_px);
      if (key < kLeastDockingKey) continue;
      of_shape.push_back(
          {t, shape, pair.source, stance, key * context_.stances[stance].weight, aligned.canvas_from_shape});
    }
    std::sort(of_shape.begin(), of_shape.end(), docks_better);
    if (of_shape.size() > kDockingsPerShape) of_shape.resize(kDockingsPerShape);
    kept.insert(kept.end(), of_shape.begin(), of_shape.end());
  }
  return kept;
}

std::vector<Docking> ReferenceMatcher::tangent_dockings(const DockRequest& request, std::uint32_t t,
                                                        DockReply& reply) const {
  std::vector<Docking> kept;
  for (std::uint32_t i = 0; i < request.tangent_dockings; ++i) {
    const TangentDraw draw = draw_tangent(context_, request.samples[t], i);
    if (!draw.drawn || !shapes().contains(draw.shape)) continue;
    const ShapeModel& model = model_of(draw.shape);
    const Stance& stance = context_.stances[draw.stance];
    const int point = docked_point(model, draw, request.samples[t], stance.docked_rotations);
    if (point == kNoPoint) continue;
    const Similarity pose = tangent_docking(model, point, draw.scale_px, request.samples[t], stance.poses);
    ++reply.evaluated;
    const float key = docking_key(model, pose, FieldView(field_), context_.max_scale_px);
    if (key < kLeastDockingKey) continue;
    kept.push_back({t, draw.shape, kTangentSource + i, draw.stance, key * stance.weight, pose});
  }
  return kept;
}

void ReferenceMatcher::post_dock(const DockRequest& request) {
  docked_ = {};
  for (std::uint32_t t = 0; t < request.samples.size(); ++t) {
    std::vector<Docking> all = pad_dockings(request, t, docked_);
    const std::vector<Docking> tangent = tangent_dockings(request, t, docked_);
    all.insert(all.end(), tangent.begin(), tangent.end());
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
    const PoseRange& poses = context_.stances[docking.stance].poses;
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
