#include "products/nesting/nest_result.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/stop.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

using nlohmann::ordered_json;

bool is_strip(const NestRun& run) { return !std::isfinite(run.problem.length); }

double placed_area(const NestRun& run) {
  double area = 0;
  for (const NestedPiece& piece : run.layout.pieces)
    area += std::abs(signed_area(run.problem.items[std::size_t(piece.item)].outline));
  return area;
}

ordered_json placed_item(const NestRun& run, const NestedPiece& piece) {
  ordered_json item = {{"item_id", run.input.sources[std::size_t(piece.item)].number},
                       {"name", run.input.sources[std::size_t(piece.item)].drawing.name},
                       {"transformation",
                        {{"rotation", run.problem.items[std::size_t(piece.item)].angles_deg[std::size_t(piece.angle)]},
                         {"translation", {piece.shift.x, piece.shift.y}}}}};
  if (!is_strip(run)) item["sheet"] = piece.sheet + 1;
  return item;
}

std::string left_over_text(const NestRun& run) {
  std::string text;
  for (std::size_t i = 0; i < run.layout.left_over.size(); ++i) {
    const int count = run.layout.left_over[i];
    if (count > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " x " +
              printable_utf8(run.input.sources[i].drawing.name);
  }
  return text.empty() ? "nothing" : text;
}

}  // namespace

double density_of(const NestRun& run) {
  const double length = is_strip(run) ? run.layout.used_length : run.problem.length * run.layout.sheets;
  return length > 0 ? placed_area(run) / (run.problem.height * length) : 0;
}

int wanted_pieces(const NestRun& run) {
  int count = 0;
  for (const NestItem& item : run.problem.items) count += item.demand;
  return count;
}

std::string stopped_by_text(const NestRun& run) {
  if (run.stopped_by == StopReason::signal) return "a signal";
  return run.stopped_by == StopReason::lost_rank ? "a lost rank" : "the time limit";
}

std::string nest_layout_json(const NestRun& run) {
  ordered_json items = ordered_json::array();
  for (const NestedPiece& piece : run.layout.pieces) items.push_back(placed_item(run, piece));
  ordered_json left = ordered_json::array();
  for (std::size_t i = 0; i < run.layout.left_over.size(); ++i) {
    if (run.layout.left_over[i] > 0)
      left.push_back({{"item_id", run.input.sources[i].number},
                      {"name", run.input.sources[i].drawing.name},
                      {"count", run.layout.left_over[i]}});
  }
  ordered_json layout = {{"program", kNestProgram}, {"name", run.input.name}, {"strip_height", run.problem.height}};
  if (!is_strip(run)) layout["sheet_width"] = run.problem.length;
  if (run.stopped_by) layout["stopped_by"] = stop_word(*run.stopped_by);
  layout["solution"] = {{"strip_width", run.layout.used_length},
                        {"sheets", run.layout.sheets},
                        {"density", density_of(run)},
                        {"layout", {{"container_id", 0}, {"placed_items", items}, {"density", density_of(run)}}},
                        {"left_over", left}};
  return layout.dump(1) + "\n";
}

std::string nest_card_text(const NestRun& run) {
  const auto line = [](const std::string& label, const std::string& value) {
    return "  " + label + std::string(16 - label.size(), ' ') + value + "\n";
  };
  const std::string length = fixed(run.layout.used_length, 3) + " mm";
  std::string text = std::string(kNestProgram) + ": " + printable_utf8(run.input.name) + "\n";
  text += line("pieces", std::to_string(run.layout.pieces.size()) + " of " + std::to_string(wanted_pieces(run)));
  text += line("density", fixed(100 * density_of(run), 2) + " %");
  if (is_strip(run)) {
    text += line("strip", fixed(run.problem.height, 3) + " mm high");
    text += line("length", length);
  } else {
    text += line("sheets", std::to_string(run.layout.sheets) + " of " + fixed(run.problem.length, 3) + " x " +
                               fixed(run.problem.height, 3) + " mm");
    text += line("last sheet", length + " of its length used");
  }
  text += line("unit", run.input.unit.empty() ? "mm" : "mm; 1 unit of the input is taken as " + run.input.unit);
  text += line("spacing", fixed(run.problem.spacing, 3) + " mm");
  text += line("did not fit", left_over_text(run));
  text += line("effort", run.effort + ", seed " + std::to_string(run.seed));
  if (run.stopped_by) {
    text += line("stopped", "by " + stopped_by_text(run) + ": the same command may give another layout");
  }
  return text + line("time", fixed(run.seconds, 1) + " s");
}

}  // namespace tessera
