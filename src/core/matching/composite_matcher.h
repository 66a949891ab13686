// Joins several matchers into one, each with its own part of the library: the devices of a rank, or the ranks of a job.
#pragma once

#include <memory>
#include <vector>

#include "core/matching/matcher.h"

namespace tessera {

/// Divides questions among the parts and joins their answers. A sub-class owns the parts and sends them the messages
/// that are the same for all.
class JoinedMatcher : public Matcher {
 public:
  ShapeRange shapes() const override;
  void post_count(const CountRequest& request) final;
  /// Takes one step of each part that is ready. Waits until a part is ready if none is.
  bool step_count() override;
  bool step_is_ready() override;
  std::vector<DistanceHistogram> take_count() override;
  void post_dock(const DockRequest& request) final;
  DockReply take_dock() override;
  void post_refine(const std::vector<Docking>& dockings) override;
  std::vector<RefinedDocking> take_refine() override;
  void post_measure(const std::vector<Docking>& dockings) override;
  std::vector<DockingTerms> take_measure() override;

 protected:
  /// The parts' shape ranges follow one another without gaps. The sub-class keeps the parts alive.
  explicit JoinedMatcher(std::vector<MatcherPart*> parts);

 private:
  virtual void post_count_to_all(const CountRequest& request) = 0;
  virtual void post_dock_to_all(const DockRequest& request) = 0;

  void expect_steps() { counting_ = parts_; }
  /// Takes one step of each part that is ready. False if no part was ready.
  bool take_ready_steps();

  using PostTo = void (MatcherPart::*)(const std::vector<Docking>&);
  template <class Answer>
  using TakeFrom = std::vector<Answer> (MatcherPart::*)();
  void post_divided(const std::vector<Docking>& dockings, PostTo post);
  template <class Answer>
  std::vector<Answer> take_divided(TakeFrom<Answer> take);

  std::vector<MatcherPart*> parts_;
  std::vector<MatcherPart*> counting_;  // parts that may have another step of the count
  std::uint32_t samples_posted_ = 0;
  std::vector<std::vector<std::size_t>> posted_to_;  // per part: positions in the request that was divided
};

/// Joins complete matchers and calls them one after another.
class CompositeMatcher : public JoinedMatcher {
 public:
  /// The parts' shape ranges follow one another without gaps.
  explicit CompositeMatcher(std::vector<std::unique_ptr<Matcher>> parts);

  void start_field(int width, int height, Vec2 origin) override;
  void update_field(const std::vector<FieldPatch>& patches) override;
  void limit(const StanceLimits& limits) override;

 private:
  void post_count_to_all(const CountRequest& request) override;
  void post_dock_to_all(const DockRequest& request) override;

  std::vector<std::unique_ptr<Matcher>> parts_;
};

}  // namespace tessera
