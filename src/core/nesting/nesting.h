// Nesting as a whole: independent chains, of which the best is taken.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/nesting/nest_problem.h"
#include "core/nesting/nest_scene.h"
#include "core/nesting/posed_shape.h"

namespace tessera {

/// How much is tried, whatever machine it is: that many pairs of pieces held against each other.
struct NestEffort {
  int chains = 2;
  std::uint64_t work_of_piece = 0;  // of each chain, for each piece
};

/// "draft", "good" or "best"; nothing for another word.
const NestEffort* nest_effort(const std::string& word);

/// Told now and then: the number of sheets that are full by now, and how long the strip is by now.
using NestProgress = std::function<void(int sheets, double length)>;

/// Most pieces of all items together.
inline constexpr int kMostNestedPieces = 2'000;

/// One chain: the same problem, seed and number give the same layout anywhere. What is too large for the sheet or
/// the strip at all of its angles is left over. `watch` ends it by throwing.
NestLayout nest_chain(const NestProblem& problem, const PosedItems& shapes, const NestEffort& effort,
                      std::uint64_t seed, int chain, const NestProgress& progress = {}, const NestWatch& watch = {});

/// Whether `a` is the better one: fewer pieces left over, fewer sheets, shorter, of an earlier chain. A total order of
/// the layouts of different chains: the best of the best of any shares of them is the best of all.
bool is_better(const NestLayout& a, const NestLayout& b);

/// The best of one layout or more.
const NestLayout& best_layout(const std::vector<NestLayout>& layouts);

}  // namespace tessera
