#include "result/afar_section.h"

#include <nlohmann/json.hpp>

#include "result/card_lines.h"
#include "text/number_text.h"

namespace tessera {
namespace {

using Json = nlohmann::ordered_json;

Json figures_json(const AfarFigures& figures) {
  return {{"width_px", figures.width_px},
          {"height_px", figures.height_px},
          {"ciede2000", rounded(figures.colour_difference, 3)},
          {"ssim", rounded(figures.structure, 3)}};
}

std::string figures_text(const AfarFigures& figures) {
  return "colour " + fixed(figures.colour_difference, 2) + " (CIEDE2000), structure " + fixed(figures.structure, 3) +
         " (SSIM)";
}

std::string width_text(const AfarFigures& figures) { return std::to_string(figures.width_px) + " px wide"; }

}  // namespace

std::string afar_json(const AfarNote& note) {
  if (!note.seen) return Json{{"not_measured", note.not_measured}}.dump(-1, ' ', false, Json::error_handler_t::replace);
  const auto& at_piece_size = note.seen->at_piece_size;
  const Json section{{"at_100_px", figures_json(note.seen->at_100_px)},
                     {"at_piece_size", at_piece_size ? figures_json(*at_piece_size) : Json()}};
  return section.dump();
}

std::string afar_text(const AfarNote& note) {
  if (!note.seen) return kAfarHeading + card_line("not measured", note.not_measured);
  const AfarFigures& whole = note.seen->at_100_px;
  std::string text = kAfarHeading + card_line(width_text(whole), figures_text(whole));
  if (const auto& pieces = note.seen->at_piece_size) {
    text += card_line(width_text(*pieces), figures_text(*pieces)) + card_line("", "(one px for a piece of mean size)");
  }
  return text;
}

}  // namespace tessera
