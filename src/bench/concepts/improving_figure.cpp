#include <algorithm>
#include <map>

#include "bench/concepts/figures.h"
#include "core/replacing/canvas_windows.h"
#include "core/replacing/incoming_shapes.h"
#include "core/replacing/own_replacer.h"
#include "core/replacing/repetition_costs.h"

namespace tessera::bench::concepts {
namespace {

constexpr float kWindowZoom = 0.68f;
constexpr std::uint32_t kTrials = 120;
constexpr float kPartX = 0.3f, kPartY = 0.6f;  // where the cuts lie

/// The window in which the most pieces may move, with what its trials need.
CutWindow shown_window(CollageStage& stage, const std::vector<PosedPiece>& all, std::vector<CutWindow>& cuts,
                       const CanvasWindows& windows) {
  CutWindow cut = *std::max_element(cuts.begin(), cuts.end(), [](const CutWindow& a, const CutWindow& b) {
    return a.moving.size() < b.moving.size();
  });
  ReplacementWindow& window = cut.window;
  windows.complete(window);
  window.incoming = incoming_shapes(stage.context().stances, stage.shapes(), 1);
  std::map<ShapeId, double> areas_px2;
  for (const IncomingShape& in : window.incoming) areas_px2[in.drawing];
  for (const PosedPiece& p : all) {
    const double scale_px = double(p.piece.canvas_from_shape.scale());
    areas_px2[p.piece.drawing] += scale_px * scale_px;
  }
  for (const auto& [drawing, px2] : areas_px2) window.drawn.push_back({drawing, px2});
  window.random = 1;
  window.trials = kTrials;
  window.first_temperature_px2 = 0.01f * window.least_scale_px * window.most_scale_px;
  return cut;
}

}  // namespace

std::string improving_figure(CollageStage& stage) {
  stage.place(SIZE_MAX);
  const CollageSettings& settings = stage.settings();
  const StanceTable& stances = stage.context().stances;
  const FreeField canvas_alone(stage.canvas(), settings.pieces);
  const CanvasWindows windows(
      canvas_alone, settings.pieces,
      repetition_costs(settings, count_drawings(stances, stage.shapes()), stage.canvas().area_px2));
  const std::vector<Placement>& placements = stage.collage().placements();
  const std::vector<PosedPiece> all =
      posed_pieces(placements, stage.shapes(), [&](const Placement&) { return stances[0].poses; });
  std::vector<CutWindow> cuts = windows.cut(all, 0, kPartX, kPartY);
  const CutWindow cut = shown_window(stage, all, cuts, windows);
  OwnReplacer replacer(stage.shapes(), 1, never_stop);
  replacer.post_replace({cut.window});
  const ReplacementOutcome outcome = replacer.take_replaced().front();

  std::vector<Placement> still;
  for (std::size_t i = 0; i < placements.size(); ++i) {
    if (std::find(cut.moving.begin(), cut.moving.end(), i) == cut.moving.end()) still.push_back(placements[i]);
  }
  std::vector<bool> stays(cut.moving.size(), false);
  for (const ReplacedPiece& p : outcome.pieces) {
    if (p.from != ReplacedPiece::kNew) stays[p.from] = true;
  }

  FigureSheet sheet(914, 350);
  const auto frame = [](int panel) { return scaled_and_moved(kWindowZoom, {14 + 450 * float(panel), 36}); };
  const Vec2 far{float(stage.canvas().width_px), float(stage.canvas().height_px)};
  const auto begin_panel = [&](int panel) {
    sheet.begin_clip({frame(panel).apply({-4, -4}), frame(panel).apply(far + Vec2{4, 4})});
  };
  const auto draw_windows = [&](const Similarity& sheet_from_canvas) {
    for (const CutWindow& c : cuts)
      sheet.box({sheet_from_canvas.apply(c.window.box.low), sheet_from_canvas.apply(c.window.box.high)},
                {.stroke = kPaleInk, .width_px = 0.8, .dashed = true});
    sheet.box({sheet_from_canvas.apply(cut.window.box.low), sheet_from_canvas.apply(cut.window.box.high)},
              {.stroke = kInk, .width_px = 2, .dashed = true});
  };

  begin_panel(0);
  stage.draw(sheet, frame(0), still);
  for (std::size_t i = 0; i < cut.moving.size(); ++i) {
    const Placement& p = placements[cut.moving[i]];
    stage.draw_piece(sheet, frame(0), p.shape, p.canvas_from_shape,
                     {.stroke = kInk, .width_px = 0.7, .fill = stays[i] ? "#9ecae1" : "#f0b48c"});
  }
  draw_windows(frame(0));
  sheet.end_clip();
  begin_panel(1);
  stage.draw(sheet, frame(1), still);
  for (const ReplacedPiece& p : outcome.pieces) {
    stage.draw_piece(sheet, frame(1), p.shape, p.canvas_from_shape,
                     {.stroke = kInk, .width_px = 0.7, .fill = p.from == ReplacedPiece::kNew ? "#8fd0bb" : "#9ecae1"});
  }
  draw_windows(frame(1));
  sheet.end_clip();
  sheet.text({14, 24}, "before: orange pieces will go", 15);
  sheet.text({464, 24}, "after " + std::to_string(kTrials) + " trials: green ones came, blue ones made room", 15);
  return sheet.finish();
}

}  // namespace tessera::bench::concepts
