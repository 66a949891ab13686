// A state that is damaged, or of another canvas or library, is refused with the reason.
#include <gtest/gtest.h>

#include <limits>

#include "foreign_state.h"
#include "stopped_collage.h"

namespace tessera::master {
namespace test_foreign_state {

using namespace stopped_collage;

/// A state after some rounds, which the tests damage.
class ForeignState : public test::ForeignStateTest {
 protected:
  void SetUp() override {
    KeepLatest keeper;
    StopAfter stop(4);
    run(settings(), {}, stop, {nullptr, &keeper});
    state_ = keeper.latest;
    state_.name = "checkpoint.h5";
  }

  void go_on() const override {
    SilentObserver silent;
    run(settings(), {}, silent, {&state_, nullptr});
  }
};

TEST_F(ForeignState, IsFineBeforeTheChange) { EXPECT_EQ(complaint(), "none"); }

TEST_F(ForeignState, PiecesInAnotherPlace) {
  state_.placements[1].canvas_from_shape.tx += 0.25f;
  state_.pool.clear();
  state_.stale.clear();
  state_.matched.clear();
  expect_complaint("its pieces leave another free region than the saved one");
}

TEST_F(ForeignState, ShapesThatDoNotExist) {
  state_.placements[0].shape = ShapeId{12};
  expect_complaint("shape 12 of 12");
}

TEST_F(ForeignState, CandidatesThatDoNotExist) {
  for (PooledSample& sample : state_.pool) {
    for (Candidate& c : sample.candidates) c.shape = ShapeId{4'000'000'000u};
  }
  expect_complaint("shape 4000000000 of 12");
}

TEST_F(ForeignState, AbsurdPoses) {
  for (const float absurd : {1e30f, -1e9f, std::numeric_limits<float>::quiet_NaN()}) {
    state_.placements[0].canvas_from_shape.ty = absurd;
    expect_complaint("a piece with an impossible size or place");
  }
  for (const float scale_px : {0.f, 1.f, 1e6f}) {
    state_.placements[0].canvas_from_shape = {scale_px, 0, 10, 10};
    expect_complaint("a piece with an impossible size or place");
  }
}

TEST_F(ForeignState, AbsurdWindows) {
  for (const int absurd : {std::numeric_limits<int>::min(), -1'000'000, 5000}) {
    for (PooledSample& sample : state_.pool) {
      for (Candidate& c : sample.candidates) c.window.x0 = absurd;
    }
    expect_complaint("a candidate with an impossible size or place");
  }
}

TEST_F(ForeignState, AbsurdShapeSizes) {
  for (const float size : {0.f, -5.f, 1e30f, std::numeric_limits<float>::quiet_NaN()}) {
    for (float Candidate::*member : {&Candidate::perimeter, &Candidate::radius}) {
      const CheckpointState whole = state_;
      for (PooledSample& sample : state_.pool) {
        for (Candidate& c : sample.candidates) c.*member = size;
      }
      expect_complaint("a candidate with an impossible size or place");
      state_ = whole;
    }
  }
}

TEST_F(ForeignState, MoreSearchesThanThereCanBe) {
  for (const bool of_all : {false, true}) {
    state_.search = of_all ? 0 : 5;
    state_.searched = of_all ? 5 : 0;
    EXPECT_EQ(complaint(),
              "checkpoint.h5: not a checkpoint of this job: a sample was searched 5 times; --restart removes it and "
              "starts again");
  }
}

TEST_F(ForeignState, MorePiecesInABatchThanWerePlaced) {
  state_.batch_pieces = std::uint32_t(state_.placements.size()) + 1;
  expect_complaint("more pieces in a batch than were placed");
}

TEST_F(ForeignState, ABatchOnAnotherCanvas) {
  ASSERT_GT(state_.batch_pieces, 0u);
  state_.batch_taken.push_back(0);
  expect_complaint("a batch on another canvas");
}

TEST_F(ForeignState, TargetSamplesThatDoNotExist) {
  state_.stale.push_back(SampleId{4'000'000'000u});
  expect_complaint("there is no target sample 4000000000");
  state_.stale.clear();
  state_.matched.push_back({});
  expect_complaint("there is no target sample 0");
}

}  // namespace test_foreign_state
}  // namespace tessera::master
