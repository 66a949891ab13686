// Filling the free region greedily: match what is stale, place the best candidate, again (paper section 4, Fig. 15).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/stop.h"
#include "core/matching/matcher.h"
#include "master/collage.h"

namespace tessera::master {

class Filling {
 public:
  /// Begins a new field in the matcher, which tells all workers (Matcher::start_field). Adds to the counters and times
  /// of `statistics`. `check_stop` is called while the master computes by itself, and may
  /// throw what it likes to end that.
  Filling(Collage& collage, const MatchingContext& context, const CollageSettings& settings, Matcher& matcher,
          RunStatistics& statistics, StopCheck check_stop = never_stop);

  /// Pieces are wanted at these nodes from now on; at first that is the whole canvas.
  void start(const Window& region);

  /// Places the best piece. Where the pool is dry, the region's samples are matched again with other random dockings,
  /// where a gap is left that is wide enough for a piece with whichever come first, and such gaps are searched for a pose
  /// that holds a piece of the smallest size; false when that finds nothing either. Throws Interrupted where the matcher does: the question is undone or its
  /// piece is placed to the end, so that the collage can be saved. So it can where `check_stop` throws.
  bool place_one();

  /// How often the region's samples were matched again since the last piece. Saved and restored with the collage: an
  /// interruption may come in between.
  int empty_passes() const { return empty_passes_; }
  /// Returns false where there are never so many.
  bool restore_empty_passes(int passes);

  /// From now on adds to these statistics.
  void count_into(RunStatistics& statistics) { statistics_ = &statistics; }

 private:
  /// The terms of the candidates that a new piece touches, in the order of Collage::touched_by.
  struct Remeasured {
    std::vector<DockingTerms> terms;
    std::optional<Interrupted> interrupted = {};  // while the matcher was asked
  };

  bool find(Candidate& best);
  void match_samples();
  bool choose(Candidate& best);
  void merge(const Candidate& best);
  Window place(const Candidate& best);
  Remeasured measure(const Window& changed);
  void rescore(const Window& changed, const std::vector<DockingTerms>& terms);
  bool may_match_again();
  MatchPlan plan();
  void check_ahead();
  bool choose_in_gap(Candidate& best);
  void send_changes();

  Collage& collage_;
  Matcher& matcher_;
  RunStatistics* statistics_;
  StopCheck check_stop_;
  std::uint64_t library_pads_ = 0;
  MatchPlan usual_plan_;
  int most_empty_passes_;           // none without tangent dockings: PADs alone would give what they gave before
  std::uint64_t sent_version_ = 0;  // of the limits that the matcher knows; it may still know those of another collage
  Window region_;
  int empty_passes_ = 0;
};

}  // namespace tessera::master
