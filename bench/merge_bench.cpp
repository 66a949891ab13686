// Measures the work of the master for a piece besides matching, while canvases of 50, 200 and 800 pieces fill: canvas and number of
// pieces grow together, so that a piece that costs more has to do with how much there is.
#include <benchmark/benchmark.h>

#include <cmath>

#include "core/matching/reference_matcher.h"
#include "master/filling.h"
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

/// Places up to `pieces` and returns how many.
std::uint64_t fill(Filling& filling, std::uint64_t pieces) {
  std::uint64_t placed = 0;
  while (placed < pieces && filling.place_one()) ++placed;
  return placed;
}

void master_pieces(benchmark::State& state) {
  const auto pieces = std::uint64_t(state.range(0));
  const int side_px = int(std::sqrt(kPiece_px2 * double(pieces)));
  const MatchingContext context = make_matching_context(settings(), kShapes);
  for (auto _ : state) {
    ReferenceMatcher matcher(context, 0, test::models_of(library(), context, 0, kShapes));
    test::VectorShapes shapes(library());
    Collage collage(make_rectangle_canvas(side_px, side_px), settings(), context, shapes);
    RunStatistics first_half, last_half;
    Filling filling(collage, context, settings(), matcher, first_half);
    collage.begin({}, 0, 0);
    std::uint64_t placed = fill(filling, pieces / 2);
    filling.count_into(last_half);
    const std::uint64_t later = fill(filling, pieces - placed);
    placed += later;
    const double all = double(placed);
    const auto master_s = [](const RunStatistics& s) { return s.objective_s + s.merge_s; };
    state.SetIterationTime((master_s(first_half) + master_s(last_half)) / all);
    state.counters["pieces"] = all;
    state.counters["rounds"] = double(first_half.rounds + last_half.rounds);
    state.counters["choose_ms"] = 1e3 * (first_half.objective_s + last_half.objective_s) / all;
    state.counters["merge_ms"] = 1e3 * (first_half.merge_s + last_half.merge_s) / all;
    state.counters["last_half_ms"] = 1e3 * master_s(last_half) / double(later);
  }
}

// Time: the mean of a piece.
BENCHMARK(master_pieces)
    ->ArgName("pieces")
    ->Arg(50)
    ->Arg(200)
    ->Arg(800)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tessera::master
