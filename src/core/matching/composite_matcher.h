// Several matchers, each with its own part of the library, as one: the devices of a rank, or the ranks of a job.
#pragma once

#include <memory>
#include <vector>

#include "core/matching/matcher.h"

namespace tessera {

class CompositeMatcher : public Matcher {
 public:
  /// The parts' shape ranges follow one another without gaps.
  explicit CompositeMatcher(std::vector<std::unique_ptr<Matcher>> parts);

  ShapeRange shapes() const override;
  void start_field(int width, int height, Vec2 origin) override;
  void update_field(const FieldPatch& patch) override;
  void limit(const StandingLimits& limits) override;
  void post_count(const CountRequest& request) override;
  /// One step of each part that is ready; where none is, it waits until one is.
  bool step_count() override;
  bool step_is_ready() override;
  std::vector<DistanceHistogram> take_count() override;
  void post_dock(const DockRequest& request) override;
  DockReply take_dock() override;
  void post_refine(const std::vector<Docking>& dockings) override;
  std::vector<RefinedDocking> take_refine() override;
  void post_measure(const std::vector<Docking>& dockings) override;
  std::vector<DockingTerms> take_measure() override;

 protected:
  /// For a sub-class that posts to all parts in its own way: how many samples take_dock will join answers for.
  void expect_docks(std::size_t samples) { samples_posted_ = std::uint32_t(samples); }

 private:
  void expect_steps();
  /// Steps of the parts that are ready. False: none was.
  bool take_ready_steps();

  using PostTo = void (Matcher::*)(const std::vector<Docking>&);
  template <class Answer>
  using TakeFrom = std::vector<Answer> (Matcher::*)();
  void post_divided(const std::vector<Docking>& dockings, PostTo post);
  template <class Answer>
  std::vector<Answer> take_divided(TakeFrom<Answer> take);

  std::vector<std::unique_ptr<Matcher>> parts_;
  std::vector<Matcher*> counting_;  // parts that may have another step of the count
  std::uint32_t samples_posted_ = 0;
  std::vector<std::vector<std::size_t>> posted_to_;  // per part: positions in the request that was divided
};

}  // namespace tessera
