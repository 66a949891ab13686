// The paper's method to the letter (sections 3.3, 4 and 5), for comparison. The best K % of the pairs nearer than beta
// are docked by the ends of their first level and scored by the objective Z. No refinement. Plain C++, one thread.
//
// Where the paper says nothing, this matcher works as our engine: smoothing levels, each docked only at the scales that
// it serves, and the terms of the objective along the contour.
#pragma once

#include "core/matching/matcher.h"

namespace tessera::bench {

class PaperMatcher : public Matcher {
 public:
  /// `models[i]` is library shape i.
  PaperMatcher(const CollageSettings& settings, const MatchingContext& context, std::vector<ShapeModel> models);

  ShapeRange shapes() const override { return {0, std::uint32_t(models_.size())}; }
  void start_field(int width, int height, Vec2 origin) override;
  void update_field(const std::vector<FieldPatch>& patches) override;
  void limit(const StanceLimits& limits) override;
  void post_count(const CountRequest& request) override;
  std::vector<DistanceHistogram> take_count() override { return std::move(histograms_); }
  void post_dock(const DockRequest& request) override;
  DockReply take_dock() override { return std::move(docked_); }
  void post_refine(const std::vector<Docking>& dockings) override;
  std::vector<RefinedDocking> take_refine() override { return std::move(refined_); }
  void post_measure(const std::vector<Docking>& dockings) override;
  std::vector<DockingTerms> take_measure() override { return std::move(measured_); }

 private:
  void dock_sample(const DockRequest& request, std::uint32_t t);
  DockingTerms terms_of(const Docking& docking) const;
  float score(const ShapeModel& model, const Similarity& canvas_from_shape) const;

  ObjectiveSettings objective_;
  MatchingContext context_;
  StanceTable all_stances_;
  std::vector<ShapeModel> models_;
  CanvasField field_;
  std::vector<TargetSample> counted_;
  std::vector<DistanceHistogram> histograms_;
  DockReply docked_;
  std::vector<RefinedDocking> refined_;
  std::vector<DockingTerms> measured_;
};

/// The settings of this matcher: K, beta, delta and objective of the paper; nothing is settled or grown.
CollageSettings paper_settings(CollageSettings settings);

}  // namespace tessera::bench
