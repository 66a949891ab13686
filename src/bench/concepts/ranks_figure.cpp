#include <array>
#include <utility>

#include "bench/concepts/figures.h"
#include "core/ranks/worker_tree.h"
#include "text/number_text.h"

namespace tessera::bench::concepts {
namespace {

constexpr int kRanks = 21;
constexpr float kRankRadius_px = 15, kStep_px = 42, kLeft_px = 34;

std::string size_text(std::size_t bytes, int asked) {
  if (asked == 0) return "-";
  return fixed(double(bytes) / double(asked) / 1024, bytes < 10240 * std::size_t(asked) ? 1 : 0) + " KB";
}

int depth_of(int rank) {
  const int parent = place_in_tree(rank, kRanks).parent;
  return parent < 0 ? 0 : 1 + depth_of(parent);
}

/// The master above the middle; each worker in the column of its rank, and as low as it is deep in the tree.
Vec2 place_of(int rank) {
  const float x = rank == 0 ? kLeft_px + 0.5f * kStep_px * float(kRanks - 2) : kLeft_px + kStep_px * float(rank - 1);
  return {x, 44 + 74 * float(depth_of(rank))};
}

void draw_tree(FigureSheet& sheet) {
  for (int rank = 0; rank < kRanks; ++rank) {
    for (const int child : place_in_tree(rank, kRanks).children)
      sheet.open({place_of(rank), place_of(child)}, {.stroke = kPaleInk, .width_px = 1.4});
  }
  for (int rank = 0; rank < kRanks; ++rank) {
    sheet.dot(place_of(rank), double(kRankRadius_px), rank == 0 ? kOrange : kBlue);
    sheet.text(place_of(rank) + Vec2{0, 5}, std::to_string(rank), 14, Anchor::middle, "#ffffff");
  }
}

void draw_row(FigureSheet& sheet, float y, const std::array<std::string, 5>& cells) {
  constexpr std::array<float, 5> kColumns_px = {34, 160, 280, 400, 510};
  for (std::size_t i = 0; i < cells.size(); ++i) sheet.text({kColumns_px[i], y}, cells[i]);
}

}  // namespace

std::string ranks_figure(CollageStage& stage) {
  stage.matcher().take_weight();
  stage.place(stage.collage().placements().size() + 1);
  const RoundWeight weight = stage.matcher().take_weight();
  FigureSheet sheet(910, 470);
  draw_tree(sheet);
  float y = 270;
  draw_row(sheet, y, {"message", "times a round", "each question", "each answer", "what travels"});
  sheet.open({{34, y + 8}, {876, y + 8}}, {.stroke = kInk});
  const auto row = [&](const char* name, const QuestionWeight& q, const char* what) {
    draw_row(sheet, y += 32,
             {name, std::to_string(q.asked), size_text(q.sent_bytes, q.asked),
              q.answered_bytes > 0 ? size_text(q.answered_bytes, q.asked) : "none", what});
  };
  row("update field", weight.field, "the nodes of the free field that changed");
  row("count", weight.count, "target samples; histograms of PAD distances");
  row("dock", weight.dock, "thresholds; the best dockings of each sample");
  row("refine", weight.refine, "dockings; refined poses with their terms");
  row("measure", weight.measure, "candidates near the new piece; their terms");
  sheet.text({34, 458}, "Measured with " + std::to_string(stage.context().library_shapes) +
                            " shapes. The master is orange; a worker answers for itself and all ranks below it.");
  return sheet.finish();
}

}  // namespace tessera::bench::concepts
