// The display of a run's progress, and a signal that ends the run without ending the process.
#include <gtest/gtest.h>

#include <csignal>

#include "comm/stop_signals.h"
#include "run/progress/collage_progress.h"

namespace tessera::cli {
namespace test_collage_progress {

TEST(CollageProgress, note_has_pieces_coverage_and_rate) {
  EXPECT_EQ(progress_note({.pieces = 120, .coverage = 0.93, .seconds = 10, .open_samples = 0, .trials = 7}),
            "120 pieces, 93.0 % covered, trial 7");
  EXPECT_EQ(progress_note({.pieces = 120, .coverage = 0.93, .trials = 7, .most_trials = 150}),
            "120 pieces, 93.0 % covered, trial 7 of 150");
  EXPECT_EQ(progress_note({.pieces = 120, .coverage = 0.4567, .seconds = 10, .open_samples = 0}),
            "120 pieces, 45.7 % covered, 12.0 pieces/s");
  EXPECT_EQ(progress_note({.pieces = 120, .coverage = 0.4567, .seconds = 10, .attempt = 2}),
            "120 pieces, 45.7 % covered, attempt 2 at other sizes, as some found no place");
  EXPECT_EQ(progress_note({}), "0 pieces, 0.0 % covered, 0.0 pieces/s");
  EXPECT_EQ(progress_note({.pieces = 1, .coverage = 0.01}), "1 piece, 1.0 % covered, 0.0 pieces/s");
}

TEST(CollageProgress, a_time_limit_ends_the_loop) {
  CollageProgress endless({}, true);
  EXPECT_EQ(endless.stop_requested(), std::nullopt);
  CollageProgress ended({}, true, TimeLimit(reserve_s(1)));
  EXPECT_EQ(ended.stop_requested(), StopReason::time_limit);
}

TEST(StopSignal, signals_ask_for_the_end_as_often_as_they_come) {
  comm::install_stop_handlers();
  CollageProgress progress({}, true);
  EXPECT_EQ(progress.stop_requested(), std::nullopt);
  std::raise(SIGINT);
  std::raise(SIGTERM);
  std::raise(SIGINT);
  std::raise(SIGUSR2);
  EXPECT_EQ(progress.stop_requested(), StopReason::signal);
}

}  // namespace test_collage_progress
}  // namespace tessera::cli
