#include <algorithm>
#include <set>
#include <span>

#include "bench/concepts/docked_round.h"
#include "bench/concepts/figures.h"
#include "bench/concepts/pad_drawing.h"
#include "core/geometry/extent.h"
#include "core/matching/pair_selection.h"
#include "text/number_text.h"

namespace tessera::bench::concepts {
namespace {

constexpr std::size_t kShownPairs = 3;
constexpr float kColumn_px = 220, kPairPanel_px = 200, kBarsTop_px = 240;

/// The smoothed outline on which a docking's PAD lies.
const LevelCurve& docked_curve(CollageStage& stage, const Shape& shape, const SourceLocation& location) {
  return shape.levels[std::size_t(stage.context().levels[std::size_t(location.level_slot)])];
}

/// The PAD of the shape's point that a docking came from.
Pad pad_of(CollageStage& stage, const Docking& docking) {
  const SourceLocation found = locate_source(stage.context().levels, docking.source);
  const Shape shape = stage.with_levels(docking.shape);
  return make_pad(docked_curve(stage, shape, found).samples[std::size_t(found.index)],
                  stage.settings().match.pad.levels);
}

/// The dockings of one sample that came from PADs, each of another silhouette.
std::vector<Docking> pairs_of(CollageStage& stage, const DockedRound& round, std::uint32_t sample) {
  std::vector<Docking> pairs;
  std::set<ShapeId> shapes;
  for (const Docking& d : round.docked) {
    if (d.sample == sample && is_of_pads(d) && shapes.insert(stage.shapes().silhouette(d.shape)).second)
      pairs.push_back(d);
  }
  return pairs;
}

/// Pairs of the same convexity, none of them nearly the same PAD as another. (A flat point agrees with either
/// convexity, which bars do not show, and some drawings are there twice.)
std::vector<Docking> shown_pairs(CollageStage& stage, const DockedRound& round, std::uint32_t sample,
                                 const Pad& target) {
  constexpr float kNearlySame = 0.01f;
  const int levels = stage.settings().match.pad.levels;
  std::vector<Docking> shown;
  std::vector<Pad> pads;
  for (const Docking& docking : pairs_of(stage, round, sample)) {
    const Pad pad = pad_of(stage, docking);
    const bool repeats =
        std::any_of(pads.begin(), pads.end(), [&](const Pad& p) { return pad_distance(p, pad, levels) < kNearlySame; });
    if (pad.convexity != target.convexity || repeats || shown.size() == kShownPairs) continue;
    shown.push_back(docking);
    pads.push_back(pad);
  }
  return shown;
}

/// The sample, among those with enough pairs, whose intervals are long and differ little: they are seen best.
std::uint32_t shown_sample(CollageStage& stage, const DockedRound& round, int levels) {
  std::uint32_t best = 0;
  float most = -1;
  for (std::uint32_t s = 0; s < round.samples.size(); ++s) {
    const Pad pad = make_pad(round.samples[s].pyramid, levels);
    if (shown_pairs(stage, round, s, pad).size() < kShownPairs) continue;
    const float length_px = round.samples[s].pyramid.left[std::size_t(levels - 1)] +
                            round.samples[s].pyramid.right[std::size_t(levels - 1)];
    const float clarity = least_element(pad, levels) * std::min(length_px, 2 * kPairPanel_px);
    if (pad.convexity != 0 && clarity > most) {
      most = clarity;
      best = s;
    }
  }
  return best;
}

struct CurvePoint {
  const std::vector<Vec2>* curve = nullptr;
  std::size_t at = 0;
};

CurvePoint nearest_point(const std::vector<std::vector<Vec2>>& curves, Vec2 p) {
  CurvePoint nearest;
  float least = 1e9f;
  for (const std::vector<Vec2>& curve : curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      if (norm(curve[i] - p) >= least) continue;
      least = norm(curve[i] - p);
      nearest = {&curve, i};
    }
  }
  return nearest;
}

Box bars_box(std::size_t column) {
  const float left = 20 + kColumn_px * float(column);
  return {{left + 10, kBarsTop_px}, {left + kPairPanel_px - 10, kBarsTop_px + 96}};
}

void draw_pair(FigureSheet& sheet, CollageStage& stage, const Docking& docking, const Pad& target, std::size_t column) {
  const int levels = stage.settings().match.pad.levels;
  const Shape shape = stage.with_levels(docking.shape);
  const SourceLocation found = locate_source(stage.context().levels, docking.source);
  const LevelCurve& curve = docked_curve(stage, shape, found);
  const std::size_t at = std::size_t(found.index) * curve.points.size() / curve.samples.size();
  const Vec2 centre{20 + kColumn_px * float(column) + 0.5f * kPairPanel_px, 140};
  const float unit_px = 0.46f * kPairPanel_px / shape.radius;
  // The shape fills the panel, in the rotation that the docking gives it.
  const Similarity turned{std::cos(docking.canvas_from_shape.rotation_rad()) * unit_px,
                          std::sin(docking.canvas_from_shape.rotation_rad()) * unit_px, centre.x, centre.y};
  sheet.closed(applied(turned, curve.points), {.stroke = kPaleInk, .width_px = 1, .fill = "#f7f5f1"});
  draw_pad_levels(sheet, turned, curve.points, at, curve.samples[std::size_t(found.index)], levels);
  const Pad pad = make_pad(curve.samples[std::size_t(found.index)], levels);
  draw_pad_bars(sheet, bars_box(column), pad, levels);
  sheet.text({centre.x, 358}, "distance " + fixed(double(pad_distance(target, pad, levels)), 3), 14, Anchor::middle);
}

}  // namespace

std::string pairs_figure(CollageStage& stage) {
  const int levels = stage.settings().match.pad.levels;
  const FreeField& free = stage.collage().free();
  const TracedTarget target(free, stage.settings());
  const DockedRound round = docked_round(stage, target);
  const std::uint32_t shown = shown_sample(stage, round, levels);
  const TargetSample& sample = round.samples[shown];

  FigureSheet sheet(900, 374);
  sheet.text({120, 26}, "target sample", 15, Anchor::middle);
  sheet.text({560, 26}, "three points of the library with a PAD like it", 15, Anchor::middle);
  const std::span<const Vec2> keypoints(sample.pyramid.keypoint.data(), std::size_t(2 * levels + 1));
  const Extent seen = extent_of(keypoints, {});
  const Vec2 size = seen.high - seen.low;
  const float zoom = std::min(1.2f, 0.85f * kPairPanel_px / std::max(size.x, size.y));
  const Similarity sheet_from_canvas = scaled_and_moved(zoom, Vec2{120, 140} - (seen.low + size * 0.5f) * zoom);
  const std::vector<std::vector<Vec2>> curves = target.contours(free);
  const CurvePoint point = nearest_point(curves, sample.position);
  sheet.begin_clip({{16, 34}, {224, 246}});
  sheet.closed(applied(sheet_from_canvas, *point.curve), {.stroke = kBlue, .width_px = 1.2});
  draw_pad_levels(sheet, sheet_from_canvas, *point.curve, point.at, sample.pyramid, levels);
  sheet.end_clip();
  const Pad pad = make_pad(sample.pyramid, levels);
  draw_pad_bars(sheet, bars_box(0), pad, levels);
  std::size_t column = 1;
  for (const Docking& docking : shown_pairs(stage, round, shown, pad)) draw_pair(sheet, stage, docking, pad, column++);
  return sheet.finish();
}

}  // namespace tessera::bench::concepts
