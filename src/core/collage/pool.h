// The pool of candidates: for each target sample the best few of the whole library. It lives on the master.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/collage/candidate.h"
#include "core/field/sample_id.h"
#include "core/geometry/grid.h"
#include "core/geometry/tile_index.h"

namespace tessera {

class Pool {
 public:
  struct Entry {
    std::vector<Candidate> candidates;  // best first when they were put
    bool truncated = false;             // there was more than was kept
    Window reach;                       // of the windows of all that were put
  };

  /// A candidate by name, and what it is worth.
  struct Ranked {
    float value;
    SampleId sample;
    std::uint32_t ordinal;
    std::uint64_t stamp;

    /// A total order: the same candidates in the same order on any machine.
    bool operator<(const Ranked& o) const {
      if (value != o.value) return value > o.value;
      return sample != o.sample ? sample < o.sample : ordinal < o.ordinal;
    }
  };

  /// Keeps the best kPoolPerSample; ties go by shape, then source.
  void put(SampleId sample, std::vector<Candidate> candidates, bool truncated);
  /// Puts back what entries() said of a target sample: the same candidates in the same order, not sorted again.
  void put_back(SampleId sample, std::vector<Candidate> candidates, bool truncated);
  void erase(SampleId sample);
  void erase(const Ranked& ranked);

  Candidate& at(const Ranked& ranked) { return *find(ranked); }
  const std::unordered_map<SampleId, Entry>& entries() const { return entries_; }
  /// Target samples that may have candidates whose windows overlap `changed`.
  std::vector<SampleId> reached_by(const Window& changed) const;

  /// Drops the candidates of a target sample for which keep(candidate) is false; it may change scores. True where some
  /// were dropped.
  template <class Keep>
  bool review(SampleId sample, Keep keep);

  /// To be called after the candidate's score has changed.
  void rank_again(Ranked& ranked);

  /// Calls visit(ranked, candidate) from the largest worth(candidate) down while it returns true. A candidate's worth
  /// is at most its score, and may only fall while its score stays: the order is mended where it is looked at.
  template <class Worth, class Visit>
  void best_first(Worth worth, Visit visit);

 private:
  static bool ranks_after(const Ranked& a, const Ranked& b) { return b < a; }  // the order of the queue's heap

  Candidate* find(const Ranked& ranked);
  void rank(SampleId sample, Candidate& candidate);
  void push(const Ranked& ranked);
  Ranked pop();
  void sweep();

  std::unordered_map<SampleId, Entry> entries_;
  TileIndex index_;  // samples, by the upper left corner of their entry's reach
  int widest_ = 0;   // of all reaches so far, nodes
  int highest_ = 0;
  std::vector<Ranked> queue_;  // a heap of upper bounds of worth; those with an outdated stamp count no more
  std::size_t swept_ = 0;      // size of the queue when those were last taken out
  std::uint64_t last_stamp_ = 0;
};

template <class Keep>
bool Pool::review(SampleId sample, Keep keep) {
  std::vector<Candidate>& candidates = entries_.at(sample).candidates;
  std::size_t kept = 0;
  for (Candidate& c : candidates) {
    const float before = c.score;
    if (!keep(c)) continue;
    if (c.score != before) rank(sample, c);
    candidates[kept++] = c;
  }
  const bool dropped = kept < candidates.size();
  candidates.resize(kept);
  return dropped;
}

template <class Worth, class Visit>
void Pool::best_first(Worth worth, Visit visit) {
  sweep();
  std::vector<Ranked> visited;
  for (bool more = true; more && !queue_.empty();) {
    Ranked first = pop();
    const Candidate* candidate = find(first);
    if (candidate == nullptr) continue;
    const float value = worth(*candidate);
    if (value < first.value) {
      first.value = value;
      push(first);
      continue;
    }
    visited.push_back(first);
    more = visit(first, *candidate);
  }
  for (const Ranked& ranked : visited) push(ranked);
}

/// The total order among the candidates of one target sample: by score, shape, source.
bool ranks_before(const Candidate& a, const Candidate& b);

}  // namespace tessera
