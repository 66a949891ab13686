// The state of the collage's loop between two rounds or trials: what does not follow from job, library and canvas.
// Free field, target curve, poses and covered area are rebuilt from the placements and are not in here.
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

/// What the pool holds of one target sample. Of the candidates everything counts but `ordinal` and `stamp`, which are
/// the pool's own and are given anew.
struct PooledSample {
  SampleId id{};
  bool truncated = false;
  std::vector<Candidate> candidates;  // in the order of the pool's entry
};

/// How often a target sample was matched: its next random dockings go by it, even if it was gone meanwhile.
struct SamplePasses {
  SampleId id{};
  std::uint32_t passes = 0;

  friend bool operator==(const SamplePasses&, const SamplePasses&) = default;
};

/// An attempt at a size factor that left fewer pieces without a place than others.
struct KeptAttempt {
  float factor = 0;  // 0: none is kept
  std::uint64_t missing = 0;
  std::vector<Placement> placements = {};

  friend bool operator==(const KeptAttempt&, const KeptAttempt&) = default;
};

struct CheckpointState {
  std::string name;                   // for messages: the file that it came from
  LoopState loop;                     // where the loop is
  std::uint32_t given = 0;            // so many of the placements, the first ones, stood when the region was begun
  SizeSearchState sizes;              // at which every shape is to find a place
  KeptAttempt best;                   // of the attempts before; while the search goes on
  std::uint64_t begun_with = 0;       // digest of the pieces that the job gives
  int empty_passes = 0;               // how often all samples were matched again since the last piece, while filling
  std::vector<Placement> placements;  // in the order in which they were placed
  std::vector<PooledSample> pool;     // ascending samples, as in the lists below
  std::vector<SampleId> stale;        // target samples to be matched
  std::vector<SamplePasses> passes;
  std::vector<MatchedPad> matched;
  RunStatistics statistics;          // so far, told of the loop's trials and times; stopped_by is empty
  std::uint64_t rebuilt_digest = 0;  // of the free field and the target samples, to see that they came back
};

}  // namespace tessera
