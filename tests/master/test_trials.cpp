// The decisions to keep a trial or to put it back, with a matcher that offers the test's candidates.
#include <gtest/gtest.h>

#include "core/relax/schedules.h"
#include "master/improving.h"
#include "master/rules/kept_apart.h"
#include "offered_filling.h"

namespace tessera::master {
namespace test_trials {

using test::piece;

/// A collage of two small pieces in opposite corners of the canvas. Target samples lie beside the holes that they leave. Every trial takes
/// out one of them or both.
class TrialsTest : public test::OfferedFilling {
 protected:
  /// Pieces are placed exactly where the matcher says.
  static CollageSettings unsettled() {
    CollageSettings s = settings();
    s.settle = false;
    s.improve.relax = false;
    return s;
  }

  explicit TrialsTest(const CollageSettings& s = unsettled())
      : OfferedFilling(s),
        improving_(collage_, filling_, s, canvas_.area_px2, shapes_) {
    collage_.replace_placements(before_);
  }

  Trial try_with(const test::Offers& offers, bool stopped = false) {
    matcher_.offers = offers;
    return improving_.try_once(
        trial_++, stop_check([stopped] { return stopped ? std::optional(StopReason::signal) : std::nullopt; }));
  }

  const std::vector<Placement> before_ = {piece(0, 30, {18, 18}), piece(3, 24, {187, 127})};
  Improving improving_;
  std::uint32_t trial_ = 0;
};

TEST_F(TrialsTest, WhatCoversMoreIsKept) {
  EXPECT_EQ(try_with({piece(1, 60, {100, 70})}), Trial::kept);
  EXPECT_NE(collage_.placements(), before_);
  EXPECT_EQ(collage_.placements().back().canvas_from_shape.scale(), 60);
}

TEST_F(TrialsTest, WhatCoversLessIsPutBack) {
  const std::int64_t free_before = collage_.free().free_256ths_px2();
  EXPECT_EQ(try_with({piece(1, 20, {100, 120})}), Trial::put_back);
  EXPECT_EQ(collage_.placements(), before_);
  EXPECT_EQ(collage_.free().free_256ths_px2(), free_before);
}

/// The same pieces in another order would change the bytes of the result without a gain.
TEST_F(TrialsTest, WhatCoversAsMuchIsPutBack) {
  bool both = false;  // both were taken out, and placed again in the other order
  for (int trial = 0; trial < 12; ++trial) {
    EXPECT_EQ(try_with({before_[1], before_[0]}), Trial::put_back);
    EXPECT_EQ(collage_.placements(), before_);
    both |= matcher_.offers.empty();
  }
  EXPECT_TRUE(both);
}

TEST_F(TrialsTest, AnInterruptedTrialIsPutBack) {
  EXPECT_THROW(try_with({piece(1, 60, {100, 70})}, true), Interrupted);
  EXPECT_EQ(collage_.placements(), before_);
}

/// Two dwarfs replace a piece and cover more of the canvas.
class DwarfsTest : public TrialsTest {
 protected:
  static CollageSettings with(float balance, float largest_px) {
    CollageSettings s = unsettled();
    s.objective.balance = balance;
    s.pieces.max_scale_px = largest_px;
    return s;
  }
  explicit DwarfsTest(float balance = 1, float largest_px = 130) : TrialsTest(with(balance, largest_px)) {}

  bool any_kept() {
    for (int trial = 0; trial < 12; ++trial) {
      if (try_with({piece(0, 24, {18, 18}), piece(0, 24, {46, 18})}) == Trial::kept) return true;
    }
    return false;
  }
};

class DwarfsInContrastTest : public DwarfsTest {
 protected:
  DwarfsInContrastTest() : DwarfsTest(0) {}
};

class AmongPiecesAlikeTest : public DwarfsTest {
 protected:
  AmongPiecesAlikeTest() : DwarfsTest(1, 110) {}
};

TEST_F(AmongPiecesAlikeTest, TheSmallestAreNoDwarfs) { EXPECT_TRUE(any_kept()); }
TEST_F(DwarfsTest, AreNoGainWhereSizesAreToBeEven) { EXPECT_FALSE(any_kept()); }
TEST_F(DwarfsInContrastTest, AreAGainElsewhere) { EXPECT_TRUE(any_kept()); }

class RelaxingTest : public TrialsTest {
 protected:
  static CollageSettings relaxing() {
    CollageSettings s = unsettled();
    s.improve.relax = true;
    return s;
  }
  RelaxingTest() : TrialsTest(relaxing()) {}
};

/// In the first trial, these two pieces can grow freely to the largest size.
TEST_F(RelaxingTest, AtFirstAllPiecesGrow) {
  EXPECT_EQ(try_with({}), Trial::kept);
  ASSERT_EQ(collage_.placements().size(), 2u);
  for (const Placement& p : collage_.placements()) EXPECT_GT(p.canvas_from_shape.scale(), 80);
}

/// Relaxation is expensive, so it happens only once in many trials.
TEST_F(RelaxingTest, ThenPiecesStandAgain) {
  trial_ = 1;
  EXPECT_EQ(try_with({piece(1, 60, {100, 70})}), Trial::kept);
  EXPECT_EQ(collage_.placements().back().canvas_from_shape.scale(), 60);
  trial_ = 64;
  EXPECT_EQ(try_with({}), Trial::kept);
  EXPECT_GT(collage_.placements().back().canvas_from_shape.scale(), 70);
}

TEST(PaysToRelax, WhereSizesAreMuchAlikeAndDoNotGoByThePlace) {
  CollageSettings s;
  s.pieces.min_scale_px = 20;
  s.pieces.max_scale_px = 100;
  EXPECT_TRUE(pays_to_relax(s));
  CollageSettings other = s;
  other.pieces.max_scale_px = 101;
  EXPECT_FALSE(pays_to_relax(other));
  other = s;
  other.improve.relax = false;
  EXPECT_FALSE(pays_to_relax(other));
  other = s;
  other.pieces.size_map = std::make_shared<SizeMap>();
  EXPECT_FALSE(pays_to_relax(other));
  other = s;
  other.colour.target = std::make_shared<ColourTarget>(Grid<Texel>(2, 2), 1.f);
  EXPECT_FALSE(pays_to_relax(other));
}

TEST(PaysToRelax, WhereAnyPieceMayGrow) {
  CollageSettings s;
  s.pieces.min_scale_px = s.pieces.max_scale_px = 50;
  EXPECT_FALSE(pays_to_relax(s));
  // Each shape has its drawn size: sizes differ, and none may change.
  s.pieces.min_scale_px = 40;
  s.pieces.max_scale_px = 60;
  s.wishes.classes.resize(2);
  s.wishes.classes[0].poses.scale_px = {{40, 40}};
  s.wishes.classes[1].poses.scale_px = {{60, 60}};
  s.wishes.class_of_shape = {0, 1, 0};
  EXPECT_FALSE(pays_to_relax(s));
  s.wishes.classes[1].poses.scale_px = {{50, 60}};
  EXPECT_TRUE(pays_to_relax(s));
  s.wishes.classes[1].weight = 0;
  EXPECT_FALSE(pays_to_relax(s)) << "it may not stand";
}

TEST(PaysToRelax, OnceInAsManyTrialsAsThereArePiecesButNotOftenerThanIn64) {
  PieceSettings pieces;
  pieces.min_scale_px = 10;
  pieces.max_scale_px = 40;
  EXPECT_EQ(trials_per_relaxation(400. * 3000, pieces), 3000u);
  EXPECT_EQ(trials_per_relaxation(400. * 10, pieces), 64u);
}

/// The region begins at a later trial.
TEST_F(RelaxingTest, TheFirstTrialIsThatOfTheRegion) {
  EXPECT_EQ(improving_.try_once(7, never_stop, 7), Trial::kept);
  for (const Placement& p : collage_.placements()) EXPECT_GT(p.canvas_from_shape.scale(), 80);
}

/// The pieces start where others left them, even if they overlap slightly.
TEST_F(RelaxingTest, PiecesSettleFromWhereTheyAre) {
  const std::vector<Placement> moving = {piece(1, 50, {50, 70}), piece(3, 50, {95, 70}), piece(0, 40, {160, 80})};
  matcher_.offers = {};
  EXPECT_EQ(improving_.relax_replaced_pieces(moving, 9, never_stop), Trial::kept);
  ASSERT_EQ(collage_.placements().size(), 3u);
  for (std::size_t i = 0; i < moving.size(); ++i) EXPECT_EQ(collage_.placements()[i].shape, moving[i].shape);
  const Vec2 apart = collage_.placements()[1].canvas_from_shape.translation() -
                     collage_.placements()[0].canvas_from_shape.translation();
  EXPECT_GT(norm(apart), 45) << "they make room for each other";
}

TEST_F(RelaxingTest, WhatSettlesToLessIsPutBack) {
  matcher_.offers = {};
  ASSERT_EQ(improving_.try_once(0, never_stop), Trial::kept);
  const std::vector<Placement> large = collage_.placements();
  EXPECT_EQ(improving_.relax_replaced_pieces({piece(1, 20, {60, 70})}, 9, never_stop), Trial::put_back);
  EXPECT_EQ(collage_.placements(), large);
}

TEST_F(RelaxingTest, AnInterruptedSettlingIsPutBack) {
  int asked = 0;
  const StopCheck stop = stop_check([&] { return ++asked > 20 ? std::optional(StopReason::signal) : std::nullopt; });
  EXPECT_THROW(improving_.relax_replaced_pieces({piece(1, 60, {60, 70})}, 9, stop), Interrupted);
  EXPECT_EQ(collage_.placements(), before_);
}

/// The relaxation is interrupted at many different moments.
TEST_F(RelaxingTest, AnInterruptedRelaxationIsPutBack) {
  int interrupted = 0;
  for (int questions = 1;; questions += 3) {
    matcher_.offers = {piece(1, 25, {100, 70}), piece(2, 21, {30, 120})};
    int asked = 0;
    try {
      improving_.try_once(
          0, stop_check([&] { return ++asked > questions ? std::optional(StopReason::signal) : std::nullopt; }));
      break;
    } catch (const Interrupted&) {
      ++interrupted;
    }
    ASSERT_EQ(collage_.placements(), before_) << "after " << questions << " questions";
  }
  EXPECT_GT(interrupted, 20);
}

/// The cost of repetition as the job sets it: the largest allowed one, or none.
class RepetitionTest : public TrialsTest {
 protected:
  static CollageSettings with(float repetition_exponent) {
    CollageSettings s = unsettled();
    s.improve.relax = true;
    s.objective.repetition_exponent = repetition_exponent;
    return s;
  }
  explicit RepetitionTest(float repetition_exponent = 4) : TrialsTest(with(repetition_exponent)) {
    collage_.replace_placements({piece(0, 80, {45, 70}), piece(1, 80, {150, 70})});
  }
  /// Both pieces can grow freely to the largest size.
  Trial settles_to(std::uint32_t a, std::uint32_t b) {
    matcher_.offers = {};
    return improving_.relax_replaced_pieces({piece(a, 88, {50, 70}), piece(b, 88, {150, 70})}, 9, never_stop);
  }
};

class WithoutCostTest : public RepetitionTest {
 protected:
  WithoutCostTest() : RepetitionTest(0) {}
};

TEST_F(RepetitionTest, CopiesOfOneDrawingThatCoverMoreArePutBack) { EXPECT_EQ(settles_to(3, 3), Trial::put_back); }
TEST_F(RepetitionTest, DifferentDrawingsThatCoverMoreAreKept) { EXPECT_EQ(settles_to(3, 1), Trial::kept); }
TEST_F(WithoutCostTest, CopiesThatCoverMoreAreKept) { EXPECT_EQ(settles_to(3, 3), Trial::kept); }

/// Pieces that moved or grew may be too near to pieces of the same shape.
class ApartTest : public test::OfferedFilling {
 protected:
  static CollageSettings apart() {
    CollageSettings s = settings();
    s.pieces.apart_px = 60;
    return s;
  }
};

/// Given pieces stay all the same.
TEST_F(ApartTest, OfPiecesTooNearToTheirLikeTheFirstStays) {
  const std::vector<Placement> given = {piece(0, 20, {30, 30}), piece(0, 20, {60, 30})};
  const Placement other = piece(1, 20, {90, 30});
  const Placement near = piece(0, 20, {90, 60});
  const Placement far = piece(0, 20, {170, 100});
  EXPECT_EQ(without_pieces_near_like({given[0], given[1], other, near, far}, given.size(), apart(), shapes_, Period{}),
            (std::vector<Placement>{given[0], given[1], other, far}));
}

/// The shape may not return at any size. Given pieces stay all the same.
TEST_F(ApartTest, WhatWasTakenOutDoesNotComeBackToWhereItLay) {
  CollageSettings s = settings();
  s.wishes.not_back = {{ShapeId{0}, {0, 40, 100, 70}}};
  const Placement back = piece(0, 10, {110, 80});
  const Placement other = piece(1, 40, {100, 70});
  const Placement beside = piece(0, 40, {121, 70});
  EXPECT_EQ(without_pieces_near_like({back, other, beside, back}, 1, s, shapes_, Period{}),
            (std::vector<Placement>{back, other, beside}));
}

/// Only the distance rule keeps these two pieces from growing.
TEST_F(ApartTest, OfPiecesThatGrewTooNearToTheirLikeTheFirstStays) {
  Relaxing relaxing(collage_.free(), apart(), shapes_, [](const Placement&) { return PoseRange{20, 90, {}}; });
  const auto relaxed_beside = [&](std::uint32_t shape) {
    return relaxing.relaxed({piece(0, 40, {45, 70}), piece(shape, 40, {155, 70})}, 0, kRelaxCollage, [] {});
  };
  EXPECT_EQ(relaxed_beside(1).size(), 2u);
  const std::vector<Placement> alike = relaxed_beside(0);
  ASSERT_EQ(alike.size(), 1u);
  EXPECT_LT(alike[0].canvas_from_shape.translation().x, 100);
}

class WithTwoPiecesAtMost : public TrialsTest {
 protected:
  static CollageSettings two_pieces() {
    CollageSettings s = unsettled();
    s.stop.pieces = 2;
    return s;
  }
  WithTwoPiecesAtMost() : TrialsTest(two_pieces()) {}
};

TEST_F(WithTwoPiecesAtMost, NoMoreArePlaced) {
  const Placement large = piece(1, 60, {100, 70});
  EXPECT_EQ(try_with({large, piece(2, 20, {30, 120}), piece(2, 20, {170, 120})}), Trial::kept);
  EXPECT_EQ(collage_.placements().size(), 2u);
  EXPECT_EQ(collage_.placements().front().canvas_from_shape, large.canvas_from_shape);
}

}  // namespace test_trials
}  // namespace tessera::master
