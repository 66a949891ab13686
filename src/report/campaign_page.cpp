#include "report/campaign_page.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/base/version.h"
#include "report/picture_block.h"
#include "result/folder/folder_name.h"
#include "text/number_text.h"

namespace tessera {
namespace {

using Json = nlohmann::ordered_json;

/// Measure of web/src/data.ts, and its value on a card.
struct PageMeasure {
  const char* key;
  const char* label;
  const char* unit;
  int decimals;
  const char* better;  // "more", "less"; null: a matter of taste
  std::optional<double> (*value)(const RankedResult&);
};

std::optional<double> percent_of(std::optional<double> fraction) {
  return fraction ? std::optional(100 * *fraction) : std::nullopt;
}

/// The table of measures; the names of tessera rank.
const std::array<PageMeasure, 14>& page_measures() {
  using R = const RankedResult&;
  static constexpr std::array<PageMeasure, 14> measures = {{
      {"score", "Score", "", 2, "more", [](R r) { return std::optional(r.score); }},
      {"coverage", "Coverage", "%", 2, "more", [](R r) { return percent_of(r.card.quality.coverage); }},
      {"overlap", "Overlap", "%", 3, "less", [](R r) { return percent_of(r.card.quality.overlap); }},
      {"outside", "Outside", "%", 3, "less", [](R r) { return percent_of(r.card.quality.outside); }},
      {"shared_boundary", "Shared boundary", "%", 1, "more",
       [](R r) { return percent_of(r.card.quality.shared_boundary); }},
      {"largest_gap", "Largest gap", "px", 1, "less", [](R r) { return std::optional(r.card.quality.largest_gap_px); }},
      {"pieces", "Pieces", "", 0, nullptr, [](R r) { return std::optional(double(r.card.quality.pieces)); }},
      {"shapes", "Drawings", "", 0, "more", [](R r) { return std::optional(double(r.card.quality.distinct_shapes)); }},
      {"effective_shapes", "Drawings, as seen", "", 1, "more", [](R r) { return r.card.quality.effective_shapes; }},
      {"balance", "Balance of sizes", "", 2, nullptr,
       [](R r) { return r.card.quality.balance ? std::optional(r.card.quality.balance->evenness) : std::nullopt; }},
      {"copies", "Nearest copy", "px", 0, "more", [](R r) { return r.card.quality.copies_px; }},
      {"colour_from_afar", "Colour from afar", "", 2, "less",
       [](R r) { return r.card.afar ? std::optional(r.card.afar->at_100_px.colour_difference) : std::nullopt; }},
      {"structure_from_afar", "Structure from afar", "", 3, "more",
       [](R r) { return r.card.afar ? std::optional(r.card.afar->at_100_px.structure) : std::nullopt; }},
      {"time", "Time", "s", 1, "less", [](R r) { return std::optional(r.card.total_s); }},
  }};
  return measures;
}

/// The measures that some result has.
std::vector<PageMeasure> known_measures(const std::vector<RankedResult>& results) {
  std::vector<PageMeasure> known;
  for (const PageMeasure& measure : page_measures()) {
    if (std::any_of(results.begin(), results.end(),
                    [&](const RankedResult& r) { return measure.value(r).has_value(); }))
      known.push_back(measure);
  }
  return known;
}

Json measures_data(const std::vector<PageMeasure>& measures) {
  Json all = Json::array();
  for (const PageMeasure& measure : measures) {
    all.push_back({{"key", measure.key},
                   {"label", measure.label},
                   {"unit", measure.unit},
                   {"decimals", measure.decimals},
                   {"better", measure.better ? Json(measure.better) : Json()}});
  }
  return all;
}

Json values_of(const RankedResult& result, const std::vector<PageMeasure>& measures) {
  Json values = Json::array();
  for (const PageMeasure& measure : measures) {
    const std::optional<double> value = measure.value(result);
    values.push_back(value ? Json(rounded(*value, measure.decimals)) : Json());
  }
  return values;
}

}  // namespace

Page campaign_page(const std::string& title, const std::vector<RankedResult>& results, const RankingWeights& weights,
                   std::size_t picture_bytes) {
  Page page{.title = title, .json = {}, .blocks = {}, .warnings = {}};
  const std::vector<PageMeasure> measures = known_measures(results);
  Json rows = Json::array();
  for (std::size_t k = 0; k < results.size(); ++k) {
    const RankedResult& result = results[k];
    const std::string& folder = result.card.folder;
    rows.push_back({{"name", folder_name(folder)},
                    {"folder", folder},
                    {"rank", result.rank},
                    {"finished", !is_unfinished(result.card)},
                    {"values", values_of(result, measures)},
                    {"picture", picture_data(folder, read_result(folder), k, picture_bytes / results.size(), page)}});
  }
  Json data;
  data["format"] = kPageFormat;
  data["kind"] = "campaign";
  data["name"] = title;
  data["program"] = std::string("tessera ") + program_version() + ", commit " + program_commit();
  data["formula"] = score_formula(weights);
  data["measures"] = measures_data(measures);
  data["results"] = rows;
  page.json = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  return page;
}

}  // namespace tessera
