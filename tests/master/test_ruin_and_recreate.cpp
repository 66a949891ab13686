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
    s.improve.relax = false;
    return s;
  }

  explicit RuinAndRecreateTest(const CollageSettings& s = unsettled())
      : OfferedFilling(s),
        ruin_(canvas_, collage_, filling_, s, shapes_) {
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

class RelaxingTest : public RuinAndRecreateTest {
 protected:
  static CollageSettings relaxing() {
    CollageSettings s = unsettled();
    s.improve.relax = true;
    return s;
  }
  RelaxingTest() : RuinAndRecreateTest(relaxing()) {}
};

/// The first trial; nothing hinders these two from growing to the largest size.
TEST_F(RelaxingTest, AtFirstAllPiecesGrow) {
  EXPECT_EQ(try_with({}), Trial::kept);
  ASSERT_EQ(collage_.placements().size(), 2u);
  for (const Placement& p : collage_.placements()) EXPECT_GT(p.canvas_from_shape.scale(), 80);
}

/// Only now and then, as it is dear.
TEST_F(RelaxingTest, ThenPiecesStandAgain) {
  trial_ = 1;
  EXPECT_EQ(try_with({piece(1, 60, {100, 70})}), Trial::kept);
  EXPECT_EQ(collage_.placements().back().canvas_from_shape.scale(), 60);
  trial_ = 64;
  EXPECT_EQ(try_with({}), Trial::kept);
  EXPECT_GT(collage_.placements().back().canvas_from_shape.scale(), 70);
}

/// Of a region that is begun later.
TEST_F(RelaxingTest, TheFirstTrialIsThatOfTheRegion) {
  EXPECT_EQ(ruin_.try_once(
                7, [] { return false; }, 7),
            Trial::kept);
  for (const Placement& p : collage_.placements()) EXPECT_GT(p.canvas_from_shape.scale(), 80);
}

/// At whatever moment.
TEST_F(RelaxingTest, AnInterruptedRelaxationIsPutBack) {
  int interrupted = 0;
  for (int questions = 1;; questions += 3) {
    matcher_.offers = {piece(1, 25, {100, 70}), piece(2, 21, {30, 120})};
    int asked = 0;
    if (ruin_.try_once(0, [&] { return ++asked > questions; }) != Trial::interrupted) break;
    ++interrupted;
    ASSERT_EQ(collage_.placements(), before_) << "after " << questions << " questions";
  }
  EXPECT_GT(interrupted, 20);
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
