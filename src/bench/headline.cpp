#include <algorithm>

#include "bench/benchmarks.h"
#include "bench/devices.h"
#include "bench/formula_shapes.h"
#include "bench/timing.h"
#include "core/free_field.h"
#include "core/level_curve.h"
#include "core/match_round.h"
#include "core/objective.h"
#include "core/shape_builder.h"
#include "core/tuning.h"
#include "worker/device_group.h"

namespace tessera::bench {
namespace {

constexpr double kPaper_s = 0.064;
constexpr double kPaperTopPercent = 1;  // K of the paper
constexpr int kFinestSamples = kSmoothingLevels[2].samples;  // a model has as many at every level finer than this one

/// A shape sampled `slices` times as densely as a library's, laid out as that many models: slice i of n holds every
/// n-th sample from the i-th on, so that each sample of the curve is there once.
std::vector<ShapeModel> dense_models(const Shape& shape, const TracedOutline& outline, const MatchingContext& context,
                                     int slices) {
  std::vector<ShapeModel> models(std::size_t(slices), make_shape_model(shape, {}, context.pad, context.levels));
  for (std::size_t slot = 0; slot < context.levels.size(); ++slot) {
    const SmoothingLevel& level = kSmoothingLevels[context.levels[slot]];
    const int samples = level.samples * slices;
    std::vector<Vec2> fine = outline.curves.front().even_points(samples * 2);
    for (Vec2& p : fine) p = (p - shape.artwork.centroid_px) * (1 / shape.artwork.unit_px);
    const std::vector<ArclengthPyramid> dense =
        sample_pyramids(gaussian_smoothed(fine, level.sigma), level.sigma, samples, context.pad);
    for (int i = 0; i < samples; ++i) {
      ModelLevel& slice = models[std::size_t(i % slices)].levels[slot];
      slice.samples[std::size_t(i / slices)] = dense[std::size_t(i)];
      slice.pads[std::size_t(i / slices)] = make_pad(dense[std::size_t(i)], context.pad.levels);
    }
  }
  return models;
}

/// Target samples all round a piece, the free region outside of it on their left.
std::vector<TargetSample> samples_around(const TracedOutline& outline, const Shape& shape,
                                         const Similarity& canvas_from_shape, const CollageSettings& settings,
                                         int count) {
  std::vector<Vec2> curve = outline.curves.front().even_points(count);
  for (Vec2& p : curve) {
    p = canvas_from_shape.apply((p - shape.artwork.centroid_px) * (1 / shape.artwork.unit_px));
  }
  std::reverse(curve.begin(), curve.end());
  const float sigma_px = target_sigma_px(settings.pieces);
  const std::vector<Vec2> smooth = gaussian_smoothed(curve, sigma_px);
  const std::vector<ArclengthPyramid> pyramids = sample_pyramids(smooth, sigma_px, count, settings.match.pad);
  std::vector<TargetSample> samples;
  for (int i = 0; i < count; ++i) {
    const Vec2 along = curve[std::size_t((i + 1) % count)] - curve[std::size_t((i + count - 1) % count)];
    samples.push_back({std::uint32_t(i), 0, curve[std::size_t(i)], along * (1 / norm(along)), pyramids[std::size_t(i)]});
  }
  return samples;
}

struct Docked {
  RunStatistics statistics;
  float best_score = 0;
  float best_matched_px = 0;
};

Docked dock_best(Matcher& matcher, const std::vector<TargetSample>& samples, const MatchPlan& plan,
                 const CollageSettings& settings, const MatchingContext& context, float perimeter) {
  Docked docked;
  const MatchRound round = match(matcher, samples, plan, 0, docked.statistics);
  for (const RefinedDocking& found : round.refined) {
    const float scale = found.docking.canvas_from_shape.scale();
    const float score =
        objective(found.terms, {scale, perimeter * scale, context.max_scale_px}, settings.objective);
    if (score <= docked.best_score) continue;
    docked.best_score = score;
    docked.best_matched_px = found.terms.matched_px;
  }
  return docked;
}

}  // namespace

Report bench_headline(const Setting& setting) {
  const int slices = setting.quick ? 2 : 40;
  const int sample_count = setting.quick ? 100 : 5000;
  const int runs = setting.quick ? 2 : 7;
  const CollageSettings settings;
  const TracedOutline fixed_outline = blob_outline(1);
  const TracedOutline docked_outline = blob_outline(2);
  const Shape fixed = make_shape(fixed_outline, {});
  const Shape docked = make_shape(docked_outline, {});
  const Similarity fixed_pose{0, 250, 500, 500};
  FreeField free(make_rectangle_canvas(1000, 1000), settings.pieces);
  free.stamp(fixed, fixed_pose);
  std::vector<TargetSample> samples = samples_around(fixed_outline, fixed, fixed_pose, settings, sample_count);

  const MatchingContext context = make_matching_context(settings, std::uint32_t(slices));
  const auto matcher = worker::make_device_matcher(setting.devices, context, 0,
                                                   dense_models(docked, docked_outline, context, slices));
  const Grid<float>& field = free.field().value;
  matcher->start_field(field.width(), field.height(), free.field().origin);
  matcher->update_field(read_patch(field, field.bounds()));

  const std::uint64_t points = std::uint64_t(slices) * kFinestSamples;
  std::uint64_t pads = 0;
  for (const int level : context.levels) pads += std::uint64_t(slices) * std::uint64_t(kSmoothingLevels[level].samples);
  const MatchPlan plan{std::uint64_t(double(points) * kPaperTopPercent / 100), 0};
  Docked last;
  const double seconds = median_s(runs, [&] {
    std::rotate(samples.begin(), samples.begin() + 1, samples.end());  // or the device would not count again
    last = dock_best(*matcher, samples, plan, settings, context, docked.perimeter);
  });
  const std::uint64_t positions = samples.size() * points;
  const std::uint64_t tests = samples.size() * pads;

  Table table({"two shapes, PADs to best docking", "this machine", "paper"});
  table.add({"docking positions", std::to_string(positions), "25000000"});
  table.add({"PAD pair tests", std::to_string(tests), "25000000"});
  table.add({"time, ms", short_number(seconds * 1000), short_number(kPaper_s * 1000)});
  table.add({"of it counting, ms", short_number(last.statistics.prune_s * 1000), ""});
  table.add({"docking and refining, ms", short_number(last.statistics.dock_s * 1000), ""});
  table.add({"dockings evaluated", std::to_string(last.statistics.dockings_evaluated), ""});
  table.add({"dockings refined", std::to_string(last.statistics.refined), ""});
  table.add({"best: matched boundary, px", short_number(last.best_matched_px), ""});
  Report report;
  report.text = table.text() +
                "\nCounted as positions: " + std::to_string(samples.size()) + " points of one boundary times " +
                std::to_string(points) +
                " of the other, each point once. Every position is tested\nat " +
                std::to_string(context.levels.size()) +
                " smoothing levels (the coarser ones at fewer points), which together serve scales from 20 to 160 px.\n"
                "The denser sampling lies on the device as " + std::to_string(slices) +
                " entries, each of which keeps its own best pairs. Median of " + std::to_string(runs) +
                " runs;\nthe parts are of the last run. Paper: section 5, Tesla K20m.\n";
  report.json = {{"benchmark", "headline"},
                 {"quick", setting.quick},
                 {"devices", device_names(setting.devices)},
                 {"positions", positions},
                 {"pair_tests", tests},
                 {"target_samples", samples.size()},
                 {"shape_points", points},
                 {"runs", runs},
                 {"median_s", seconds},
                 {"prune_s", last.statistics.prune_s},
                 {"dock_s", last.statistics.dock_s},
                 {"dockings_evaluated", last.statistics.dockings_evaluated},
                 {"dockings_refined", last.statistics.refined},
                 {"best_matched_px", last.best_matched_px},
                 {"paper_positions", 25000000},
                 {"paper_s", kPaper_s}};
  return report;
}

}  // namespace tessera::bench
