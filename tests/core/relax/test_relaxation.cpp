// Relaxation: pieces that move, turn and scale together.
#include "core/relax/relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/relax/relaxation_step.h"
#include "core/relaxed_pieces.h"

namespace tessera {
namespace test_relaxation {

using namespace relaxed_pieces;

FreeField seamless(int size_px, bool in_x, bool in_y) {
  return {make_seamless_canvas(size_px, size_px, in_x, in_y), PieceSettings{}};
}

/// The pose after a movement of `by_px` along one of the four directions. It uses sines, unlike the tested code.
Similarity after(const Similarity& s, int direction, double by_px) {
  const double scale = std::hypot(double(s.a), double(s.b));
  const double turn = direction == 2 ? by_px / scale : 0;
  const double factor = direction == 3 ? 1 + by_px / scale : 1;
  return {float(factor * (s.a * std::cos(turn) - s.b * std::sin(turn))),
          float(factor * (s.b * std::cos(turn) + s.a * std::sin(turn))), float(s.tx + (direction == 0 ? by_px : 0)),
          float(s.ty + (direction == 1 ? by_px : 0))};
}

TEST(Relaxation, GradientIsThatOfTheEnergy) {
  const FreeField canvas = rectangle();
  const FreeField torus = seamless(kCanvas_px, true, true);
  EXPECT_TRUE(rc::check([&] {
    const float soft_px = *rc::gen::element(0.f, 3.f);
    const Relaxation relaxation(**rc::gen::element(&canvas, &torus), {soft_px, soft_px - 1});
    std::vector<RelaxedPiece> pieces = any_pieces(kCanvas_px);
    const std::size_t moving = *rc::gen::inRange<std::size_t>(0, pieces.size());
    const Similarity at = pieces[moving].canvas_from_shape;
    RC_PRE(std::abs(at.scale() - 27) > 0.1f);  // at this scale samples become denser
    const std::array<double, 4> gradient = relaxation.energy_gradient(pieces, moving, 3);
    const double size = std::sqrt(gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2] +
                                  gradient[3] * gradient[3]);
    for (int direction = 0; direction < 4; ++direction) {
      constexpr double kStep_px = 0.02;
      const auto energy = [&](double by_px) {
        pieces[moving].canvas_from_shape = after(at, direction, by_px);
        return relaxation.energy_px2(pieces, 3);
      };
      const double difference = (energy(kStep_px) - energy(-kStep_px)) / (2 * kStep_px);
      // Fields are bilinear, so their gradient jumps between cells.
      RC_ASSERT(std::abs(difference - gradient[direction]) < 0.02 * size + 0.5);
    }
  }));
}

/// The energy of the active pieces leaves out only terms that do not change.
TEST(Relaxation, EnergyOfSomeChangesAsThatOfAll) {
  const FreeField canvas = rectangle();
  const FreeField torus = seamless(kCanvas_px, true, true);
  EXPECT_TRUE(rc::check([&] {
    const float soft_px = *rc::gen::element(0.f, 3.f);
    const Relaxation relaxation(**rc::gen::element(&canvas, &torus), {soft_px, soft_px - 1});
    const float hard_stiffness = *rc::gen::element(0.f, 20.f);
    const std::vector<RelaxedPiece> pieces = any_pieces(kCanvas_px);
    std::vector<RelaxedPiece> after = pieces;
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (!*rc::gen::inRange(0, 3)) active.push_back(i);
    }
    RC_PRE(!active.empty());
    for (const std::size_t i : active) {
      if (*rc::gen::inRange(0, 2)) after[i].canvas_from_shape.tx += any_number(-5, 5);
      if (*rc::gen::inRange(0, 2)) after[i].canvas_from_shape.a *= 1.1f;
    }
    const auto change = [&](const std::vector<std::size_t>& of) {
      return relaxation.energy_px2(after, of, 3, hard_stiffness) - relaxation.energy_px2(pieces, of, 3, hard_stiffness);
    };
    const double of_all = change(all_of(pieces));
    RC_ASSERT(std::abs(change(active) - of_all) < 1e-3 + 1e-5 * std::abs(of_all));
  }));
}

TEST(Relaxation, EnergyOfAllIsThatWhereAllAreActive) {
  const FreeField canvas = rectangle();
  EXPECT_TRUE(rc::check([&] {
    const Relaxation relaxation(canvas, {0, -1});
    const std::vector<RelaxedPiece> pieces = any_pieces(kCanvas_px);
    RC_ASSERT(relaxation.energy_px2(pieces, 3) == relaxation.energy_px2(pieces, all_of(pieces), 3));
  }));
}

/// A disc slightly too large for its square: its depth beyond the sides determines its energy.
TEST(Relaxation, HardStiffnessCountsWhatIsTooDeep) {
  const FreeField canvas = rectangle(100);
  const auto energy_px2 = [&](float depth_px, float hard_stiffness) {
    const std::vector<RelaxedPiece> pieces{piece(kDisc, pose((50 + depth_px) / kDiscRadius, 0, {50, 50}))};
    return Relaxation(canvas, {0, -1}).energy_px2(pieces, {0}, 3, hard_stiffness);
  };
  EXPECT_EQ(energy_px2(0.8f, 20), energy_px2(0.8f, 0)) << "so deep it may be";
  const double at_2 = energy_px2(2, 20) - energy_px2(2, 0);
  EXPECT_GT(at_2, 0);
  EXPECT_NEAR(energy_px2(2, 40) - energy_px2(2, 0), 2 * at_2, 1e-3 * at_2);
  // Computed by hand: the depth² along the arcs beyond the four sides, counted from 1 px on. The edge weighs twice a half.
  double sum_px3 = 0;
  constexpr double kStep_rad = 1e-4;
  for (double angle = 0; angle < 2 * std::numbers::pi; angle += kStep_rad) {
    const double beyond = 52 * std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle))) - 50;
    if (beyond > 1) sum_px3 += 52 * kStep_rad * (beyond - 1) * (beyond - 1);
  }
  EXPECT_NEAR(at_2, 20 * sum_px3, 0.1 * at_2);
}

TEST(Relaxation, EnergyBecomesLess) {
  const FreeField canvas = rectangle();
  const Relaxation relaxation(canvas, {0, -1});
  EXPECT_TRUE(rc::check([&] {
    std::vector<RelaxedPiece> pieces = any_pieces(kCanvas_px);
    double before = relaxation.energy_px2(pieces, 2);
    for (int sweep = 0; sweep < 20; ++sweep) {
      relaxation.relax(pieces, all_of(pieces), {1, 2, 2, 0.5f, 0.5f}, do_not_look);
      const double now = relaxation.energy_px2(pieces, 2);
      // If a piece's samples become denser or sparser, its energy jumps a little.
      RC_ASSERT(now < before + 1e-3 * std::abs(before));
      before = now;
    }
  }));
}

TEST(Relaxation, FixedAndInactivePiecesStayBitForBit) {
  const FreeField canvas = rectangle();
  EXPECT_TRUE(rc::check([&] {
    std::vector<RelaxedPiece> pieces = any_pieces(kCanvas_px);
    pieces[2].fixed = true;
    const std::vector<RelaxedPiece> before = pieces;
    Relaxation(canvas, {0, -1}).relax(pieces, {0, 1, 2, 3}, kShort, do_not_look);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const bool stays = i == 2 || i > 3;
      RC_ASSERT((pieces[i].canvas_from_shape == before[i].canvas_from_shape) == stays);
    }
  }));
}

TEST(Relaxation, PosesStayInTheirRange) {
  const FreeField canvas = rectangle();
  EXPECT_TRUE(rc::check([&] {
    std::vector<RelaxedPiece> pieces = any_pieces(kCanvas_px);
    for (RelaxedPiece& p : pieces) {
      const float angle = p.canvas_from_shape.rotation_rad();
      const float width = *rc::gen::element(0.f, 0.3f, 4.f);
      const float scale = p.canvas_from_shape.scale();
      const float octave = *rc::gen::element(1.f, 1.05f, 2.f);
      p.poses = {scale / octave, scale * octave, direction_range(angle - width / 2, angle + width / 2)};
      p.poses.pull_in(p.canvas_from_shape);
    }
    Relaxation(canvas, {0, -1}).relax(pieces, all_of(pieces), kShort, do_not_look);
    for (const RelaxedPiece& p : pieces) RC_ASSERT(p.poses.contains(p.canvas_from_shape));
  }));
}

class CoarseEdge : public testing::Test {
 protected:
  static constexpr float kNode_px = 2;

  static CanvasField coarse(const EdgeDistance& edge, int columns, int rows, Vec2 origin) {
    CanvasField field{Grid<float>(columns, rows), origin};
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        field.value(i, j) = edge.at((origin + Vec2{float(i), float(j)}) * kNode_px).value;
      }
    }
    return field;
  }

  /// Compares both also beyond their nodes. Gradients jump at ridges; nodes 2 px apart place a ridge up to 2 px beside it.
  static void expect_alike(const EdgeDistance& fine, const EdgeDistance& edge, float low_px, float high_px) {
    int alike = 0;
    int all = 0;
    for (float y = low_px; y < high_px; y += 1.9f) {
      for (float x = low_px; x < high_px; x += 2.3f) {
        const FieldSample expected = fine.at({x, y});
        const FieldSample found = edge.at({x, y});
        ASSERT_NEAR(found.value, expected.value, 1) << x << ", " << y;
        alike += norm(found.gradient - expected.gradient) < 0.15f;
        ++all;
      }
    }
    EXPECT_GT(alike, 0.9 * all);
  }
};

TEST_F(CoarseEdge, IsThatOfARectangle) {
  const FreeField canvas = rectangle(100);
  const EdgeDistance fine(canvas);
  const CanvasField field = coarse(fine, 60, 60, {-5, -5});  // covers -10 to 108 px
  expect_alike(fine, EdgeDistance(field, kNode_px), -9, 107);
  EXPECT_FALSE(EdgeDistance(field, kNode_px).period().repeats());
}

TEST_F(CoarseEdge, IsThatOfADisc) {
  Grid<float> coverage(200, 200, 0.f);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) coverage(x, y) = norm(Vec2{float(x) - 100, float(y) - 100}) < 80 ? 1.f : 0.f;
  }
  const FreeField canvas(make_mask_canvas(coverage), PieceSettings{});
  const EdgeDistance fine(canvas);
  const CanvasField field = coarse(fine, 60, 60, {-5, -5});
  const EdgeDistance edge(field, kNode_px);
  expect_alike(fine, edge, -4, 104);
  EXPECT_NEAR(edge.at({50, 50}).value, 40, 1.5f);
  EXPECT_NEAR(edge.at({70, 50}).gradient.x, -1, 0.1f) << "px a px, not a node";
}

TEST_F(CoarseEdge, BeyondTheNodesItFallsByTheWay) {
  const FreeField canvas = rectangle(100);
  const CanvasField field = coarse(EdgeDistance(canvas), 60, 60, {-5, -5});
  const EdgeDistance edge(field, kNode_px);
  const float at_last = edge.at({107.9f, 50}).value;
  const FieldSample beyond = edge.at({138, 50});
  EXPECT_NEAR(beyond.value, at_last - 30, 0.5f);
  EXPECT_NEAR(beyond.gradient.x, -1, 1e-4f);
  EXPECT_NEAR(edge.at({-50, -40}).value, edge.at({-10, -10}).value - 50, 0.5f);
}

/// If the angle is fixed, the best step is not the free step without its turn: the other movements must be optimised together.
TEST(RelaxationStep, AtABoundTheOtherMovementsAreTheBestThatGoWithIt) {
  EXPECT_TRUE(rc::check([] {
    constexpr float kStiffness = 2;
    const Similarity at = pose(50, 0, {0, 0});
    RelaxationStep step(at);
    struct Sample {
      Contact contact;
      float depth_px;
    };
    std::vector<Sample> samples;
    const int count = *rc::gen::inRange(1, 6);
    for (int k = 0; k < count; ++k) {
      const float angle = any_number(0, 6);
      const Vec2 where{any_number(-40, 40), any_number(-40, 40)};
      samples.push_back({{where, -1, {std::cos(angle), std::sin(angle)}, 3}, any_number(0, 3)});
      step.add_own(samples.back().contact, samples.back().depth_px, kStiffness);
    }
    step.add_growth();
    step.add_damping(kStiffness);
    const auto value = [&](const PieceMovement& m) {
      double sum =
          -2. * 50 * m.growth +
          0.5 * kStiffness * (m.shift_x * m.shift_x + m.shift_y * m.shift_y + m.turn * m.turn + m.growth * m.growth);
      for (const auto& [c, depth_px] : samples) {
        const Vec2 arm = c.at * (1 / 50.f);
        const Vec2 way = Vec2{m.shift_x, m.shift_y} + Vec2{-arm.y, arm.x} * m.turn + arm * m.growth;
        const double depth = depth_px - dot(way, c.gradient);
        sum += 0.5 * kStiffness * c.length_px * (depth * depth + depth_px * depth_px * m.growth / 50);
      }
      return sum;
    };
    const PoseRange free{1, 1000, {}};
    const PoseRange fixed_angle{1, 1000, direction_range(0, 0)};
    const PoseRange both_fixed{50, 50, direction_range(0, 0)};
    const PieceMovement all = step.solved(at, free);
    const PieceMovement upright = step.solved(at, fixed_angle);
    const PieceMovement shifted = step.solved(at, both_fixed);
    RC_ASSERT(upright.turn == 0.f);
    RC_ASSERT(shifted.turn == 0.f && shifted.growth == 0.f);
    RC_ASSERT(value(all) <= value(upright) + 1e-3);
    RC_ASSERT(value(upright) <= value(shifted) + 1e-3);
    for (const float by : {-0.1f, 0.1f}) {
      PieceMovement other = upright;
      other.shift_x += by;
      RC_ASSERT(value(upright) < value(other));
      other = upright;
      other.growth += by;
      RC_ASSERT(value(upright) < value(other));
    }
  }));
}

float gap_of_discs(const RelaxedPiece& a, const RelaxedPiece& b, Vec2 offset = {}) {
  const Vec2 way = b.canvas_from_shape.translation() + offset - a.canvas_from_shape.translation();
  return norm(way) - kDiscRadius * (a.canvas_from_shape.scale() + b.canvas_from_shape.scale());
}

/// The pieces cannot grow; they can only push each other away.
constexpr RelaxationSchedule kPushApart{60, 5, 5, 2, 0.1f, 0, false};

TEST(Relaxation, OverlappingDiscsSeparateToThePadding) {
  const FreeField canvas = rectangle(300);
  const PoseRange same_size{40, 40, {}};
  for (const float padding_px : {0.f, 4.f}) {
    std::vector<RelaxedPiece> pieces{piece(kDisc, pose(40, 0, {140, 150}), same_size),
                                     piece(kDisc, pose(40, 1, {165, 160}), same_size)};
    ASSERT_LT(gap_of_discs(pieces[0], pieces[1]), -15);
    Relaxation(canvas, {padding_px, padding_px}).relax(pieces, all_of(pieces), kPushApart, do_not_look);
    EXPECT_NEAR(gap_of_discs(pieces[0], pieces[1]), padding_px, 0.2) << padding_px;
  }
}

/// The padding is wider than pieces move between two searches for neighbours. That far out, fields see less than is there.
TEST(Relaxation, WidePaddingIsFelt) {
  const FreeField canvas = rectangle(300);
  const PoseRange same_size{40, 40, {}};
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(40, 0, {140, 150}), same_size),
                                   piece(kDisc, pose(40, 1, {165, 160}), same_size)};
  Relaxation(canvas, {30, 30}).relax(pieces, all_of(pieces), kPushApart, do_not_look);
  EXPECT_GT(gap_of_discs(pieces[0], pieces[1]), 29.8);
  EXPECT_LT(gap_of_discs(pieces[0], pieces[1]), 36);
}

TEST(Relaxation, ADiscInASquareGrowsToTouchItsSides) {
  const FreeField canvas = rectangle(100);
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(30, 0, {35, 60}), {10, 500, {}})};
  Relaxation(canvas, {0, -1}).relax(pieces, {0}, {200, 5, 5, 2, 0.2f}, do_not_look);
  const Similarity& at = pieces[0].canvas_from_shape;
  EXPECT_NEAR(at.tx, 50, 0.5);
  EXPECT_NEAR(at.ty, 50, 0.5);
  EXPECT_GT(at.scale() * kDiscRadius, 50);
  // The disc is held back only where it crosses the sides, so it grows a little further than a square would.
  EXPECT_LT(at.scale() * kDiscRadius, 52);
}

TEST(Relaxation, APieceThatStrayedOffTheCanvasComesBack) {
  const FreeField canvas = rectangle(100);
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(20, 0, {-40, 130}))};
  Relaxation(canvas, {0, -1}).relax(pieces, {0}, {200, 5, 5, 2, 0.2f, 0, false}, do_not_look);
  const Similarity& at = pieces[0].canvas_from_shape;
  EXPECT_GT(at.tx, 0.9f * kDiscRadius * at.scale());
  EXPECT_LT(at.ty, 100 - 0.9f * kDiscRadius * at.scale());
}

TEST(Relaxation, PiecesMeetAcrossASeam) {
  const FreeField canvas = seamless(200, true, false);
  const PoseRange same_size{40, 40, {}};
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(40, 0, {185, 100}), same_size),
                                   piece(kDisc, pose(40, 0, {15, 104}), same_size)};
  ASSERT_LT(gap_of_discs(pieces[0], pieces[1], {200, 0}), -14);
  Relaxation(canvas, {0, -1}).relax(pieces, all_of(pieces), kPushApart, do_not_look);
  EXPECT_NEAR(gap_of_discs(pieces[0], pieces[1], {200, 0}), 0, 0.2);
  // A single piece across the seam stays where it is, because there is no edge.
  std::vector<RelaxedPiece> alone{piece(kDisc, pose(40, 0, {199, 100}), same_size)};
  Relaxation(canvas, {0, -1}).relax(alone, {0}, kPushApart, do_not_look);
  EXPECT_NEAR(alone[0].canvas_from_shape.tx, 199, 1e-3);
}

TEST(Relaxation, CentresStayInOnePeriod) {
  const FreeField canvas = seamless(kCanvas_px, true, true);
  EXPECT_TRUE(rc::check([&] {
    std::vector<RelaxedPiece> pieces = any_pieces(kCanvas_px);
    Relaxation(canvas, {0, -1}).relax(pieces, all_of(pieces), kShort, do_not_look);
    for (const RelaxedPiece& p : pieces) {
      RC_ASSERT(canvas.grid().period().wrapped(p.canvas_from_shape) == p.canvas_from_shape);
    }
  }));
}

TEST(Relaxation, APieceThatIsAloneFillsThePeriodUpToItsOwnImages) {
  const FreeField canvas = seamless(100, true, true);
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(60, 0, {20, 30}), {10, 500, {}})};
  Relaxation(canvas, {0, -1}).relax(pieces, {0}, {200, 5, 5, 2, 0.2f}, do_not_look);
  EXPECT_GT(pieces[0].canvas_from_shape.scale() * kDiscRadius, 50);
  EXPECT_LT(pieces[0].canvas_from_shape.scale() * kDiscRadius, 52);
}

TEST(Relaxation, TheOrderOfTheActiveChangesNoBit) {
  const FreeField canvas = rectangle();
  EXPECT_TRUE(rc::check([&] {
    std::vector<RelaxedPiece> pieces = any_pieces(kCanvas_px);
    std::vector<RelaxedPiece> same = pieces;
    std::vector<std::size_t> reversed = all_of(pieces);
    std::reverse(reversed.begin(), reversed.end());
    const Relaxation relaxation(canvas, {0, -1});
    relaxation.relax(pieces, all_of(pieces), kShort, do_not_look);
    relaxation.relax(same, reversed, kShort, do_not_look);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      RC_ASSERT(pieces[i].canvas_from_shape == same[i].canvas_from_shape);
    }
  }));
}

TEST(Relaxation, WhereLookThrowsPiecesAreAsTheyWere) {
  const FreeField canvas = rectangle();
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(40, 0, {70, 70})), piece(kDisc, pose(40, 0, {80, 70}))};
  int looks = 0;
  const auto throw_later = [&] {
    if (++looks == 3) throw std::runtime_error("stop");
  };
  EXPECT_THROW(Relaxation(canvas, {0, -1}).relax(pieces, {0, 1}, kShort, throw_later), std::runtime_error);
  EXPECT_EQ(pieces[0].canvas_from_shape, pose(40, 0, {70, 70}));
}

}  // namespace test_relaxation
}  // namespace tessera
