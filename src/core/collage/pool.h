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
    bool truncated = false;             // there were more candidates than were kept
    Window reach;                       // union of the windows of all candidates that were put
  };

  /// Names a candidate by sample and ordinal, with its value.
  struct Ranked {
    float value;
    SampleId sample;
    std::uint32_t ordinal;
    std::uint64_t stamp;

    /// A total order: the same candidates come in the same order on any machine.
    bool operator<(const Ranked& o) const {
      if (value != o.value) return value > o.value;
      return sample != o.sample ? sample < o.sample : ordinal < o.ordinal;
    }
  };

  /// Keeps the best kPoolPerSample; ties go by shape, then source.
  void put(SampleId sample, std::vector<Candidate> candidates, bool truncated);
  /// Restores the candidates of a target sample from entries(): in the same order, not sorted again.
  void put_back(SampleId sample, std::vector<Candidate> candidates, bool truncated);
  void erase(SampleId sample);
  void erase(const Ranked& ranked);

  Candidate& at(const Ranked& ranked) { return *find(ranked); }
  const std::unordered_map<SampleId, Entry>& entries() const { return entries_; }
  /// Target samples that may have candidates whose windows overlap `changed`.
  std::vector<SampleId> reached_by(const Window& changed) const;

  /// Drops the candidates of a target sample for which keep(candidate) is false; `keep` may change scores. True if some
  /// were dropped.
  template <class Keep>
  bool review(SampleId sample, Keep keep);

  /// Must be called after the candidate's score has changed.
  void rank_again(Ranked& ranked);

  /// How best_first() goes on after a candidate. The function that it calls for each candidate returns this.
  enum class Visit {
    next,       // to the next candidate
    set_aside,  // to the next one, and this one does not come again before bring_back()
    put_off,    // the same, but better_put_off() visits it once more
    last,       // no further
  };
  /// Calls visit(ranked, candidate) in descending order of worth(candidate). A candidate's worth is at most its score and
  /// may only fall while its score stays. The queue corrects its order lazily, when it reaches a candidate.
  template <class Worth, class Visitor>
  void best_first(Worth worth, Visitor visit);
  /// Sets aside the candidates that were put off and come before `than`. Calls visit(candidate) for each, in descending
  /// order. best_first() may call it from its visitor.
  template <class Worth, class Visitor>
  void better_put_off(const Ranked& than, Worth worth, Visitor visit);
  /// best_first() does not visit this candidate again before bring_back().
  void set_aside(Ranked& ranked);
  /// Makes best_first() visit the candidates that were set aside again.
  void bring_back();

 private:
  static bool ranks_after(const Ranked& a, const Ranked& b) { return b < a; }  // order of the queue's heap

  Candidate* find(const Ranked& ranked);
  void rank(SampleId sample, Candidate& candidate);
  static void push(std::vector<Ranked>& heap, const Ranked& ranked);
  static Ranked pop(std::vector<Ranked>& heap);
  template <class Worth>
  const Candidate* take_best(std::vector<Ranked>& heap, Worth worth, Ranked& best);
  void sweep();

  std::unordered_map<SampleId, Entry> entries_;
  TileIndex index_;  // samples, by the upper left corner of their entry's reach
  int widest_ = 0;   // largest width of all reaches up to now, nodes
  int highest_ = 0;
  std::vector<Ranked> queue_;  // heap of upper bounds of worth; entries with an outdated stamp are ignored
  std::vector<Ranked> aside_;
  std::vector<Ranked> put_off_;  // a heap like queue_
  std::size_t swept_ = 0;        // size of the queue when outdated entries were last removed
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

/// Takes the best candidate from a heap of upper bounds, whose order it corrects. Null where none is left.
template <class Worth>
const Candidate* Pool::take_best(std::vector<Ranked>& heap, Worth worth, Ranked& best) {
  while (!heap.empty()) {
    best = pop(heap);
    const Candidate* const candidate = find(best);
    if (candidate == nullptr) continue;
    const float value = worth(*candidate);
    if (!(value < best.value)) return candidate;
    best.value = value;
    push(heap, best);
  }
  return nullptr;
}

template <class Worth, class Visitor>
void Pool::best_first(Worth worth, Visitor visit) {
  sweep();
  std::vector<Ranked> visited;
  Ranked best;
  for (Visit then = Visit::next; then != Visit::last;) {
    const Candidate* const candidate = take_best(queue_, worth, best);
    if (candidate == nullptr) break;
    then = visit(best, *candidate);
    if (then == Visit::set_aside) {
      aside_.push_back(best);
    } else if (then == Visit::put_off) {
      push(put_off_, best);
    } else {
      visited.push_back(best);
    }
  }
  for (const Ranked& ranked : visited) push(queue_, ranked);
}

template <class Worth, class Visitor>
void Pool::better_put_off(const Ranked& than, Worth worth, Visitor visit) {
  Ranked best;
  while (!put_off_.empty() && put_off_.front() < than) {
    const Candidate* const candidate = take_best(put_off_, worth, best);
    if (candidate == nullptr) return;
    if (!(best < than)) return push(put_off_, best);
    visit(*candidate);
    aside_.push_back(best);
  }
}

/// The total order of the candidates of one target sample: by score, then shape, then source.
bool ranks_before(const Candidate& a, const Candidate& b);

}  // namespace tessera
