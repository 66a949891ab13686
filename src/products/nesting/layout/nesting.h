// Nesting as a whole: runs independent chains and takes the best.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "products/nesting/layout/nest_problem.h"
#include "products/nesting/layout/nest_scene.h"
#include "products/nesting/layout/posed_shape.h"

namespace tessera {

/// The effort, on any machine: the number of pairs of pieces that are compared.
struct NestEffort {
  int chains = 2;
  std::uint64_t work_of_piece = 0;  // of each chain, for each piece
};

/// The effort of "draft", "good" or "best"; null for another word.
const NestEffort* nest_effort(const std::string& word);

/// Receives each better layout of all pieces that a chain finds, in the thread that searches. The first one comes at once
/// and is poor: columns of boxes.
using NestFound = std::function<void(const NestLayout&)>;

/// Called for every piece that is moved, by the thread that searches, with the part (0 to 1) of the chain's budget that is
/// used. What it throws ends the chain.
using NestChainWatch = std::function<void(double done)>;

/// The most pieces of all items together.
inline constexpr int kMostNestedPieces = 2'000;

/// Runs one chain. The same problem, seed and number give the same layout on any machine. Pieces that are too large for the
/// sheet or strip at all of their angles are left over. Where `watch` ends the chain, its result is the last layout that
/// `found` received.
NestLayout nest_chain(const NestProblem& problem, const PosedItems& shapes, const NestEffort& effort,
                      std::uint64_t seed, int chain, const NestFound& found = {}, const NestChainWatch& watch = {});

/// Whether `a` is better: fewer pieces left over, fewer sheets, shorter, or found by an earlier chain. That is a total
/// order of the layouts of different chains, so the best of the best of any groups is the best of all.
bool is_better(const NestLayout& a, const NestLayout& b);

/// The best of at least one layout.
const NestLayout& best_layout(const std::vector<NestLayout>& layouts);

}  // namespace tessera
