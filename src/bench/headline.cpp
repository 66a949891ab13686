#include <algorithm>

#include "bench/benchmarks.h"
#include "bench/devices.h"
#include "bench/inputs/formula_shapes.h"
#include "bench/timing.h"
#include "core/base/stopwatch.h"
#include "core/collage/objective.h"
#include "core/field/free_field.h"
#include "core/geometry/closed_curve.h"
#include "core/matching/match_round.h"
#include "core/matching/matcher.h"
#include "core/matching/pair_limits.h"
#include "core/settings/tuning.h"
#include "core/shape/level_curve.h"
#include "core/shape/shape_builder.h"
#include "text/number_text.h"
#include "text/text_table.h"
#include "worker/device_group.h"

namespace tessera::bench {
namespace {

constexpr double kPaper_s = 0.064;
constexpr std::uint64_t kPaperPositions = 25'000'000;
/// Scale of the piece on the canvas, in the middle of the docked shape's scales, so that most pairs fit in scale. With
/// a larger scale there would be little work.
constexpr float kPlacedScale_px = 80;
constexpr double kPaperTopPercent = 1;      // K of the paper
constexpr std::uint64_t kNearestPairs = 4;  // for each sample
constexpr std::size_t kRefinedOfAll = 32;
constexpr int kFinestSamples = kSmoothingLevels[2].samples;  // models have the same number at every finer level

/// A shape sampled `slices` times as densely as in a library, as that many models: slice i of n holds every n-th sample
/// from the i-th on, so that each sample of the curve occurs once.
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
      slice.samples[std::size_t(i / slices)] =
          make_model_sample(dense[std::size_t(i)], context.pad.levels, keypoint_step(shape.radius));
    }
  }
  return models;
}

/// Target samples all round a piece, with the free region outside it on their left.
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
    samples.push_back({SampleId(i), 0, curve[std::size_t(i)], along * (1 / norm(along)), pyramids[std::size_t(i)]});
  }
  return samples;
}

/// Two blobs: one lies on the canvas, the other docks to it.
struct HeadlineScene {
  CollageSettings settings;
  MatchingContext context;
  std::vector<TargetSample> samples;
  std::vector<ShapeModel> models;
  CanvasField field;
  std::uint64_t points = 0;  // boundary points of the docked shape, each sampled at the finest level
  std::uint64_t pads = 0;    // over all levels

  std::uint64_t positions() const { return samples.size() * points; }
  std::uint64_t pair_tests() const { return samples.size() * pads; }
};

HeadlineScene make_scene(int slices, int sample_count) {
  HeadlineScene scene;
  scene.context = make_matching_context(scene.settings, std::uint32_t(slices));
  const TracedOutline lying_outline = blob_outline(1);
  const TracedOutline docked_outline = blob_outline(2);
  const Shape lying = make_shape(lying_outline, {});
  const Similarity pose{0, kPlacedScale_px, 500, 500};
  FreeField free(make_rectangle_canvas(1000, 1000), scene.settings.pieces);
  free.stamp(lying, pose);
  scene.field = free.field();
  scene.samples = samples_around(lying_outline, lying, pose, scene.settings, sample_count);
  scene.models = dense_models(make_shape(docked_outline, {}), docked_outline, scene.context, slices);
  scene.points = std::uint64_t(slices) * kFinestSamples;
  scene.pads = std::uint64_t(slices) * pads_per_shape(scene.context);
  return scene;
}

struct Docked {
  RunStatistics statistics;
  float best_score = 0;
  float best_matched_px = 0;
};

void keep_best(Docked& docked, const std::vector<RefinedDocking>& refined, const HeadlineScene& scene) {
  const float perimeter = scene.models.front().perimeter;
  for (const RefinedDocking& found : refined) {
    if (!found.feasible) continue;
    const float scale = found.docking.canvas_from_shape.scale();
    const PieceSize size{scale, perimeter * scale, scene.context.max_scale_px};
    const float score = objective(found.terms, size, scene.settings.objective);
    if (score <= docked.best_score) continue;
    docked.best_score = score;
    docked.best_matched_px = found.terms.matched_px;
  }
}

/// The best dockings that are distinct: points close together give the same docking. All entries are of one shape.
std::vector<Docking> best_distinct(std::vector<Docking>& dockings) {
  std::vector<Docking> kept;
  std::make_heap(dockings.begin(), dockings.end(),
                 [](const Docking& a, const Docking& b) { return docks_better(b, a); });
  for (auto end = dockings.end(); end != dockings.begin() && kept.size() < kRefinedOfAll; --end) {
    std::pop_heap(dockings.begin(), end, [](const Docking& a, const Docking& b) { return docks_better(b, a); });
    const Docking& next = *(end - 1);
    const bool repeated = std::any_of(kept.begin(), kept.end(), [&](const Docking& d) {
      return near_copy(d.canvas_from_shape, next.canvas_from_shape, kSameDocking);
    });
    if (!repeated) kept.push_back(next);
  }
  return kept;
}

/// Goes from PADs to the best docking: the nearest pairs of each sample, then the best of all their dockings.
Docked dock_best(Matcher& matcher, const HeadlineScene& scene, const std::vector<TargetSample>& samples) {
  Docked docked;
  Stopwatch watch;
  const DockRequest request{samples, pair_limits(matcher, samples, kNearestPairs), 0};
  docked.statistics.prune_s = watch.lap();
  matcher.post_dock(request);
  DockReply reply = matcher.take_dock();
  const std::vector<Docking> shortlist = best_distinct(reply.dockings);
  matcher.post_refine(shortlist);
  keep_best(docked, matcher.take_refine(), scene);
  docked.statistics.dock_s = watch.lap();
  docked.statistics.dockings_evaluated = reply.evaluated;
  docked.statistics.refined = shortlist.size();
  return docked;
}

/// The engine's method, for comparison: docks K percent of all pairs, and refines the best of every sample.
Docked dock_thoroughly(Matcher& matcher, const HeadlineScene& scene) {
  const MatchPlan plan{std::uint64_t(double(scene.points) * kPaperTopPercent / 100), 0};
  Docked docked;
  keep_best(docked, match(matcher, scene.samples, plan, scene.pads, docked.statistics).refined, scene);
  return docked;
}

struct Measured {
  int runs = 0;
  double median_s = 0;
  Docked last;
  Docked thorough;
};

Measured measure(const HeadlineScene& scene, const std::string& devices_use, int runs) {
  const auto matcher =
      worker::make_device_matcher(devices_use, scene.context, all_of(scene.models), given(scene.models));
  const Grid<float>& field = scene.field.value;
  matcher->start_field(field.width(), field.height(), scene.field.origin);
  matcher->update_field({read_patch(field, field.bounds())});
  Measured measured{runs, 0, {}, dock_thoroughly(*matcher, scene)};
  std::vector<TargetSample> samples = scene.samples;
  measured.median_s = median_s(runs, [&] {
    std::rotate(samples.begin(), samples.begin() + 1, samples.end());  // otherwise the device would not count again
    measured.last = dock_best(*matcher, scene, samples);
  });
  return measured;
}

std::string table_text(const HeadlineScene& scene, const Measured& measured) {
  const RunStatistics& run = measured.last.statistics;
  const auto ms = [](double seconds) { return short_number(1000 * seconds); };
  TextTable table({"two shapes, PADs to best docking", "this machine", "paper"});
  table.add({"docking positions", std::to_string(scene.positions()), std::to_string(kPaperPositions)});
  table.add({"PAD pair tests", std::to_string(scene.pair_tests()), std::to_string(kPaperPositions)});
  table.add({"time, ms", ms(measured.median_s), ms(kPaper_s)});
  table.add({"of it counting, ms", ms(run.prune_s), ""});
  table.add({"docking and refining, ms", ms(run.dock_s), ""});
  table.add({"positions pruned", std::to_string(scene.positions() - run.dockings_evaluated), ""});
  table.add({"dockings evaluated", std::to_string(run.dockings_evaluated), ""});
  table.add({"dockings refined", std::to_string(run.refined), ""});
  table.add({"best: score", fixed(measured.last.best_score, 4), ""});
  table.add({"best: matched boundary, px", short_number(measured.last.best_matched_px), ""});
  return table.text();
}

std::string explanation(const HeadlineScene& scene, const Measured& measured) {
  return "Counted as positions: " + std::to_string(scene.samples.size()) + " points of one boundary times " +
         std::to_string(scene.points) + " of the other, each point once. Every position\nis tested at " +
         std::to_string(scene.context.levels.size()) +
         " smoothing levels (the coarser ones at fewer points), which together serve scales from 20 to 160 px.\n"
         "The denser sampling lies on the device as " +
         std::to_string(scene.models.size()) + " entries, each of which keeps its own best pairs. Median of " +
         std::to_string(measured.runs) + " runs;\nthe parts are of the last run. Docked are the " +
         std::to_string(kNearestPairs) + " nearest pairs of each point, refined the best " +
         std::to_string(kRefinedOfAll) + " of all. To dock " + short_number(kPaperTopPercent) +
         " % of the pairs and refine\nthe best of every point (" +
         std::to_string(measured.thorough.statistics.dockings_evaluated) + " dockings, " +
         std::to_string(measured.thorough.statistics.refined) + " refined, " +
         short_number(1000 * measured.thorough.statistics.prune_s + 1000 * measured.thorough.statistics.dock_s) +
         " ms the first time) finds a score of " + fixed(measured.thorough.best_score, 4) +
         ".\nPaper: section 5, Tesla K20m.\n";
}

Json to_json(const HeadlineScene& scene, const Measured& measured) {
  const RunStatistics& run = measured.last.statistics;
  return {{"positions", scene.positions()},
          {"pair_tests", scene.pair_tests()},
          {"target_samples", scene.samples.size()},
          {"shape_points", scene.points},
          {"runs", measured.runs},
          {"median_s", measured.median_s},
          {"prune_s", run.prune_s},
          {"dock_s", run.dock_s},
          {"dockings_evaluated", run.dockings_evaluated},
          {"dockings_refined", run.refined},
          {"best_score", measured.last.best_score},
          {"thorough_score", measured.thorough.best_score},
          {"best_matched_px", measured.last.best_matched_px},
          {"paper_positions", kPaperPositions},
          {"paper_s", kPaper_s}};
}

}  // namespace

Report bench_headline(const Setting& setting) {
  const HeadlineScene scene = setting.quick ? make_scene(2, 100) : make_scene(40, 5000);
  const Measured measured = measure(scene, setting.devices, setting.quick ? 2 : 7);
  Report report{table_text(scene, measured) + "\n" + explanation(scene, measured), report_head("headline", setting)};
  report.json.update(to_json(scene, measured));
  return report;
}

}  // namespace tessera::bench
