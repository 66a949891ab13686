// A candidate's score follows from the nodes of its window: a piece that touches none of them does not change the score.
#include <gtest/gtest.h>

#include "core/collage/exact_terms.h"
#include "rounds_by_hand.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_candidate_windows {

using namespace whole_collage;

bool holds(const Window& window, const Window& part) { return part.intersected(window) == part; }

/// The windows follow from some boundary points, but the exact areas from the whole outline.
TEST(CandidateWindows, HoldTheNodesThatAreCountedExactly) {
  constexpr int kRim = 2;  // the rim of the exact window, where nodes are read but not counted
  test::RoundsByHand rounds(make_rectangle_canvas(300, 220), settings(), library());
  int windows = 0;
  Candidate best;
  for (int round = 0; round < 5 && rounds.choose(best); ++round) {
    for (const PooledSample& sample : rounds.state().pool) {
      for (const Candidate& c : sample.candidates) {
        const Window exact =
            exact_window(library()[index_of(c.shape)], c.canvas_from_shape, rounds.collage().free(), settings().pieces);
        EXPECT_TRUE(holds(c.window, exact.grown(-kRim))) << "shape " << index_of(c.shape);
        ++windows;
      }
    }
    rounds.place(best);
  }
  EXPECT_GT(windows, 100);
}

}  // namespace test_candidate_windows
}  // namespace tessera::master
