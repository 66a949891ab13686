// Pieces that move, turn and scale together, and how they become ones that may stand.
#include "core/relax/relaxation.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numeric>

#include "core/collage/clearing.h"
#include "core/relax/relaxation_step.h"
#include "core/relax/schedules.h"
#include "support/polygon_distance.h"
#include "support/synthetic_shapes.h"

namespace tessera {
namespace {

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{
      test::make_test_shape("disc", test::disc_outline()), test::make_test_shape("bean", test::bean_outline()),
      test::make_test_shape("star", test::star_outline(5)), test::make_test_shape("ring", test::ring_outline(0.6f)),
      test::make_test_shape("blob", test::blob_outline(3))};
  return all;
}

const std::vector<ContactShape>& contact_shapes() {
  static const std::vector<ContactShape> all = [] {
    std::vector<ContactShape> made;
    for (const Shape& shape : shapes()) made.push_back(make_contact_shape(shape));
    return made;
  }();
  return all;
}

constexpr std::size_t kDisc = 0;
const float kDiscRadius = 1 / std::sqrt(std::numbers::pi_v<float>);  // of the disc of unit area

const auto do_not_look = [] {};

Similarity pose(float scale_px, float angle_rad, Vec2 centre) {
  return {scale_px * std::cos(angle_rad), scale_px * std::sin(angle_rad), centre.x, centre.y};
}

RelaxedPiece piece(std::size_t shape, const Similarity& where, const PoseRange& poses = {10, 60, {}}) {
  return {&contact_shapes()[shape], where, poses};
}

std::vector<std::size_t> all_of(const std::vector<RelaxedPiece>& pieces) {
  std::vector<std::size_t> all(pieces.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  return all;
}

float any_number(int low, int high) { return 0.01f * float(*rc::gen::inRange(100 * low, 100 * high)); }

/// One in each of 14 of the 16 cells of a canvas of this width: they overlap each other and the edge.
std::vector<RelaxedPiece> any_pieces(float canvas_px) {
  std::vector<RelaxedPiece> pieces;
  for (int k = 0; k < 14; ++k) {
    const float scale = any_number(20, 45);
    const float angle = any_number(0, 6);
    const Vec2 cell{float(k % 4) + any_number(0, 1), float(k / 4) + any_number(0, 1)};
    pieces.push_back(
        piece(*rc::gen::inRange<std::size_t>(0, shapes().size()), pose(scale, angle, cell * (canvas_px / 4))));
  }
  return pieces;
}

constexpr int kCanvas_px = 150;

FreeField rectangle(int size_px = kCanvas_px) { return {make_rectangle_canvas(size_px, size_px), PieceSettings{}}; }
FreeField seamless(int size_px, bool in_x, bool in_y) {
  return {make_seamless_canvas(size_px, size_px, in_x, in_y), PieceSettings{}};
}

constexpr RelaxationSchedule kShort{25, 0.5f, 5, 3, 0.3f};

/// Where a pose is after a movement along one of the four, by this many px; written with sines, unlike the code.
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
    RC_PRE(std::abs(at.scale() - 27) > 0.1f);  // where samples become denser
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
      // Fields are bilinear: their gradient jumps from cell to cell.
      RC_ASSERT(std::abs(difference - gradient[direction]) < 0.02 * size + 0.5);
    }
  }));
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
      // Of a piece whose samples become denser or sparser the energy jumps a little.
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

/// The best step of a piece whose angle is fixed is not that of a free one, less the turn.
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

/// They cannot grow: a hard push is all there is.
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

/// Farther than pieces move between two looks for neighbours. So far out fields see less than there is.
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
  // Only where the disc crosses the sides is it held back, so it goes a little farther than a square would.
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
  // Where it stands alone, a piece across the seam stays where it is: there is no edge.
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

/// By the rule that the master asks before it places a piece, with all others in the free field.
std::size_t conflicts_among(const std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& dropped,
                            const Canvas& canvas, const PieceSettings& settings) {
  const auto is_dropped = [&](std::size_t i) { return std::count(dropped.begin(), dropped.end(), i) > 0; };
  const auto shape_of = [&](std::size_t i) -> const Shape& {
    return shapes()[std::size_t(pieces[i].shape - contact_shapes().data())];
  };
  std::size_t conflicts = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (is_dropped(i)) continue;
    FreeField free(canvas, settings);
    PlacedOutlines others(free, settings);
    for (std::size_t j = 0; j < pieces.size(); ++j) {
      if (j == i || is_dropped(j)) continue;
      others.add({ShapeId{}, pieces[j].canvas_from_shape}, shape_of(j).outline);
      free.stamp(shape_of(j), pieces[j].canvas_from_shape);
    }
    conflicts += others.conflicts(shape_of(i), pieces[i].canvas_from_shape).size();
  }
  return conflicts;
}

TEST(Clearing, LeavesNoConflictWhateverTheRule) {
  const Canvas canvas = make_rectangle_canvas(kCanvas_px, kCanvas_px);
  const Canvas tube = make_seamless_canvas(kCanvas_px, kCanvas_px, true, false);
  EXPECT_TRUE(rc::check([&] {
    PieceSettings settings;
    settings.padding_px = *rc::gen::element(0.f, 2.f);
    settings.overlap_px = *rc::gen::element(0.f, 0.0005f, 1.4f);
    settings.max_scale_px = 60;
    const Canvas& where = **rc::gen::element(&canvas, &tube);
    std::vector<RelaxedPiece> pieces = any_pieces(kCanvas_px);
    pieces.resize(8);
    const FreeField free(where, settings);
    Relaxation(free, contact_distances(settings)).relax(pieces, all_of(pieces), kShort, do_not_look);
    const std::vector<std::size_t> dropped = make_clear(pieces, all_of(pieces), free, settings, do_not_look);
    RC_TAG(dropped.size());
    RC_ASSERT(dropped.size() < pieces.size() / 2);
    RC_ASSERT(conflicts_among(pieces, dropped, where, settings) == 0u);
    for (const RelaxedPiece& p : pieces) RC_ASSERT(p.poses.contains(p.canvas_from_shape));
  }));
}

TEST(Clearing, APieceWithoutRoomBetweenFixedOnesIsReported) {
  const PieceSettings settings;
  std::vector<RelaxedPiece> pieces;
  for (const float x : {80.f, 100.f, 120.f}) pieces.push_back(piece(kDisc, pose(40, 0, {x, 100}), {40, 40, {}}));
  for (const std::size_t i : {0u, 2u}) pieces[i].fixed = true;
  const Canvas slit = [] {
    Grid<float> coverage(400, 400, 0.f);
    for (int y = 150; y < 250; ++y) {
      for (int x = 80; x < 320; ++x) coverage(x, y) = 1;
    }
    return make_mask_canvas(coverage);
  }();
  const FreeField free(slit, settings);
  const std::vector<std::size_t> dropped = make_clear(pieces, {0, 1, 2}, free, settings, do_not_look);
  EXPECT_EQ(dropped, std::vector<std::size_t>{1});
  EXPECT_EQ(pieces[0].canvas_from_shape, pose(40, 0, {80, 100}));
}

/// Steps of shrinking are coarse, and of several that made way for each other the last did so for nothing.
TEST(Clearing, APieceIsAsLargeAsTheOutlinesAllow) {
  const PieceSettings settings;
  const FreeField square = rectangle(100);
  const float largest_px = (50 + settings.overlap_px) / kDiscRadius;
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(1.02f * largest_px, 0, {50, 50}), {10, 500, {}})};
  EXPECT_EQ(make_clear(pieces, {0}, square, settings, do_not_look), std::vector<std::size_t>{});
  EXPECT_GT(pieces[0].canvas_from_shape.scale(), 0.998f * largest_px);
}

/// Growing is not its task: nobody would hold a piece back that lies alone.
TEST(Clearing, APieceBecomesHardlyLargerThanItWas) {
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(30, 0, {50, 50}), {10, 500, {}})};
  make_clear(pieces, {0}, rectangle(100), {}, do_not_look);
  EXPECT_LT(pieces[0].canvas_from_shape.scale(), 30.101f);
}

TEST(BoundarySamples, LengthsAddUpAndStepsAreBounded) {
  for (const Shape& shape : shapes()) {
    const BoundarySamples samples = sample_boundary(shape.outline, 0.05f, 0.006f);
    float length = 0;
    for (const BoundarySample& s : samples.samples) {
      length += s.length;
      EXPECT_LT(test::boundary_distance({{{s.position}}}, shape.outline), 1e-5) << shape.name;
    }
    EXPECT_NEAR(length, shape.perimeter, 1e-3 * shape.perimeter) << shape.name;
    EXPECT_LE(samples.longest_step, 0.05f) << shape.name;
    ASSERT_EQ(samples.curve_ends.size(), shape.outline.curves.size());
    EXPECT_EQ(samples.curve_ends.back(), samples.samples.size());
  }
}

}  // namespace
}  // namespace tessera
