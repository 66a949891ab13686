// Nesting as a whole: independent chains, of which the best is taken.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "products/nesting/layout/nest_problem.h"
#include "products/nesting/layout/nest_scene.h"
#include "products/nesting/layout/posed_shape.h"

namespace tessera {

/// How much is tried, whatever machine it is: that many pairs of pieces held against each other.
struct NestEffort {
  int chains = 2;
  std::uint64_t work_of_piece = 0;  // of each chain, for each piece
};

/// "draft", "good" or "best"; nothing for another word.
const NestEffort* nest_effort(const std::string& word);

/// Told each better layout of all pieces that a chain finds, by the thread that searches; the first one at once, a poor
/// one: columns of boxes.
using NestFound = std::function<void(const NestLayout&)>;

/// Called for every piece that is moved, by the thread that searches, with the part of the chain's budget that is used,
/// 0 to 1. What it throws ends the chain.
using NestChainWatch = std::function<void(double done)>;

/// Most pieces of all items together.
inline constexpr int kMostNestedPieces = 2'000;

/// One chain: the same problem, seed and number give the same layout anywhere. What is too large for the sheet or
/// the strip at all of its angles is left over. Where `watch` ends it, the last that `found` was told is what it has.
NestLayout nest_chain(const NestProblem& problem, const PosedItems& shapes, const NestEffort& effort,
                      std::uint64_t seed, int chain, const NestFound& found = {}, const NestChainWatch& watch = {});

/// Whether `a` is the better one: fewer pieces left over, fewer sheets, shorter, of an earlier chain. A total order of
/// the layouts of different chains: the best of the best of any shares of them is the best of all.
bool is_better(const NestLayout& a, const NestLayout& b);

/// The best of one layout or more.
const NestLayout& best_layout(const std::vector<NestLayout>& layouts);

}  // namespace tessera
