// What the ranks of a nesting tell each other (comm/archive.h).
#pragma once

#include <cstdint>

#include "comm/archive.h"
#include "products/nesting/layout/nesting.h"

namespace tessera {

/// Rank 0 to all others: what each has to do.
struct NestSearch {
  NestProblem problem;
  NestEffort effort;
  std::uint64_t seed = 0;
};

/// A worker to rank 0: the best layout of its chains by now, and whether they have ended.
struct NestReport {
  NestLayout layout;
  bool is_last = false;
};

}  // namespace tessera

namespace tessera::comm {

template <class T>
requires kIsOneOf<T, NestPoint, NestedPiece>
inline constexpr bool kSentAsItLies<T> = true;

template <class Archive>
void serialize(Archive& archive, NestItem& item) {
  auto& [outline, angles_deg, demand] = item;
  archive(outline, angles_deg, demand);
}

template <class Archive>
void serialize(Archive& archive, NestProblem& problem) {
  auto& [items, height, length, spacing] = problem;
  archive(items, height, length, spacing);
}

template <class Archive>
void serialize(Archive& archive, NestEffort& effort) {
  auto& [chains, work_of_piece] = effort;
  archive(chains, work_of_piece);
}

template <class Archive>
void serialize(Archive& archive, NestSearch& search) {
  auto& [problem, effort, seed] = search;
  archive(problem, effort, seed);
}

template <class Archive>
void serialize(Archive& archive, NestLayout& layout) {
  auto& [pieces, left_over, sheets, used_length, chain] = layout;
  archive(pieces, left_over, sheets, used_length, chain);
}

template <class Archive>
void serialize(Archive& archive, NestReport& report) {
  auto& [layout, is_last] = report;
  archive(layout, is_last);
}

}  // namespace tessera::comm
