// The three questions of matching, asked of the plain C++ reference and of the OpenCL devices, for a round of a usual
// size: the samples of an empty canvas and a library of synthetic shapes.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>

#include "core/field/free_field.h"
#include "core/field/opened_field.h"
#include "core/field/target_curve.h"
#include "core/matching/reference_matcher.h"
#include "support/synthetic_library.h"
#include "worker/device_group.h"

namespace tessera {
namespace {

constexpr int kShapes = 120;
constexpr std::size_t kSamples = 50;

/// A round's field, samples and models; made once.
struct Scene {
  CollageSettings settings;
  MatchingContext context = make_matching_context(settings, kShapes);
  std::vector<ShapeModel> models = test::models_of(test::synthetic_library(kShapes), context, 0, kShapes);
  FreeField free{make_rectangle_canvas(1000, 1000), settings.pieces};
  std::vector<TargetSample> samples;

  Scene() {
    const OpenedField opened(free, settings.pieces);
    TargetCurve curve(settings.pieces, settings.match.pad);
    curve.retrace(opened, free.field().origin, {free.field().value.bounds()});
    for (const SampleId id : curve.samples()) {
      if (samples.size() < kSamples) samples.push_back(curve.sample(id));
    }
  }

  std::unique_ptr<Matcher> matcher(bool devices) const {
    std::unique_ptr<Matcher> made;
    if (devices) {
      made = worker::make_device_matcher("all", context, all_of(models), given(models));
    } else {
      made = std::make_unique<ReferenceMatcher>(context, 0, models);
    }
    const Grid<float>& field = free.field().value;
    made->start_field(field.width(), field.height(), free.field().origin);
    made->update_field({read_patch(field, field.bounds())});
    return made;
  }

  CountRequest count_request() const { return {samples, std::vector<std::uint32_t>(samples.size(), kDistanceBins)}; }

  DockRequest dock_request() const { return {samples, std::vector<std::uint32_t>(samples.size(), kDistanceBins), 600}; }
};

const Scene& scene() {
  static const Scene made;
  return made;
}

void count(benchmark::State& state) {
  const auto matcher = scene().matcher(state.range(0) != 0);
  // In another order each time: a device does not count twice for the same samples.
  CountRequest request = scene().count_request();
  for (auto _ : state) {
    std::rotate(request.samples.begin(), request.samples.begin() + 1, request.samples.end());
    matcher->post_count(request);
    benchmark::DoNotOptimize(matcher->take_count());
  }
  std::size_t pads = 0;
  for (const ModelLevel& level : scene().models.front().levels) pads += level.samples.size();
  state.counters["pairs/s"] = benchmark::Counter(double(scene().samples.size() * kShapes * pads),
                                                 benchmark::Counter::kIsIterationInvariantRate);
}

void dock(benchmark::State& state) {
  const auto matcher = scene().matcher(state.range(0) != 0);
  matcher->post_count(scene().count_request());
  matcher->take_count();
  std::uint64_t evaluated = 0;
  for (auto _ : state) {
    matcher->post_dock(scene().dock_request());
    evaluated += matcher->take_dock().evaluated;
  }
  state.counters["dockings/s"] = benchmark::Counter(double(evaluated), benchmark::Counter::kIsRate);
}

void refine(benchmark::State& state) {
  const auto matcher = scene().matcher(state.range(0) != 0);
  matcher->post_count(scene().count_request());
  matcher->take_count();
  matcher->post_dock(scene().dock_request());
  const std::vector<Docking> dockings = matcher->take_dock().dockings;
  for (auto _ : state) {
    matcher->post_refine(dockings);
    benchmark::DoNotOptimize(matcher->take_refine());
  }
  state.counters["refined/s"] =
      benchmark::Counter(double(dockings.size()), benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(count)->ArgName("devices")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(dock)->ArgName("devices")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(refine)->ArgName("devices")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace tessera
