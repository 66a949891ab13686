#include "result/card_input.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/stop.h"
#include "result/card_bounds.h"
#include "result/folder/result_file.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

using nlohmann::json;

json parsed(const std::string& folder, const std::string& path) {
  json card = json::parse(read_result_json(folder, "card.json", kCardBounds), nullptr, false);
  if (card.is_discarded()) throw InputError(path + ": not JSON; allowed: a card.json of tessera collage");
  return card;
}

const json& value_at(const json& card, const std::string& path, const char* section, const char* key) {
  const auto part = card.find(section);
  if (part == card.end() || !part->is_object() || !part->contains(key)) {
    throw InputError(path + ": " + section + "." + key + " is missing; allowed: a card.json of tessera collage");
  }
  return part->at(key);
}

// Upper bounds of the measures. Coverage is counted in cells, so a small canvas may be covered by a little more than 1.
constexpr double kMostCoverage = 1.1;
constexpr double kMostLayers = 1e6;  // area covered twice or outside, divided by the canvas' area
constexpr double kMostPiecesTold = 1e9;
constexpr double kMostLength_px = 1e6;
constexpr double kMostCopies = 2;  // in canvas diagonals; both copies may reach beyond the edge
constexpr double kMostTime_s = 1e12;
constexpr double kMostColourDifference = 200;  // the largest CIEDE2000 of colours in a picture
constexpr double kMostReduced_px = 1e6;

double number(const json& card, const std::string& path, const char* section, const char* key, double most,
              double least = 0) {
  const json& value = value_at(card, path, section, key);
  if (!value.is_number() || value.get<double>() < least || value.get<double>() > most) {
    throw InputError(path + ": " + section + "." + key + ": found " + value.dump().substr(0, 60) +
                     ", allowed: a number from " + significant(least, 10) + " to " + significant(most, 10));
  }
  return value.get<double>();
}

/// A number, or empty where the card has null.
std::optional<double> number_or_null(const json& card, const std::string& path, const char* section, const char* key,
                                     double most) {
  if (value_at(card, path, section, key).is_null()) return {};
  return number(card, path, section, key, most);
}

/// Reads the measures that older cards do not have.
void read_picture_measures(const json& card, const std::string& path, Quality& quality) {
  const auto measure = [&](const char* key, double most) { return number_or_null(card, path, "quality", key, most); };
  const auto evenness = measure("size_balance", 1), dwarfs = measure("dwarfs_fraction", 1);
  if (evenness && dwarfs) quality.balance = SizeBalance{*evenness, *dwarfs};
  quality.copies_px = measure("nearest_copy_px", kMostLength_px);
  quality.copies_apart = measure("nearest_copy_fraction", kMostCopies);
  quality.between_px = measure("between_pieces_px", kMostLength_px);
  quality.alone = number(card, path, "quality", "alone_fraction", 1);
}

AfarFigures read_figures(const json& section, const std::string& path, const char* key) {
  const auto px = [&](const char* side) { return int(number(section, path, key, side, kMostReduced_px, 1)); };
  return {.width_px = px("width_px"),
          .height_px = px("height_px"),
          .colour_difference = number(section, path, key, "ciede2000", kMostColourDifference),
          .structure = number(section, path, key, "ssim", 1, -1)};
}

/// Reads the section from_afar. Empty where the card has none (other jobs, older cards) or nothing was measured.
std::optional<SeenFromAfar> read_afar(const json& card, const std::string& path) {
  const auto section = card.find("from_afar");
  if (section == card.end() || (section->is_object() && section->contains("not_measured"))) return {};
  const std::string within = path + ": from_afar";
  SeenFromAfar seen{read_figures(*section, within, "at_100_px"), {}};
  if (section->contains("at_piece_size") && !section->at("at_piece_size").is_null())
    seen.at_piece_size = read_figures(*section, within, "at_piece_size");
  return seen;
}

std::string text(const json& card, const std::string& path, const char* section, const char* key) {
  const json& value = value_at(card, path, section, key);
  if (!value.is_string()) {
    throw InputError(path + ": " + section + "." + key + ": found " + value.dump().substr(0, 60) + ", allowed: a text");
  }
  return value.get<std::string>();
}

StopReason stop_reason(const json& card, const std::string& path) {
  const std::string word = text(card, path, "run", "stopped_by");
  if (const auto reason = stop_reason_of(word)) return *reason;
  std::string allowed;
  for (const StopReason reason : kStopReasons)
    allowed += (allowed.empty() ? "" : ", ") + std::string(stop_word(reason));
  throw InputError(path + ": run.stopped_by: found " + json(word).dump().substr(0, 60) + ", allowed: " + allowed);
}

}  // namespace

bool is_unfinished(const ResultCard& card) { return is_interruption(card.stopped_by); }

ResultCard read_card(const std::string& folder) {
  const std::string path = path_in_result(folder, "card.json");
  const json card = parsed(folder, path);
  const auto measure = [&](const char* key, double most) { return number(card, path, "quality", key, most); };
  ResultCard result;
  result.folder = folder;
  result.quality.coverage = measure("coverage_fraction", kMostCoverage);
  result.quality.overlap = measure("overlap_fraction", kMostLayers);
  result.quality.outside = measure("outside_fraction", kMostLayers);
  result.quality.shared_boundary = measure("shared_boundary_fraction", 1);
  result.quality.pieces = std::size_t(measure("pieces", kMostPiecesTold));
  result.quality.distinct_shapes = std::size_t(measure("distinct_shapes", double(result.quality.pieces)));
  result.quality.largest_gap_px = measure("largest_gap_radius_px", kMostLength_px);
  const auto tells = [&](const char* key) { return card.at("quality").contains(key); };
  result.age = tells("effective_shapes") ? CardAge::variety : tells("size_balance") ? CardAge::picture : CardAge::first;
  if (result.age >= CardAge::picture) read_picture_measures(card, path, result.quality);
  if (result.age >= CardAge::variety) {
    result.quality.effective_shapes =
        number_or_null(card, path, "quality", "effective_shapes", double(result.quality.pieces));
  }
  result.afar = read_afar(card, path);
  result.total_s = number(card, path, "run", "total_s", kMostTime_s);
  result.stopped_by = stop_reason(card, path);
  return result;
}

std::string made_by(const std::string& folder) {
  try {
    const std::string path = path_in_result(folder, "card.json");
    const json card = parsed(folder, path);
    const auto word = [&](const char* key) { return printable_utf8(text(card, path, "provenance", key)); };
    return "tessera " + word("version") + ", commit " + word("commit");
  } catch (const InputError&) {
    return "";
  } catch (const EnvironmentError&) {  // it cannot be read; the caller reports other things
    return "";
  }
}

}  // namespace tessera
