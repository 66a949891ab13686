// The pool of candidates: for each target sample the best few of the whole library. It lives on the master.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/docking_terms.h"
#include "core/grid.h"
#include "core/similarity.h"

namespace tessera {

/// A docking that was refined, found feasible and scored.
struct Candidate {
  std::uint32_t shape = 0;
  std::uint32_t source = 0;
  Similarity canvas_from_shape;
  DockingTerms terms;
  float score = 0;        // objective along the contour; exact once `exact` is set
  bool exact = false;
  Window window;          // nodes whose change changes the score
};

class Pool {
 public:
  struct Entry {
    std::vector<Candidate> candidates;  // best first
    bool truncated = false;             // there was more than was kept
  };

  /// Takes the best kPoolPerSample; ties by shape, then source.
  void put(std::uint32_t edge, std::vector<Candidate> candidates, bool truncated);
  void erase(std::uint32_t edge) { entries_.erase(edge); }
  std::map<std::uint32_t, Entry>& entries() { return entries_; }

 private:
  std::map<std::uint32_t, Entry> entries_;  // by the target sample's edge
};

/// The total order of candidates of equal target sample: score, shape, source.
bool ranks_before(const Candidate& a, const Candidate& b);

}  // namespace tessera
