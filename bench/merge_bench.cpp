// Measures the work of the master in a round besides matching, while canvases of 50, 200 and 800 pieces fill: canvas and number of
// pieces grow together, so that a round that costs more has to do with how much there is.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "core/base/stopwatch.h"
#include "core/matching/reference_matcher.h"
#include "master/collage.h"
#include "support/synthetic_library.h"

namespace tessera::master {
namespace {

constexpr int kShapes = 24;
constexpr double kPiece_px2 = 5000;  // of the canvas, for each piece: 200 pieces on 1000 x 1000

const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(kShapes);
  return shapes;
}

CollageSettings settings() {
  CollageSettings s;
  s.match.tangent_dockings = 150;
  return s;
}

/// A collage and how long the master took in each round.
class TimedRounds {
 public:
  explicit TimedRounds(const Canvas& canvas)
      : context_(make_matching_context(settings(), kShapes)),
        matcher_(context_, 0, test::models_of(library(), context_, 0, kShapes)),
        shapes_(library()),
        collage_(canvas, settings(), context_, shapes_) {
    const CanvasField& field = collage_.free().field();
    matcher_.start_field(field.value.width(), field.value.height(), field.origin);
  }

  /// False where nothing fits any more.
  bool round() {
    Stopwatch watch;
    const Window changed = collage_.take_changed_nodes();
    const std::vector<TargetSample> samples = collage_.schedule().take();
    double choosing_s = watch.seconds();
    matcher_.update_field(read_patch(collage_.free().field().value, changed));
    const MatchRound found = match(matcher_, samples, {4000, 150}, 100000, statistics_);
    watch.lap();
    collage_.add_candidates(samples, found);
    Candidate best;
    if (!collage_.choose(best)) return false;
    choosing_s += watch.lap();
    const Window touched = collage_.place(best);
    double merging_s = watch.lap();
    matcher_.update_field(read_patch(collage_.free().field().value, collage_.take_changed_nodes()));
    matcher_.post_measure(collage_.touched_by(touched));
    const std::vector<DockingTerms> terms = matcher_.take_measure();
    watch.lap();
    collage_.rescore(touched, terms);
    merging_s += watch.lap();
    merging_s_.push_back(merging_s);
    choosing_s_.push_back(choosing_s);
    return true;
  }

  /// Means over the rounds from `first` on.
  double choosing_s(std::size_t first) const { return mean(choosing_s_, first); }
  double merging_s(std::size_t first) const { return mean(merging_s_, first); }

 private:
  static double mean(const std::vector<double>& times, std::size_t first) {
    double sum = 0;
    for (std::size_t i = first; i < times.size(); ++i) sum += times[i];
    return sum / double(times.size() - first);
  }

  MatchingContext context_;
  ReferenceMatcher matcher_;
  test::VectorShapes shapes_;
  Collage collage_;
  RunStatistics statistics_;
  std::vector<double> choosing_s_;
  std::vector<double> merging_s_;
};

void master_rounds(benchmark::State& state) {
  const int pieces = int(state.range(0));
  const int side_px = int(std::sqrt(kPiece_px2 * pieces));
  const Canvas canvas = make_rectangle_canvas(side_px, side_px);
  for (auto _ : state) {
    TimedRounds rounds(canvas);
    int placed = 0;
    while (placed < pieces && rounds.round()) ++placed;
    state.SetIterationTime(rounds.choosing_s(0) + rounds.merging_s(0));
    state.counters["pieces"] = placed;
    state.counters["choose_ms"] = 1e3 * rounds.choosing_s(0);
    state.counters["merge_ms"] = 1e3 * rounds.merging_s(0);
    state.counters["last_half_ms"] = 1e3 * (rounds.choosing_s(placed / 2) + rounds.merging_s(placed / 2));
  }
}

// Time: the mean of a round.
BENCHMARK(master_rounds)
    ->ArgName("pieces")
    ->Arg(50)
    ->Arg(200)
    ->Arg(800)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tessera::master
