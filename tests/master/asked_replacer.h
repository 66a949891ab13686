// A replacer that remembers its questions.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "core/base/stop.h"
#include "core/replacing/replacer.h"
#include "core/replacing/window_trials.h"
#include "support/synthetic_library.h"

namespace tessera::test {

inline ReplacementOutcome as_it_was(const ReplacementWindow& window) {
  ReplacementOutcome outcome;
  for (std::uint32_t i = 0; i < window.moving.size(); ++i) {
    outcome.pieces.push_back({window.moving[i].shape, window.moving[i].canvas_from_shape, i});
  }
  return outcome;
}

/// Answers with the given function. By default the pieces stay as they are.
class AskedReplacer : public Replacer {
 public:
  using Answer = std::function<ReplacementOutcome(const ReplacementWindow&)>;

  /// With the default breadth, all windows of a batch are one question.
  explicit AskedReplacer(Answer answer = as_it_was, int breadth = 1000)
      : answer_(std::move(answer)),
        breadth_(breadth) {}

  int breadth() const override { return breadth_; }
  void post_replace(std::vector<ReplacementWindow> windows) override { batches.push_back(std::move(windows)); }
  std::vector<ReplacementOutcome> take_replaced() override {
    std::vector<ReplacementOutcome> outcomes;
    for (const ReplacementWindow& window : batches.back()) outcomes.push_back(answer_(window));
    return outcomes;
  }

  const std::vector<ReplacementWindow>& windows() const { return batches.back(); }

  std::vector<std::vector<ReplacementWindow>> batches;

 private:
  Answer answer_;
  int breadth_;
};

/// Answers with real trials, with the shapes of `library`, which must outlive it.
inline AskedReplacer::Answer real_trials(const std::vector<Shape>& library, const StopCheck& check_stop = never_stop) {
  const auto made = std::make_shared<std::vector<HoleShape>>();
  HoleShapes shapes;
  for (const Shape& shape : library) made->push_back(make_hole_shape(shape));
  for (std::uint32_t i = 0; i < made->size(); ++i) shapes[ShapeId{i}] = &(*made)[i];
  return [made, shapes, check_stop](const ReplacementWindow& window) {
    TaskPool alone(1);
    return replaced(window, shapes, check_stop, alone);
  };
}

}  // namespace tessera::test
