#include "render/ranking.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/stop.h"
#include "files/atomic_file.h"
#include "render/collage_sheet.h"
#include "result/folder/finished_result.h"
#include "result/folder/result_file.h"
#include "text/csv_text.h"
#include "text/json_text.h"
#include "text/number_text.h"

namespace tessera {
namespace {

constexpr char kPicture[] = "ranking.png";

namespace fs = std::filesystem;

using Fraction = std::optional<double>;

Fraction coverage(const ResultCard& card) { return card.quality.coverage; }
Fraction overlap(const ResultCard& card) { return card.quality.overlap; }
Fraction outside(const ResultCard& card) { return card.quality.outside; }
Fraction shared_boundary(const ResultCard& card) { return card.quality.shared_boundary; }

Fraction variety(const ResultCard& card) {
  const Quality& q = card.quality;
  if (card.age < CardAge::variety) return {};
  return q.pieces > 0 ? q.effective_shapes.value_or(0) / double(q.pieces) : 0;
}

Fraction balance(const ResultCard& card) {
  const Quality& q = card.quality;
  if (card.age < CardAge::picture) return {};
  return q.balance ? q.balance->evenness : 0;
}

/// The dwarfs of a card. A collage without pieces must not lead the ranking because of that: it counts as all dwarfs and
/// touching copies.
Fraction dwarfs(const ResultCard& card) {
  const Quality& q = card.quality;
  if (card.age < CardAge::picture) return {};
  return q.balance ? q.balance->dwarfs : q.pieces > 0 ? 0 : 1;
}

Fraction copies_apart(const ResultCard& card) {
  const Quality& q = card.quality;
  if (card.age < CardAge::picture) return {};
  return q.pieces > 0 ? q.copies_apart.value_or(1) : 0;
}

Fraction alone(const ResultCard& card) {
  return card.age < CardAge::picture ? Fraction() : Fraction(card.quality.alone);
}

Fraction colour_from_afar(const ResultCard& card) {
  return card.afar ? Fraction(card.afar->at_100_px.colour_difference / 100) : Fraction();
}

Fraction structure_from_afar(const ResultCard& card) {
  return card.afar ? Fraction(card.afar->at_100_px.structure) : Fraction();
}

std::string allowed_names() {
  std::string names;
  for (const RankingTerm& term : ranking_terms()) names += (names.empty() ? "" : ", ") + std::string(term.name);
  return names;
}

double parsed_weight(const std::string& change, const std::string& text) {
  double weight = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), weight);
  if (end.ec != std::errc() || end.ptr != text.data() + text.size() || !(std::abs(weight) <= 1000)) {
    throw InputError("--weight " + change + ": found \"" + text + "\", allowed: a number from -1000 to 1000");
  }
  return weight;
}

/// The number with as few digits as give the same number back: "0.05", "2".
std::string short_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// A measure that older cards lack: name, value and decimals, in the order of the columns.
struct PictureMeasure {
  const char* name;
  std::optional<double> value;
  int decimals;
};

std::vector<PictureMeasure> picture_measures(const ResultCard& card) {
  const Quality& q = card.quality;
  const auto of_balance = [&](double SizeBalance::*part) {
    return q.balance ? std::optional((*q.balance).*part) : std::nullopt;
  };
  return {{"effective_shapes", q.effective_shapes, 3},
          {"size_balance", of_balance(&SizeBalance::evenness), 6},
          {"dwarfs_fraction", of_balance(&SizeBalance::dwarfs), 6},
          {"nearest_copy_px", q.copies_px, 3},
          {"nearest_copy_fraction", q.copies_apart, 6},
          {"between_pieces_px", q.between_px, 3},
          {"alone_fraction", card.age < CardAge::picture ? std::nullopt : std::optional(q.alone), 6},
          {"from_afar_ciede2000", card.afar ? std::optional(card.afar->at_100_px.colour_difference) : std::nullopt, 3},
          {"from_afar_ssim", card.afar ? std::optional(card.afar->at_100_px.structure) : std::nullopt, 3}};
}

constexpr const char* kFolderToCome = "";

/// Inserts the folders' names, which may have bytes that are not UTF-8; the JSON library cannot write these.
std::string with_folders(std::string json, const std::vector<RankedResult>& results) {
  const std::string key = R"("folder": )", place = key + R"("")";  // within a text quotes have a backslash before them
  std::size_t at = 0;
  for (const RankedResult& result : results) {
    const std::string folder = key + json_path_text(result.card.folder);
    at = json.find(place, at);
    json.replace(at, place.size(), folder);
    at += folder.size();
  }
  return json;
}

nlohmann::ordered_json result_json(const RankedResult& result) {
  const Quality& q = result.card.quality;
  nlohmann::ordered_json json = {{"rank", result.rank},
                                 {"folder", kFolderToCome},
                                 {"score", std::round(1000 * result.score) / 1000},
                                 {"coverage_fraction", q.coverage},
                                 {"overlap_fraction", q.overlap},
                                 {"outside_fraction", q.outside},
                                 {"shared_boundary_fraction", q.shared_boundary},
                                 {"pieces", q.pieces},
                                 {"distinct_shapes", q.distinct_shapes},
                                 {"largest_gap_radius_px", q.largest_gap_px}};
  for (const PictureMeasure& measure : picture_measures(result.card)) {
    json[measure.name] = measure.value ? nlohmann::ordered_json(*measure.value) : nlohmann::ordered_json();
  }
  json["total_s"] = result.card.total_s;
  json["stopped_by"] = stop_word(result.card.stopped_by);
  return json;
}

/// The entries of a folder, by name.
std::vector<std::string> entries_of(const std::string& folder) {
  std::error_code error;
  if (fs::status(folder, error).type() == fs::file_type::not_found) throw InputError(folder + ": no such folder");
  if (!error && !fs::is_directory(folder, error)) throw InputError(folder + ": not a folder");
  std::vector<std::string> paths;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    paths.push_back(at->path().string());
  }
  if (error) throw EnvironmentError(folder + ": cannot be read: " + error.message());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Takes the result in a folder. Without a manifest the folder is not ours, or was left by a run that crashed. A folder
/// that cannot be read does not affect the others.
void take(const std::string& folder, FoundResults& found) {
  try {
    if (!is_in_result(folder, kManifestName)) return;
    const std::size_t pieces = read_result(folder).manifest.shapes.size();
    const ResultCard card = read_card(folder);
    if (card.quality.pieces != pieces) {
      throw InputError(path_in_result(folder, "card.json") + ": quality.pieces: found " +
                       std::to_string(card.quality.pieces) + ", allowed: " + std::to_string(pieces) +
                       ", as many as pieces.geojson has");
    }
    found.cards.push_back(card);
  } catch (const InputError& error) {
    found.damages.push_back(error.what());
  } catch (const EnvironmentError& error) {
    found.damages.push_back(error.what());
  }
}

}  // namespace

// Coverage leads. A hundredth of overlap is visible where it lies, so it costs twice as much as a hundredth of holes; so
// does paint outside the canvas. Between seeds of one job coverage differs by 0.3 points, shared boundary and variety by
// about 3: with a weight of a tenth they decide between collages of nearly equal coverage. Sizes and copies are a matter of
// taste: their weight is 0 unless the user sets it.
const std::array<RankingTerm, kRankingTerms>& ranking_terms() {
  static constexpr std::array<RankingTerm, kRankingTerms> terms = {{
      {"coverage", 1, coverage},
      {"overlap", -2, overlap},
      {"outside", -2, outside},
      {"shared_boundary", 0.1, shared_boundary},
      {"variety", 0.1, variety},
      {"balance", 0, balance},
      {"dwarfs", 0, dwarfs},
      {"copies_apart", 0, copies_apart},
      {"alone", 0, alone},
      {"colour_from_afar", 0, colour_from_afar, 1},
      {"structure_from_afar", 0, structure_from_afar},
  }};
  return terms;
}

RankingWeights ranking_weights(const std::vector<std::string>& changes) {
  RankingWeights weights;
  for (std::size_t i = 0; i < kRankingTerms; ++i) weights[i] = ranking_terms()[i].default_weight;
  for (const std::string& change : changes) {
    const std::string name = change.substr(0, change.find('='));
    const auto& terms = ranking_terms();
    const auto term = std::find_if(terms.begin(), terms.end(), [&](const RankingTerm& t) { return t.name == name; });
    if (term == terms.end() || name.size() == change.size()) {
      throw InputError("--weight " + change + ": allowed: NAME=NUMBER with a name of " + allowed_names());
    }
    weights[std::size_t(term - terms.begin())] = parsed_weight(change, change.substr(name.size() + 1));
  }
  return weights;
}

std::vector<RankedResult> ranked(std::vector<ResultCard> cards, const RankingWeights& weights) {
  std::vector<RankedResult> results;
  for (ResultCard& card : cards) {
    double score = 0;
    for (std::size_t i = 0; i < kRankingTerms; ++i) {
      const RankingTerm& term = ranking_terms()[i];
      score += 100 * weights[i] * term.value(card).value_or(term.lacking);
    }
    results.push_back({std::move(card), score, 0});
  }
  std::sort(results.begin(), results.end(), [](const RankedResult& a, const RankedResult& b) {
    return a.score != b.score ? a.score > b.score : a.card.folder < b.card.folder;
  });
  for (std::size_t i = 0; i < results.size(); ++i) {
    const bool tied = i > 0 && results[i].score == results[i - 1].score;
    results[i].rank = tied ? results[i - 1].rank : i + 1;
  }
  return results;
}

std::vector<std::string> lacking_measures(const std::vector<RankedResult>& results, const RankingWeights& weights) {
  std::vector<std::string> lines;
  for (const RankedResult& result : results) {
    std::string names;
    for (std::size_t i = 0; i < kRankingTerms; ++i) {
      const RankingTerm& term = ranking_terms()[i];
      if (weights[i] == 0 || term.value(result.card)) continue;
      names += (names.empty() ? "" : ", ") + std::string(term.name) + " (counts as " + short_text(100 * term.lacking) +
               " %)";
    }
    if (names.empty()) continue;
    lines.push_back(path_in_result(result.card.folder, "card.json") + ": lacks " + names);
  }
  return lines;
}

std::string score_formula(const RankingWeights& weights) {
  std::string text;
  for (std::size_t i = 0; i < kRankingTerms; ++i) {
    if (weights[i] == 0) continue;
    const char* sign = weights[i] < 0 ? "- " : "+ ";
    if (!text.empty()) text += " ";
    if (!text.empty() || weights[i] < 0) text += sign;
    if (std::abs(weights[i]) != 1) text += short_text(std::abs(weights[i])) + " ";
    text += ranking_terms()[i].name;
  }
  return "score = " + (text.empty() ? "0" : text) + ", in percent";
}

std::string ranking_csv(const std::vector<RankedResult>& results) {
  std::string text =
      "rank,folder,score,coverage_fraction,overlap_fraction,outside_fraction,shared_boundary_fraction,pieces,"
      "distinct_shapes,largest_gap_radius_px";
  for (const PictureMeasure& measure : picture_measures({})) text += std::string(",") + measure.name;
  text += ",total_s,stopped_by\n";
  for (const RankedResult& result : results) {
    const ResultCard& card = result.card;
    const Quality& q = card.quality;
    text += std::to_string(result.rank) + "," + csv_text_cell(card.folder) + "," + fixed(result.score, 3) + "," +
            fixed(q.coverage, 6) + "," + fixed(q.overlap, 6) + "," + fixed(q.outside, 6) + "," +
            fixed(q.shared_boundary, 6) + "," + std::to_string(q.pieces) + "," + std::to_string(q.distinct_shapes) +
            "," + fixed(q.largest_gap_px, 3);
    for (const PictureMeasure& measure : picture_measures(card)) {
      text += "," + (measure.value ? fixed(*measure.value, measure.decimals) : std::string());
    }
    text += "," + fixed(card.total_s, 3) + "," + csv_text_cell(std::string(stop_word(card.stopped_by))) + "\n";
  }
  return text;
}

std::string ranking_json(const std::vector<RankedResult>& results, const RankingWeights& weights) {
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < kRankingTerms; ++i) json["weights"][ranking_terms()[i].name] = weights[i];
  json["ranking"] = nlohmann::ordered_json::array();
  for (const RankedResult& result : results) json["ranking"].push_back(result_json(result));
  return with_folders(json.dump(2, ' ', true, nlohmann::json::error_handler_t::replace) + "\n", results);
}

RankingFiles ranking_files(const std::vector<RankedResult>& results, const RankingWeights& weights) {
  return {ranking_csv(results), ranking_json(results, weights), collage_sheet(results, kPicture)};
}

void write_ranking(const std::string& dir, const RankingFiles& files) {
  write_file_atomically((fs::path(dir) / "ranking.csv").string(), files.csv);
  write_file_atomically((fs::path(dir) / "ranking.json").string(), files.json);
  write_file_atomically((fs::path(dir) / kPicture).string(), files.png);
}

FoundResults find_results(const std::string& argument) {
  FoundResults found;
  take(argument, found);
  if (!found.cards.empty() || !found.damages.empty()) return found;
  for (const std::string& path : entries_of(argument)) take(path, found);
  if (!found.cards.empty() || !found.damages.empty()) return found;
  throw InputError(argument + ": no result of tessera collage, neither in this folder nor in those within it");
}

}  // namespace tessera
