// Fills the free region greedily: matches the samples that wait, places the best candidate, and begins again (paper section
// 4, Fig. 15).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/stop.h"
#include "core/matching/matcher.h"
#include "master/collage.h"

namespace tessera::master {

class Filling {
 public:
  /// Begins a new field in the matcher, which tells all workers (Matcher::start_field). Adds to the counters and times of
  /// `statistics`. Calls `check_stop` while the master computes by itself; `check_stop` may throw to end that.
  Filling(Collage& collage, const MatchingContext& context, const CollageSettings& settings, Matcher& matcher,
          RunStatistics& statistics, StopCheck check_stop = never_stop);

  /// Pieces are wanted at these nodes from now on. Before the first call that is the whole canvas.
  void start(const Window& region);

  /// Places the next piece of the batch (batch.h). Where none may join, it ends the batch, matches the samples that wait, and
  /// begins another batch with the best piece. Where no candidate of the pool fits, it searches: it matches the samples of
  /// the region again with many other random dockings, first those that were searched the fewest times. Where a wide gap is
  /// left, the first search of a sample keeps the dockings that were drawn first, and one more search follows. When each
  /// sample was searched often enough, it tries poses in wide gaps that hold a piece of the smallest size. False when that
  /// finds nothing either.
  /// Throws Interrupted where the matcher or `check_stop` does. It then undoes the question, or ends the batch, so that the
  /// collage can be saved.
  bool place_one();
  /// Ends the batch, if one is open: the next piece begins another. It brings the target curve up to date and measures the
  /// candidates that the pieces of the batch touch.
  void end_batch();

  /// The number of the search that goes on: the waiting samples are searched for the first, second .. time. 0: no search
  /// goes on, and they are matched as usual. The collage's checkpoint holds the number.
  int search() const { return search_; }
  void restore_search(int search) { search_ = search; }
  /// How often a sample is searched at most.
  int most_searches() const;

  /// Adds to these statistics from now on.
  void count_into(RunStatistics& statistics) { statistics_ = &statistics; }

 private:
  bool find_further(Candidate& best);
  bool find(Candidate& best);
  void match_samples();
  bool choose(Candidate& best);
  void place(const Candidate& best);
  bool search_again();
  bool wide_gap_is_left();
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
  bool searches_;                   // false without tangent dockings: PADs alone give the same again
  std::uint64_t sent_version_ = 0;  // of the limits that the matcher knows; 0: perhaps those of another collage
  Window region_;
  struct WideGap {
    std::size_t pieces;  // that stood
    bool is_left;
  };
  std::optional<WideGap> wide_gap_;  // as it was last looked for; the answer follows from region and pieces
  int search_ = 0;
};

}  // namespace tessera::master
