// When a trial is kept and when it is put back, with a matcher that offers what the test tells it to.
#include <gtest/gtest.h>

#include "master/ruin_and_recreate.h"
#include "offered_filling.h"

namespace tessera::master {
namespace {

using test::piece;

/// A collage of two small pieces in opposite corners of the canvas, where target samples lie beside the hole that they
/// leave; every trial takes out one of them or both.
class RuinAndRecreateTest : public test::OfferedFilling {
 protected:
  /// Pieces are placed where the matcher says.
  static CollageSettings unsettled() {
    CollageSettings s = settings();
    s.settle = false;
    return s;
  }

  explicit RuinAndRecreateTest(const CollageSettings& s = unsettled())
      : OfferedFilling(s),
        ruin_(collage_, filling_, s) {
    collage_.replace_placements(before_);
  }

  Trial try_with(const test::Offers& offers, bool stopped = false) {
    matcher_.offers = offers;
    return ruin_.try_once(trial_++, [stopped] { return stopped; });
  }

  const std::vector<Placement> before_ = {piece(0, 30, {18, 18}), piece(3, 24, {187, 127})};
  RuinAndRecreate ruin_;
  std::uint32_t trial_ = 0;
};

TEST_F(RuinAndRecreateTest, WhatCoversMoreIsKept) {
  EXPECT_EQ(try_with({piece(1, 60, {100, 70})}), Trial::kept);
  EXPECT_NE(collage_.placements(), before_);
  EXPECT_EQ(collage_.placements().back().canvas_from_shape.scale(), 60);
}

TEST_F(RuinAndRecreateTest, WhatCoversLessIsPutBack) {
  const std::int64_t free_before = collage_.free().free_256ths_px2();
  EXPECT_EQ(try_with({piece(1, 20, {100, 120})}), Trial::put_back);
  EXPECT_EQ(collage_.placements(), before_);
  EXPECT_EQ(collage_.free().free_256ths_px2(), free_before);
}

/// The same pieces in another order would change the bytes of the result for nothing.
TEST_F(RuinAndRecreateTest, WhatCoversAsMuchIsPutBack) {
  bool both = false;  // taken out, and placed again in the other order
  for (int trial = 0; trial < 12; ++trial) {
    EXPECT_EQ(try_with({before_[1], before_[0]}), Trial::put_back);
    EXPECT_EQ(collage_.placements(), before_);
    both |= matcher_.offers.empty();
  }
  EXPECT_TRUE(both);
}

TEST_F(RuinAndRecreateTest, AnInterruptedTrialIsPutBack) {
  EXPECT_EQ(try_with({piece(1, 60, {100, 70})}, true), Trial::interrupted);
  EXPECT_EQ(collage_.placements(), before_);
}

class WithTwoPiecesAtMost : public RuinAndRecreateTest {
 protected:
  static CollageSettings two_pieces() {
    CollageSettings s = unsettled();
    s.stop.pieces = 2;
    return s;
  }
  WithTwoPiecesAtMost() : RuinAndRecreateTest(two_pieces()) {}
};

TEST_F(WithTwoPiecesAtMost, MorePiecesArePutBackAndAsManyAreKept) {
  const Placement large = piece(1, 60, {100, 70});
  EXPECT_EQ(try_with({large, piece(2, 20, {30, 120}), piece(2, 20, {170, 120})}), Trial::put_back);
  EXPECT_EQ(collage_.placements(), before_);
  EXPECT_EQ(try_with({large}), Trial::kept);
}

}  // namespace
}  // namespace tessera::master
