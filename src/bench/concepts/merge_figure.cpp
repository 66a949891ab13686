#include <algorithm>

#include "bench/concepts/figures.h"

namespace tessera::bench::concepts {
namespace {

constexpr float kMergePanel_px = 425, kMergeZoom = 1.15f;

bool is_among(const std::vector<SampleId>& ids, SampleId id) { return std::binary_search(ids.begin(), ids.end(), id); }

void draw_curves(FigureSheet& sheet, const Similarity& sheet_from_canvas, const TracedTarget& target,
                 const FreeField& free) {
  for (const std::vector<Vec2>& curve : target.contours(free))
    sheet.closed(applied(sheet_from_canvas, curve), {.stroke = kPaleInk, .width_px = 1});
}

}  // namespace

std::string merge_figure(CollageStage& stage) {
  master::Collage& collage = stage.collage();
  FigureSheet sheet(900, 500);
  FreeField free = collage.free();
  const std::vector<Placement> standing = collage.placements();
  stage.place(standing.size() + 1);
  if (collage.placements().size() == standing.size()) return sheet.finish();
  const Placement& placed = collage.placements().back();
  TracedTarget target(free, stage.settings());
  const std::vector<TargetSample> before = target.samples();
  const Vec2 centre = stage.middle_of_view(placed.canvas_from_shape.translation(), kMergePanel_px / kMergeZoom);
  const auto frame = [&](int panel) {
    const Vec2 corner{20 + 435 * float(panel), 36};
    sheet.begin_clip({corner, corner + Vec2{kMergePanel_px, kMergePanel_px}});
    return scaled_and_moved(kMergeZoom,
                            corner + Vec2{0.5f * kMergePanel_px, 0.5f * kMergePanel_px} - centre * kMergeZoom);
  };

  Similarity sheet_from_canvas = frame(0);
  stage.draw(sheet, sheet_from_canvas, standing);
  stage.draw_piece(sheet, sheet_from_canvas, placed.shape, placed.canvas_from_shape,
                   {.stroke = kGreen, .width_px = 1.6, .fill = "#009e7326", .dashed = true});
  draw_curves(sheet, sheet_from_canvas, target, free);
  const Window changed = free.stamp(stage.shapes().shape(placed.shape), placed.canvas_from_shape);
  TargetCurve::Change change = target.update(free, changed);
  for (const TargetSample& s : before)
    sheet.dot(sheet_from_canvas.apply(s.position), 4, is_among(change.removed, s.id) ? kOrange : kPaleInk);
  sheet.end_clip();

  sheet_from_canvas = frame(1);
  stage.draw(sheet, sheet_from_canvas);
  draw_curves(sheet, sheet_from_canvas, target, free);
  for (const TargetSample& s : target.samples()) {
    const bool known =
        std::any_of(before.begin(), before.end(), [&](const TargetSample& old) { return old.id == s.id; });
    const bool renewed = is_among(change.renewed, s.id);
    sheet.dot(sheet_from_canvas.apply(s.position), 4, !renewed ? kPaleInk : known ? kBlue : kGreen);
  }
  sheet.end_clip();
  sheet.text({20, 24}, "before: orange samples are cut out", 15);
  sheet.text({455, 24}, "after: green ones are pasted in, blue ones changed", 15);
  sheet.text({20, 486}, "Grey samples keep their PADs.", 14);
  return sheet.finish();
}

}  // namespace tessera::bench::concepts
