#include <algorithm>

#include "bench/concepts/figures.h"
#include "bench/concepts/pad_drawing.h"
#include "text/number_text.h"

namespace tessera::bench::concepts {
namespace {

constexpr double kSheetWidth_px = 900, kSheetHeight_px = 610;
constexpr std::size_t kShownLevel = 3;  // of kSmoothingLevels

/// The sample whose intervals are seen best.
std::size_t shown_sample(const LevelCurve& curve, int levels) {
  const auto least = [levels](const ArclengthPyramid& pyramid) {
    const Pad pad = make_pad(pyramid, levels);
    return pad.convexity == 0 ? 0 : least_element(pad, levels);
  };
  const auto best = std::max_element(curve.samples.begin(), curve.samples.end(),
                                     [&](const auto& a, const auto& b) { return least(a) < least(b); });
  return std::size_t(best - curve.samples.begin());
}

void draw_smoothing(FigureSheet& sheet, const Shape& shape) {
  const float unit_px = 88 / shape.radius;
  sheet.text({20, 30}, "One outline, smoothed by five widths (in parts of the shape's size)", 15);
  for (std::size_t level = 0; level < shape.levels.size(); ++level) {
    const Vec2 centre{95 + 177 * float(level), 115};
    sheet.closed(applied(scaled_and_moved(unit_px, centre), shape.levels[level].points),
                 {.stroke = kInk, .width_px = 1.5, .fill = level == kShownLevel ? "#ffffff" : kPiece});
    sheet.text({centre.x, 210}, fixed(double(kSmoothingLevels[level].sigma), 3), 14, Anchor::middle);
  }
}

}  // namespace

std::string shapes_figure(const Shape& shape, const PadParameters& pad) {
  FigureSheet sheet(kSheetWidth_px, kSheetHeight_px);
  draw_smoothing(sheet, shape);
  const LevelCurve& curve = shape.levels[kShownLevel];
  const std::size_t sample = shown_sample(curve, pad.levels);
  const std::size_t at = sample * curve.points.size() / curve.samples.size();
  const ArclengthPyramid& pyramid = curve.samples[sample];

  const Similarity sheet_from_shape = scaled_and_moved(200 / shape.radius, {235, 420});
  sheet.closed(applied(sheet_from_shape, curve.points), {.stroke = kPaleInk, .width_px = 1.2, .fill = "#f7f5f1"});
  draw_pad_levels(sheet, sheet_from_shape, curve.points, at, pyramid, pad.levels);

  sheet.text({500, 270}, "Intervals round the orange point p:", 15);
  for (int level = 0; level < pad.levels; ++level) {
    const float y = 298 + 24 * float(level);
    sheet.box({{500, y - 12}, {528, y + 2}}, {.fill = kLevelColours[std::size_t(level)]});
    sheet.text({540, y}, "level " + std::to_string(level) + ": each side turns by " +
                             fixed(double(pad.delta_tau) * (1 << level), 1) + " rad");
  }
  draw_pad_bars(sheet, {{500, 430}, {840, 570}}, make_pad(pyramid, pad.levels), pad.levels);
  sheet.text({500, 448}, "The PAD of p", 15);
  sheet.text({585, 592}, "left side", 14, Anchor::middle);
  sheet.text({755, 592}, "right side", 14, Anchor::middle);
  return sheet.finish();
}

}  // namespace tessera::bench::concepts
