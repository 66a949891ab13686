// The matcher in plain C++, one docking after the other. The kernels are tested against it.
#pragma once

#include <memory>

#include "core/matching/matcher.h"
#include "core/matching/near_colours.h"
#include "core/matching/pair_selection.h"

namespace tessera {

class ReferenceMatcher : public Matcher {
 public:
  /// `models[i]` is library shape first_shape + i.
  ReferenceMatcher(const MatchingContext& context, std::uint32_t first_shape, std::vector<ShapeModel> models);

  ShapeRange shapes() const override;
  void start_field(int width, int height, Vec2 origin) override;
  void update_field(const std::vector<FieldPatch>& patches) override;
  void limit(const StanceLimits& limits) override;
  void post_count(const CountRequest& request) override;
  std::vector<DistanceHistogram> take_count() override;
  void post_dock(const DockRequest& request) override;
  DockReply take_dock() override;
  void post_refine(const std::vector<Docking>& dockings) override;
  std::vector<RefinedDocking> take_refine() override;
  void post_measure(const std::vector<Docking>& dockings) override;
  std::vector<DockingTerms> take_measure() override;

 private:
  std::vector<PadPair> pairs_of(std::size_t model, const TargetSample& sample, std::uint32_t reach_steps);
  std::vector<Docking> pad_dockings(const DockRequest& request, std::uint32_t sample, DockReply& reply);
  std::vector<Docking> tangent_dockings(const DockRequest& request, std::uint32_t sample, DockReply& reply);
  float key_of(const ShapeModel& model, const Similarity& pose) const;
  const ShapeModel& model_of(ShapeId shape) const;
  DockingTerms terms_of(const Docking& docking) const;

  MatchingContext context_;  // within the present limits
  StanceTable all_stances_;
  std::uint32_t first_shape_;
  Deck deck_;                 // of the question under way
  NearColours near_colours_;  // of the shapes within the limits
  std::vector<ShapeModel> models_;
  CanvasField field_;
  std::vector<TargetSample> counted_;
  std::vector<DistanceHistogram> histograms_;
  DockReply docked_;
  std::vector<RefinedDocking> refined_;
  std::vector<DockingTerms> measured_;
};

}  // namespace tessera
