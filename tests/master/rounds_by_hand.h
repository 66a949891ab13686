// Runs the rounds of a collage step by step with the plain C++ matcher, for tests that look between the steps.
#pragma once

#include "master/collage.h"
#include "support/divided_matcher.h"

namespace tessera::test {

class RoundsByHand {
 public:
  RoundsByHand(const Canvas& canvas, const CollageSettings& settings, const std::vector<Shape>& library)
      : settings_(settings),
        context_(make_matching_context(settings, std::uint32_t(library.size()))),
        matcher_(divided_matcher(library, context_, {})),
        shapes_(library),
        collage_(canvas, settings, context_, shapes_) {
    const CanvasField& field = collage_.free().field();
    matcher_.start_field(field.value.width(), field.value.height(), field.origin);
  }

  /// Matches the stale samples and chooses a candidate; false if the pool is dry.
  bool choose(Candidate& best) {
    send_field();
    const std::vector<TargetSample> samples = collage_.schedule().take();
    RunStatistics statistics;
    collage_.add_candidates(samples, match(matcher_, samples, {20, 150}, 1000, statistics, [] {}));
    return collage_.choose(best);
  }

  /// The present terms of the candidates that the pieces of the batch touch.
  std::vector<DockingTerms> measure() { return measure(collage_.touched()); }
  /// Places the piece in a batch of its own.
  void place(const Candidate& piece) {
    collage_.place(piece);
    end_batch();
  }

  void end_batch() {
    collage_.merge_batch();
    collage_.end_batch(measure());
  }

  std::vector<DockingTerms> measure(const std::vector<Docking>& dockings) {
    send_field();
    matcher_.post_measure(dockings);
    return matcher_.take_measure();
  }

  CheckpointState state() const {
    CheckpointState state;
    collage_.save(state);
    return state;
  }

  master::Collage& collage() { return collage_; }
  const MatchingContext& context() const { return context_; }

 private:
  void send_field() {
    const Grid<float>& value = collage_.free().field().value;
    matcher_.update_field({read_patch(value, value.bounds())});
  }

  CollageSettings settings_;
  MatchingContext context_;
  CompositeMatcher matcher_;
  VectorShapes shapes_;
  master::Collage collage_;
};

}  // namespace tessera::test
