// A matcher that weighs the questions and answers which pass through it, as messages between ranks.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "core/matching/matcher.h"

namespace tessera::bench::concepts {

/// Bytes of the messages of one kind of question, and how often it was asked.
struct QuestionWeight {
  int asked = 0;
  std::size_t sent_bytes = 0;
  std::size_t answered_bytes = 0;
};

struct RoundWeight {
  QuestionWeight field, count, dock, refine, measure;
};

class WeighedMatcher : public Matcher {
 public:
  explicit WeighedMatcher(std::unique_ptr<Matcher> matcher) : matcher_(std::move(matcher)) {}

  /// Since the last call.
  RoundWeight take_weight() { return std::exchange(weight_, {}); }

  ShapeRange shapes() const override { return matcher_->shapes(); }
  bool step_count() override { return matcher_->step_count(); }
  bool step_is_ready() override { return matcher_->step_is_ready(); }
  void start_field(int width, int height, Vec2 origin) override { matcher_->start_field(width, height, origin); }
  void limit(const StanceLimits& limits) override { matcher_->limit(limits); }
  void update_field(const std::vector<FieldPatch>& patches) override;
  void post_count(const CountRequest& request) override;
  std::vector<DistanceHistogram> take_count() override;
  void post_dock(const DockRequest& request) override;
  DockReply take_dock() override;
  void post_refine(const std::vector<Docking>& dockings) override;
  std::vector<RefinedDocking> take_refine() override;
  void post_measure(const std::vector<Docking>& dockings) override;
  std::vector<DockingTerms> take_measure() override;

 private:
  std::unique_ptr<Matcher> matcher_;
  RoundWeight weight_;
};

}  // namespace tessera::bench::concepts
