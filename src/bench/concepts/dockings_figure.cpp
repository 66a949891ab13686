#include <array>
#include <optional>

#include "bench/concepts/docked_round.h"
#include "bench/concepts/figures.h"
#include "core/base/error.h"

namespace tessera::bench::concepts {
namespace {

constexpr float kDockPanel_px = 280, kDockZoom = 1.25f;
constexpr std::size_t kRoundsLookedAt = 16;

/// The distance by which refinement moves a pose, in parts of the piece's size.
float move_between(const Similarity& a, const Similarity& b) {
  return (norm(a.translation() - b.translation()) + std::abs(a.scale() - b.scale())) / b.scale();
}

struct ShownDocking {
  ShapeId shape{};
  Vec2 sample_px;
  std::vector<Placement> placements;            // that stand before it
  std::array<Similarity, 3> canvas_from_shape;  // docked, refined, placed

  float move() const { return move_between(canvas_from_shape[0], canvas_from_shape[1]); }
};

/// The docking that the next piece comes from; nothing where that is a random one, or the piece would not be seen whole.
std::optional<ShownDocking> next_docking(CollageStage& stage, const Candidate& best) {
  const TracedTarget target(stage.collage().free(), stage.settings());
  const DockedRound round = docked_round(stage, target);
  for (std::size_t i = 0; i < round.docked.size(); ++i) {
    const Docking& docked = round.docked[i];
    const RefinedDocking& refined = round.refined[i];
    if (!is_of_pads(docked) || docked.shape != best.shape || docked.source != best.source || !refined.feasible)
      continue;
    const Similarity& before = docked.canvas_from_shape;
    if (refined.radius * before.scale() > 0.4f * kDockPanel_px / kDockZoom) continue;  // it would not be seen whole
    if (norm(best.canvas_from_shape.translation() - before.translation()) > 0.5f * before.scale()) continue;
    return ShownDocking{best.shape,
                        round.samples[docked.sample].position,
                        {},
                        {before, refined.docking.canvas_from_shape, best.canvas_from_shape}};
  }
  return {};
}

}  // namespace

std::string dockings_figure(CollageStage& stage) {
  std::optional<ShownDocking> shown;
  const std::size_t first = stage.collage().placements().size();
  for (std::size_t pieces = first; pieces < first + kRoundsLookedAt; ++pieces) {
    stage.place(pieces);
    Candidate best;
    if (!stage.collage().choose(best)) break;
    const std::optional<ShownDocking> next = next_docking(stage, best);
    if (next && (!shown || next->move() > shown->move())) {
      shown = next;
      shown->placements = stage.collage().placements();
    }
  }
  if (!shown) throw InputError("no piece came from a pair of PADs; allowed: a library of more shapes");
  FigureSheet sheet(900, 340);
  const std::array<const char*, 3> names = {"docked: key points aligned", "refined on the distance field",
                                            "settled and grown: the piece"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Vec2 corner{20 + 293 * float(i), 40};
    const Vec2 middle = corner + Vec2{0.5f * kDockPanel_px, 0.5f * kDockPanel_px};
    const Similarity sheet_from_canvas = scaled_and_moved(
        kDockZoom, middle - stage.middle_of_view(shown->canvas_from_shape[2].translation(), kDockPanel_px / kDockZoom) *
                                kDockZoom);
    sheet.begin_clip({corner, corner + Vec2{kDockPanel_px, kDockPanel_px}});
    stage.draw(sheet, sheet_from_canvas, shown->placements);
    stage.draw_piece(sheet, sheet_from_canvas, shown->shape, shown->canvas_from_shape[i],
                     {.stroke = kBlue, .width_px = 1.6, .fill = "#0072b233"});
    sheet.dot(sheet_from_canvas.apply(shown->sample_px), 4.5, kOrange);
    sheet.end_clip();
    sheet.text({middle.x, 26}, names[i], 15, Anchor::middle);
  }
  return sheet.finish();
}

}  // namespace tessera::bench::concepts
