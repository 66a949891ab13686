#include "worker/speed_task.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/run_statistics.h"
#include "core/field/free_field.h"
#include "core/field/opened_field.h"
#include "core/field/target_curve.h"
#include "core/geometry/smoothing_spline.h"
#include "core/matching/match_round.h"
#include "core/shape/shape_builder.h"

namespace tessera::worker {
namespace {

constexpr float kTwoPi = 2 * std::numbers::pi_v<float>;
constexpr int kBlobs = 4;  // different shapes: each takes some milliseconds to make
constexpr int kCopies = 50;
constexpr int kCanvas_px = 320;
constexpr std::size_t kMostSamples = 100;

/// A curve with lobes, different for each number.
Shape blob(int number, const PadParameters& pad) {
  constexpr int kPoints = 256;
  constexpr float kRadius_px = 100;
  std::vector<Vec2> curve;
  for (int i = 0; i < kPoints; ++i) {
    const float angle = kTwoPi * float(i) / kPoints;
    const float lobes = 0.2f * std::sin(float(2 + number % 3) * angle) + 0.15f * std::sin(5 * angle + float(number));
    curve.push_back(Vec2{std::cos(angle), std::sin(angle)} * (kRadius_px * (1 + lobes)));
  }
  constexpr double kSmoothing_px = 1.5;
  TracedOutline traced;
  traced.curves.push_back(smoothing_spline(curve, kSmoothing_px));
  return make_shape(traced, pad);
}

/// Stamps the shapes in a ring round the middle of the canvas.
void stamp_ring(FreeField& free, const std::vector<Shape>& shapes) {
  constexpr float kRing_px = 0.27f * kCanvas_px;
  constexpr float kScale_px = 0.2f * kCanvas_px;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const float angle = kTwoPi * float(i) / float(shapes.size());
    free.stamp(shapes[i],
               {kScale_px * std::cos(angle), kScale_px * std::sin(angle),
                0.5f * kCanvas_px + kRing_px * std::cos(angle), 0.5f * kCanvas_px + kRing_px * std::sin(angle)});
  }
}

/// Some samples of the target curve, spread evenly over all.
std::vector<TargetSample> samples_of(const FreeField& free, const CollageSettings& settings) {
  const OpenedField opened(free, settings.pieces);
  TargetCurve curve(settings.pieces, settings.match.pad);
  curve.retrace(opened, free.field().origin, {opened.contour().bounds()});
  const std::vector<SampleId> ids = curve.samples();
  const std::size_t count = std::min(ids.size(), kMostSamples);
  std::vector<TargetSample> samples;
  for (std::size_t i = 0; i < count; ++i) samples.push_back(curve.sample(ids[i * ids.size() / count]));
  return samples;
}

}  // namespace

SpeedTask make_speed_task(const PadParameters& pad) {
  CollageSettings settings;
  settings.match.pad = pad;
  std::vector<Shape> shapes;
  for (int i = 0; i < kBlobs; ++i) shapes.push_back(blob(i, pad));
  SpeedTask task;
  task.context = make_matching_context(settings, kBlobs * kCopies);
  for (int i = 0; i < kBlobs * kCopies; ++i) {
    task.models.push_back(i < kBlobs ? make_shape_model(shapes[std::size_t(i)], pad, pad, task.context.levels)
                                     : task.models[std::size_t(i % kBlobs)]);
  }
  FreeField free(make_rectangle_canvas(kCanvas_px, kCanvas_px), settings.pieces);
  stamp_ring(free, shapes);
  task.field = free.field();
  task.samples = samples_of(free, settings);
  return task;
}

void do_speed_task(Matcher& matcher, const SpeedTask& task) {
  const std::uint64_t pads = task.models.size() * pads_per_shape(task.context);
  RunStatistics statistics;
  matcher.limit({});  // forgets pairs
  match(matcher, task.samples, match_plan({}, pads), pads, statistics);
}

}  // namespace tessera::worker
