// The matcher on one OpenCL device. It gives the answers of ReferenceMatcher, bit for bit where the device's + - * / and
// sqrt round as IEEE 754 says. post_* hands work to the device without waiting for the answer, take_* waits for it.
// post_dock() looks for pairs first, where its samples were not counted before.
#pragma once

#include "worker/dock_stage.h"
#include "worker/refine_stage.h"

namespace tessera::worker {

/// Bytes on a device for the pairs of a request, and as many for its dockings, at first. They grow where there are more.
inline constexpr std::size_t kStageBytes = std::size_t(4) << 20;

class OpenCLMatcher : public Matcher {
 public:
  /// `shapes` may be empty. `between_launches` is also called while the shapes are uploaded. `lanes`: chosen for the device
  /// unless given. Throws EnvironmentError where the device fails.
  OpenCLMatcher(const cl::Device& device, const MatchingContext& context, const ShapeRange& shapes,
                std::shared_ptr<const ModelSource> models, const BetweenLaunches& between_launches = {},
                std::size_t stage_bytes = kStageBytes, const HeldShapes& held = {},
                std::optional<DockingLanes> lanes = std::nullopt);
  OpenCLMatcher(const OpenCLMatcher&) = delete;  // the stages point to the library
  OpenCLMatcher& operator=(const OpenCLMatcher&) = delete;

  ShapeRange shapes() const override;
  void start_field(int width, int height, Vec2 origin) override { library_.start_field(width, height, origin); }
  void update_field(const std::vector<FieldPatch>& patches) override { library_.update_field(patches); }
  void limit(const StanceLimits& limits) override;
  void post_count(const CountRequest& request) override;
  bool step_count() override { return pairs_.step_count(); }
  bool step_is_ready() override { return pairs_.step_is_ready(); }
  std::vector<DistanceHistogram> take_count() override { return pairs_.take_count(); }
  void post_dock(const DockRequest& request) override;
  DockReply take_dock() override { return docking_.take(); }
  void post_refine(const std::vector<Docking>& dockings) override { refinement_.post(dockings); }
  std::vector<RefinedDocking> take_refine() override { return refinement_.take(); }
  void post_measure(const std::vector<Docking>& dockings) override { refinement_.post_measure(dockings); }
  std::vector<DockingTerms> take_measure() override { return refinement_.take_measure(); }

 private:
  std::vector<SampleRecord> records_of(const std::vector<TargetSample>& samples);

  DeviceLibrary library_;
  PairStage pairs_;
  DockStage docking_;
  RefineStage refinement_;
};

}  // namespace tessera::worker
