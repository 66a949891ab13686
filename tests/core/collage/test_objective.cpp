#include "core/collage/objective.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/collage/exact_terms.h"
#include "core/settings/tuning.h"
#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_objective {

const PieceSize kPiece{50, 200, 100};

TEST(Objective, PrefersLongContactAndLittleWaste) {
  for (const Objective kind : {Objective::paper, Objective::scale_aware}) {
    ObjectiveSettings settings;
    settings.kind = kind;
    const DockingTerms good{150, 10, 20, 100, 400};
    DockingTerms shorter = good;
    shorter.matched_px = 100;
    DockingTerms overlapping = good;
    overlapping.overlap_px2 = 100;
    overlapping.overlap_px4 = 1e4f;
    DockingTerms gaping = good;
    gaping.gap_px2 = 200;
    gaping.gap_px4 = 4e4f;
    const float best = objective(good, kPiece, settings);
    EXPECT_GT(best, objective(shorter, kPiece, settings));
    EXPECT_GT(best, objective(overlapping, kPiece, settings));
    EXPECT_GT(best, objective(gaping, kPiece, settings));
    DockingTerms of_dwarf = good;
    of_dwarf.matched_px = 75;
    EXPECT_GT(best, objective(of_dwarf, {25, 100, 100}, settings)) << "a dwarf of the same share and waste";
  }
}

TEST(Objective, OfThePaperPunishesOneLargeGapMoreThanManySmall) {
  ObjectiveSettings settings;
  settings.kind = Objective::paper;
  const DockingTerms one{150, 0, 100, 0, 1e4f};
  const DockingTerms many{150, 0, 100, 0, 1e3f};  // ten of 10 px² each
  EXPECT_LT(objective(one, kPiece, settings), objective(many, kPiece, settings));
}

TEST(Objective, ScaleAwareHasItsFormula) {
  ObjectiveSettings settings;
  settings.balance = 0;
  const DockingTerms terms{128, 50, 150, 0, 0};
  const float expected = std::pow(128.f / 200, 0.5f) / (1 + 5 * (3 * 50.f + 150.f) / 2500) * std::pow(0.5f, 0.7f);
  EXPECT_NEAR(objective(terms, kPiece, settings), expected, 1e-6f);
}

/// A poor fit of a large piece and a good fit of a piece half as large change their order from one end of the scale to the other.
TEST(Objective, BalanceWeighsContactAgainstSize) {
  const DockingTerms large{80, 0, 0, 0, 0};
  const DockingTerms middle{90, 0, 0, 0, 0};
  const PieceSize large_piece{100, 400, 100};
  const PieceSize middle_piece{50, 200, 100};
  ObjectiveSettings settings;
  settings.balance = 0;
  EXPECT_GT(objective(large, large_piece, settings), objective(middle, middle_piece, settings));
  settings.balance = 1;
  EXPECT_LT(objective(large, large_piece, settings), objective(middle, middle_piece, settings));
}

/// A dwarf fits into its gap along its whole boundary. It must not score higher than a large piece for that.
TEST(Objective, BalanceCostsDwarfsMore) {
  const DockingTerms whole{200, 0, 0, 0, 0};
  ObjectiveSettings settings;
  float before = 1;
  for (const float balance : {0.f, 0.25f, 0.5f, 0.75f, 1.f}) {
    settings.balance = balance;
    const float dwarf = objective(whole, {12.5f, 200, 100}, settings);
    EXPECT_LT(dwarf, before) << balance;
    before = dwarf;
  }
}

/// The score grows with contact and with size, whatever the balance, and never exceeds 1.
RC_GTEST_PROP(ObjectiveProperty, balanced_or_not_contact_and_size_are_welcome, ()) {
  ObjectiveSettings settings;
  settings.balance = 0.01f * float(*rc::gen::inRange(0, 101));
  const float scale_px = float(*rc::gen::inRange(20, 160));
  const float matched = 0.01f * float(*rc::gen::inRange(3, 100));
  const auto value = [&](float scale, float share) {
    const DockingTerms terms{share * 4 * scale, 0, 0, 0, 0};
    return objective(terms, {scale, 4 * scale, 160}, settings);
  };
  RC_ASSERT(value(scale_px, matched) < value(scale_px + 1, matched));
  RC_ASSERT(value(scale_px, matched) < value(scale_px, matched + 0.01f));
  RC_ASSERT(value(160, 1) <= 1.f);
}

RC_GTEST_PROP(ObjectiveProperty, balance_is_three_exponents, ()) {
  ObjectiveSettings settings;
  settings.balance = 0.01f * float(*rc::gen::inRange(0, 101));
  const ObjectiveSettings s = balanced(settings);
  RC_ASSERT(s.length_exponent == settings.length_exponent + kBalanceOfLength * settings.balance);
  RC_ASSERT(s.scale_exponent == settings.scale_exponent + kBalanceOfScale * settings.balance);
  RC_ASSERT(s.repetition_exponent == settings.repetition_exponent * (1 + kBalanceOfRepetition * settings.balance));
  const DockingTerms terms{float(*rc::gen::inRange(1, 200)), float(*rc::gen::inRange(0, 99)), 20, 100, 400};
  RC_ASSERT(objective(terms, kPiece, settings) == objective(terms, kPiece, s));
}

TEST(Objective, OfThePaperKnowsNoBalance) {
  ObjectiveSettings settings;
  settings.kind = Objective::paper;
  const DockingTerms terms{128, 50, 150, 0, 0};
  settings.balance = 0;
  const float before = objective(terms, kPiece, settings);
  settings.balance = 1;
  EXPECT_EQ(objective(terms, kPiece, settings), before);
}

/// The paper's Z contains squares of single areas, which change with the areas.
TEST(ExactAreas, CountForEveryObjective) {
  const DockingTerms estimated{150, 10, 20, 60, 300};
  const DockingTerms exact = with_exact_areas(estimated, {20, 60});
  EXPECT_EQ(exact, (DockingTerms{150, 20, 60, 240, 2700}));
  const DockingTerms unseen = with_exact_areas({150, 0, 0, 0, 0}, {5, 7});
  EXPECT_EQ(unseen, (DockingTerms{150, 5, 7, 25, 49}));
  for (const Objective kind : {Objective::paper, Objective::scale_aware}) {
    ObjectiveSettings settings;
    settings.kind = kind;
    EXPECT_LT(objective(exact, kPiece, settings), objective(estimated, kPiece, settings));
  }
}

TEST(ExactAreas, OfADiscInAFreeCanvas) {
  const Shape disc = test::make_test_shape("disc", test::disc_outline());
  const PieceSettings pieces{.min_scale_px = 20, .max_scale_px = 80};
  FreeField free(make_rectangle_canvas(200, 200), pieces);
  OpenedField opened(free, pieces);
  const ExactAreas clear = exact_areas(disc, {60, 0, 100, 100}, free, opened, pieces);
  EXPECT_EQ(clear.overlap_px2, 0);
  EXPECT_EQ(clear.gap_px2, 0);

  const ExactAreas over_the_edge = exact_areas(disc, {60, 0, 0, 100}, free, opened, pieces);
  EXPECT_NEAR(over_the_edge.overlap_px2, 400, 30);  // as far as the rim of 6 px reaches
}

TEST(ExactAreas, SeeTheGapThatNothingCanEnter) {
  const Shape disc = test::make_test_shape("disc", test::disc_outline());
  const PieceSettings pieces{.min_scale_px = 40, .max_scale_px = 80};
  FreeField free(make_rectangle_canvas(200, 200), pieces);
  OpenedField opened(free, pieces);
  const float radius = 60 / std::sqrt(3.14159265f);
  const ExactAreas touching = exact_areas(disc, {60, 0, 100, radius + 1}, free, opened, pieces);
  const ExactAreas apart = exact_areas(disc, {60, 0, 100, radius + 45}, free, opened, pieces);
  EXPECT_GT(touching.gap_px2, 50);  // the two wedges between the disc and the edge
  EXPECT_EQ(apart.gap_px2, 0);
}

}  // namespace test_objective
}  // namespace tessera
