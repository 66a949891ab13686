// The state of the collage's loop between two pieces or trials, as far as it does not follow from job, library and
// canvas. Free field, target curve, poses and covered area are rebuilt from the placements and are not part of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/run_statistics.h"
#include "core/collage/loop_state.h"
#include "core/collage/placement.h"
#include "core/collage/pool.h"
#include "core/field/target_sample.h"
#include "core/matching/size_search.h"

namespace tessera {

/// The pool's content for one target sample. `ordinal` and `stamp` of the candidates do not count: the pool assigns
/// them anew.
struct PooledSample {
  SampleId id{};
  bool truncated = false;
  std::vector<Candidate> candidates;  // in the order of the pool's entry
};

/// How often a target sample was matched, on which its next random dockings depend, and how often it was searched again
/// since it was renewed.
struct SampleMatches {
  SampleId id{};
  std::uint32_t passes = 0;
  std::uint32_t searches = 0;

  friend bool operator==(const SampleMatches&, const SampleMatches&) = default;
};

/// The attempt at a size factor that left the fewest pieces without a place so far; among equals the largest factor.
struct KeptAttempt {
  float factor = 0;  // 0: no attempt is kept
  std::uint64_t missing = 0;
  std::vector<Placement> placements = {};

  friend bool operator==(const KeptAttempt&, const KeptAttempt&) = default;
};

struct CheckpointState {
  std::string name;                   // for messages: the file of the checkpoint
  LoopState loop;                     // phase and counters of the loop
  std::uint32_t given = 0;            // number of placements, the first ones, that stood when the region was begun
  SizeSearchState sizes;              // search for the size at which every shape finds a place
  KeptAttempt best;                   // of the earlier attempts; while the search goes on
  std::uint64_t begun_with = 0;       // digest of the pieces that the job gives
  int search = 0;                     // while filling: number of the search of the stale samples; 0: none goes on
  std::vector<Placement> placements;  // in the order in which they were placed
  std::uint32_t batch_pieces = 0;     // the last placements, which belong to the open batch and not yet to the curve
  float batch_worth = 0;              // of the first of them
  /// The cells of the field where no other piece may join the batch are 1, row by row. Empty where no batch is open.
  std::vector<std::uint8_t> batch_taken = {};
  std::vector<PooledSample> pool;  // samples ascending, as in the lists below
  std::vector<SampleId> stale;     // target samples to be matched
  std::vector<SampleMatches> matches;
  std::uint32_t searched = 0;  // searches of all samples of the region; samples that were renewed since had fewer
  std::vector<MatchedPad> matched;
  RunStatistics statistics;          // up to now, with the loop's trials and times; stopped_by is empty
  std::uint64_t rebuilt_digest = 0;  // digest of free field and target samples: shows that they were rebuilt equally
};

}  // namespace tessera
