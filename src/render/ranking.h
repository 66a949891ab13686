// Several collages in order of quality: ranking.csv, ranking.json, and a contact sheet of their pictures.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "result/card_input.h"

namespace tessera {

/// One measure of the card, a fraction from 0 to 1, and the points of score that a hundredth of it brings by default.
struct RankingTerm {
  const char* name;
  double default_weight;
  std::optional<double> (*value)(const ResultCard&);  // none: the card lacks the measure
  double lacking = 0;                                 // what a card that lacks it counts
};

inline constexpr std::size_t kRankingTerms = 11;

/// coverage, overlap, outside, shared_boundary, variety (effective_shapes by pieces), balance (of sizes) and dwarfs,
/// both 0 where all sizes are alike, copies_apart (by the canvas' diagonal; 1 where most shapes stand once), alone.
/// Without pieces dwarfs is 1, and copies_apart 0. Then, at 100 px, colour_from_afar, a hundredth of CIEDE2000, and
/// structure_from_afar, SSIM from -1 on; a card without them counts as black for white, without any structure.
const std::array<RankingTerm, kRankingTerms>& ranking_terms();

/// The weights stand in the order of ranking_terms().
using RankingWeights = std::array<double, kRankingTerms>;

/// The defaults changed by texts "NAME=WEIGHT". Throws InputError that says what was found and what is allowed.
RankingWeights ranking_weights(const std::vector<std::string>& changes);

struct RankedResult {
  ResultCard card;
  double score = 0;      // points
  std::size_t rank = 0;  // from 1; equal scores have the same, and the one after two firsts is 3
};

/// Best first; equal ones share a rank and stand in the order of their folders' names. The score is the sum over the
/// terms of weight · value in percent.
std::vector<RankedResult> ranked(std::vector<ResultCard> cards, const RankingWeights& weights);

/// Of cards that lack a measure which counts, a line for each: "a/card.json: lacks balance (counts as 0 %), ...".
std::vector<std::string> lacking_measures(const std::vector<RankedResult>& results, const RankingWeights& weights);

/// "score = coverage - 2 overlap ...": the weights that are not 0, in words.
std::string score_formula(const RankingWeights& weights);

/// A header, and a line for each result.
std::string ranking_csv(const std::vector<RankedResult>& results);
std::string ranking_json(const std::vector<RankedResult>& results, const RankingWeights& weights);

/// The files of a ranking: ranking.csv, ranking.json and ranking.png.
struct RankingFiles {
  std::string csv;
  std::string json;
  std::vector<std::uint8_t> png;  // collage_sheet.h
};

/// Throws EnvironmentError.
RankingFiles ranking_files(const std::vector<RankedResult>& results, const RankingWeights& weights);

/// Writes them into `dir`, which is there. Throws EnvironmentError.
void write_ranking(const std::string& dir, const RankingFiles& files);

struct FoundResults {
  std::vector<ResultCard> cards;     // by folder
  std::vector<std::string> damages;  // why others are left out: not whole (finished_result.h), or without a card
};

/// The results that an argument means: the folder itself where it holds one, else those of its folders. Throws
/// InputError where there is none at all, EnvironmentError where the folder cannot be read.
FoundResults find_results(const std::string& argument);

}  // namespace tessera
