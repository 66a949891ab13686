// The master's side of a worker: a matcher whose shapes and devices belong to another rank.
#pragma once

#include <vector>

#include "comm/communicator.h"
#include "core/matching/matcher.h"

namespace tessera::comm {

class RemoteMatcher : public Matcher {
 public:
  /// `worker` serves `shapes` (worker_server.h). The communicator outlives the matcher.
  RemoteMatcher(Communicator& ranks, int worker, ShapeRange shapes);

  ShapeRange shapes() const override { return shapes_; }
  void start_field(int width, int height, Vec2 origin) override;
  void update_field(const FieldPatch& patch) override;
  void limit(const StandingLimits& limits) override;
  void post_count(const CountRequest& request) override;
  std::vector<DistanceHistogram> take_count() override;
  void post_dock(const DockRequest& request) override;
  DockReply take_dock() override;
  void post_refine(const std::vector<Docking>& dockings) override;
  std::vector<RefinedDocking> take_refine() override;
  void post_measure(const std::vector<Docking>& dockings) override;
  std::vector<DockingTerms> take_measure() override;

 private:
  Communicator& ranks_;
  int worker_;
  ShapeRange shapes_;
};

}  // namespace tessera::comm
