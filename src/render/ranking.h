// Ranks several collages by quality, and writes ranking.csv, ranking.json and a contact sheet of their pictures.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "result/card_input.h"

namespace tessera {

/// One measure of the card, a fraction from 0 to 1, and its default weight: the points of score for one hundredth.
struct RankingTerm {
  const char* name;
  double default_weight;
  std::optional<double> (*value)(const ResultCard&);  // empty: the card lacks the measure
  double lacking = 0;                                 // the value of a card that lacks it
};

inline constexpr std::size_t kRankingTerms = 11;

/// The measures are: coverage, overlap, outside, shared_boundary, variety (effective_shapes divided by pieces), balance of
/// sizes and dwarfs (both 0 where all sizes are alike), copies_apart (divided by the canvas' diagonal; 1 where most shapes
/// stand once), alone. Without pieces dwarfs is 1 and copies_apart 0. Two more are measured at 100 px: colour_from_afar, a
/// hundredth of CIEDE2000, and structure_from_afar, SSIM from -1 on. A card without these two counts like black for white
/// without any structure.
const std::array<RankingTerm, kRankingTerms>& ranking_terms();

/// The weights in the order of ranking_terms().
using RankingWeights = std::array<double, kRankingTerms>;

/// The default weights, changed by texts "NAME=WEIGHT". Throws InputError that says what was found and what is allowed.
RankingWeights ranking_weights(const std::vector<std::string>& changes);

struct RankedResult {
  ResultCard card;
  double score = 0;      // points
  std::size_t rank = 0;  // from 1; equal scores share a rank, and after two first ones comes 3
};

/// The results, best first. Equal ones share a rank and are sorted by their folders' names. The score is the sum of weight
/// times value in percent over the terms.
std::vector<RankedResult> ranked(std::vector<ResultCard> cards, const RankingWeights& weights);

/// The cards that lack a measure with a weight, a line each: "a/card.json: lacks balance (counts as 0 %), ...".
std::vector<std::string> lacking_measures(const std::vector<RankedResult>& results, const RankingWeights& weights);

/// The weights that are not 0, as a formula: "score = coverage - 2 overlap ...".
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

/// Makes the files' content. Throws EnvironmentError.
RankingFiles ranking_files(const std::vector<RankedResult>& results, const RankingWeights& weights);

/// Writes the files into the existing folder `dir`. Throws EnvironmentError.
void write_ranking(const std::string& dir, const RankingFiles& files);

struct FoundResults {
  std::vector<ResultCard> cards;     // by folder
  std::vector<std::string> damages;  // why others are left out: not whole (finished_result.h), or without a card
};

/// The results that an argument stands for: the folder itself if it holds a result, otherwise the results in its
/// subfolders. Throws InputError where there is none, EnvironmentError where the folder cannot be read.
FoundResults find_results(const std::string& argument);

}  // namespace tessera
