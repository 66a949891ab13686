#include "bench/concepts/figures.h"

namespace tessera::bench::concepts {

std::string target_figure(CollageStage& stage) {
  const Canvas& canvas = stage.canvas();
  const FreeField& free = stage.collage().free();
  const TracedTarget target(free, stage.settings());
  constexpr float kMargin_px = 16;
  FigureSheet sheet(canvas.width_px + 2 * kMargin_px, canvas.height_px + 2 * kMargin_px);
  const Similarity sheet_from_canvas = scaled_and_moved(1, {kMargin_px, kMargin_px});
  stage.draw(sheet, sheet_from_canvas);
  for (const std::vector<Vec2>& curve : target.contours(free))
    sheet.closed(applied(sheet_from_canvas, curve), {.stroke = kBlue, .width_px = 1.8, .fill = "#0072b214"});
  for (const TargetSample& sample : target.samples()) sheet.dot(sheet_from_canvas.apply(sample.position), 3, kOrange);
  return sheet.finish();
}

}  // namespace tessera::bench::concepts
