// After its placements are replaced, a collage depends only on the placements before and after, not on earlier matches.
#include <gtest/gtest.h>

#include "rounds_by_hand.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_replace_placements {

using namespace whole_collage;

/// A collage in which some samples have changed slightly since they were matched, and the next piece.
class ReplacePlacements : public testing::Test {
 protected:
  void SetUp() override {
    for (int round = 0; round < 20 && rounds_.state().matched.empty(); ++round) {
      ASSERT_TRUE(rounds_.choose(next_));
      rounds_.place(next_);
    }
    ASSERT_FALSE(rounds_.state().matched.empty()) << "the test needs samples that changed a little";
    ASSERT_TRUE(rounds_.choose(next_));
  }

  const Canvas canvas_ = make_rectangle_canvas(300, 220);
  test::RoundsByHand rounds_{canvas_, settings(), library()};
  Candidate next_;
};

TEST_F(ReplacePlacements, ForgetsWhatItsSamplesWereMatchedWith) {
  rounds_.collage().replace_placements(rounds_.state().placements);
  const CheckpointState state = rounds_.state();
  EXPECT_TRUE(state.matched.empty());
  EXPECT_TRUE(state.pool.empty());
  EXPECT_TRUE(state.stale.empty());
  EXPECT_TRUE(state.matches.empty());
}

/// Changes add up from now on, without the earlier matches.
TEST_F(ReplacePlacements, GoesOnAsAnyWithTheSamePlacementsBeforeAndAfter) {
  test::RoundsByHand fresh(canvas_, settings(), library());
  const std::vector<Placement> placements = rounds_.state().placements;
  fresh.collage().replace_placements(placements);
  for (test::RoundsByHand* rounds : {&rounds_, &fresh}) {
    rounds->collage().replace_placements(placements);
    rounds->collage().schedule().mark(canvas_.distance.value.bounds());
    rounds->collage().schedule().take();
    rounds->collage().place(next_);
  }
  EXPECT_EQ(rounds_.state().stale, fresh.state().stale);
  EXPECT_TRUE(rounds_.state().matched == fresh.state().matched);
}

}  // namespace test_replace_placements
}  // namespace tessera::master
