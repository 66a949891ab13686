// The messages between the ranks of a nesting (comm/archive.h).
#pragma once

#include <cstdint>

#include "comm/archive.h"
#include "products/nesting/layout/nesting.h"

namespace tessera {

/// Message of rank 0 to all others: the search that they share.
struct NestSearch {
  NestProblem problem;
  NestEffort effort;
  std::uint64_t seed = 0;
};

/// Message of a worker to rank 0: the best layout of its chains so far, and whether all chains have ended.
struct NestReport {
  NestLayout layout;
  bool is_last = false;
};

}  // namespace tessera

namespace tessera::comm {

template <class T>
requires kIsOneOf<T, NestPoint, NestedPiece>
inline constexpr bool kSentAsBytes<T> = true;

template <class T>
requires kIsOneOf<T, NestItem, NestProblem, NestEffort, NestSearch, NestLayout, NestReport>
inline constexpr bool kSentByMembers<T> = true;

}  // namespace tessera::comm

namespace boost::serialization {

template <class Archive>
void serialize(Archive& archive, tessera::NestItem& item, unsigned) {
  auto& [outline, angles_deg, demand] = item;
  tessera::comm::send_members(archive, outline, angles_deg, demand);
}

template <class Archive>
void serialize(Archive& archive, tessera::NestProblem& problem, unsigned) {
  auto& [items, height, length, spacing] = problem;
  tessera::comm::send_members(archive, items, height, length, spacing);
}

template <class Archive>
void serialize(Archive& archive, tessera::NestEffort& effort, unsigned) {
  auto& [chains, work_of_piece] = effort;
  tessera::comm::send_members(archive, chains, work_of_piece);
}

template <class Archive>
void serialize(Archive& archive, tessera::NestSearch& search, unsigned) {
  auto& [problem, effort, seed] = search;
  tessera::comm::send_members(archive, problem, effort, seed);
}

template <class Archive>
void serialize(Archive& archive, tessera::NestLayout& layout, unsigned) {
  auto& [pieces, left_over, sheets, used_length, chain] = layout;
  tessera::comm::send_members(archive, pieces, left_over, sheets, used_length, chain);
}

template <class Archive>
void serialize(Archive& archive, tessera::NestReport& report, unsigned) {
  auto& [layout, is_last] = report;
  tessera::comm::send_members(archive, layout, is_last);
}

}  // namespace boost::serialization
