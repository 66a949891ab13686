// Replacement trials in a window.
#include "core/base/stop.h"
#include "core/replacing/window_trials.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/quality/quality.h"
#include "core/relax/schedules.h"
#include "core/replaced_pieces.h"
#include "core/replacing/repetition.h"
#include "core/replacing/scene.h"

namespace tessera {
namespace test_window_trials {

using namespace replaced_pieces;
using relaxed_pieces::any_number;
using relaxed_pieces::kDisc;
using relaxed_pieces::kDiscRadius;
using relaxed_pieces::pose;

/// The outcome of the window's trials, computed on one thread.
ReplacementOutcome outcome_of(const ReplacementWindow& window, const StopCheck& check_stop = never_stop) {
  TaskPool alone(1);
  return replaced(window, shapes_by_id(), check_stop, alone);
}

/// Disordered pieces: some stand still, some cross the edges of the window.
ReplacementWindow any_window() {
  ReplacementWindow window = empty_window();
  const float soft_px = *rc::gen::element(0.f, 3.f);
  window.distances = {soft_px, soft_px - 1};
  window.box = *rc::gen::element(window.box, Box{{25, 15}, {190, 180}});
  const float around_rad = any_number(-3, 3);
  const float width_rad = *rc::gen::element(0.4f, 7.f);
  const PoseRange poses{20, 60, direction_range(around_rad - width_rad / 2, around_rad + width_rad / 2)};
  const std::size_t still = *rc::gen::inRange<std::size_t>(0, 5);
  for (const RelaxedPiece& p : relaxed_pieces::any_pieces(kCanvas_px)) {
    const std::size_t shape = std::size_t(p.shape - relaxed_pieces::contact_shapes().data());
    WindowPiece piece = window_piece(shape, p.canvas_from_shape, poses);
    poses.pull_in(piece.canvas_from_shape);
    (window.still.size() < still ? window.still : window.moving).push_back(piece);
  }
  for (IncomingShape& in : window.incoming) in.poses = poses;
  count_drawn(window);
  window.repetition.area = *rc::gen::element(0., 0.05);
  window.repetition.nearness = *rc::gen::element(0., 0.3);
  window.repetition.reach_sizes = 2;
  window.random = *rc::gen::arbitrary<std::uint64_t>();
  window.trials = 12;
  window.first_temperature_px2 = *rc::gen::element(0.f, 100.f);
  return window;
}

Scene scene_of(const ReplacementWindow& window, const std::vector<ReplacedPiece>& pieces) {
  Scene scene;
  for (const ReplacedPiece& p : pieces) scene.add(*shapes_by_id().at(p.shape), p.canvas_from_shape, {}, true);
  for (const WindowPiece& p : window.still) scene.add(*shapes_by_id().at(p.shape), p.canvas_from_shape, p.poses, false);
  return scene;
}

std::vector<ReplacedPiece> before(const ReplacementWindow& window) {
  std::vector<ReplacedPiece> pieces;
  for (std::uint32_t i = 0; i < window.moving.size(); ++i) {
    pieces.push_back({window.moving[i].shape, window.moving[i].canvas_from_shape, i});
  }
  return pieces;
}

Quality quality_of(const ReplacementWindow& window, const std::vector<ReplacedPiece>& pieces) {
  std::vector<Placement> placements;
  for (const ReplacedPiece& p : pieces) placements.push_back({p.shape, p.canvas_from_shape});
  for (const WindowPiece& p : window.still) placements.push_back({p.shape, p.canvas_from_shape});
  return measure_quality(make_rectangle_canvas(kCanvas_px, kCanvas_px), placements,
                         [](ShapeId id) -> const Shape& { return relaxed_pieces::shapes()[index_of(id)]; });
}

/// Returns whether the piece is where it was before.
bool is_unchanged(const ReplacedPiece& piece, const ReplacementWindow& window) {
  return piece.from != ReplacedPiece::kNew && piece.canvas_from_shape == window.moving[piece.from].canvas_from_shape;
}

TEST(WindowTrials, TheSameQuestionHasTheSameAnswer) {
  EXPECT_TRUE(rc::check([] {
    const ReplacementWindow window = any_window();
    RC_ASSERT(outcome_of(window) == outcome_of(window));
  }));
}

TEST(WindowTrials, OtherNumbersGiveOtherAnswers) {
  ReplacementWindow window = empty_window();
  window.moving = discs_round_a_hole();
  const ReplacementOutcome first = outcome_of(window);
  window.random = 8;
  EXPECT_NE(outcome_of(window), first);
}

TEST(WindowTrials, OldPiecesComeFirstInTheirOrderAndThoseThatStandStillNotAtAll) {
  std::size_t kept = 0;
  EXPECT_TRUE(rc::check([&] {
    const ReplacementWindow window = any_window();
    const ReplacementOutcome outcome = outcome_of(window);
    kept += outcome.kept;
    RC_ASSERT(outcome.kept <= window.trials);
    std::uint32_t next = 0;
    bool is_new = false;
    for (const ReplacedPiece& p : outcome.pieces) {
      is_new |= p.from == ReplacedPiece::kNew;
      RC_ASSERT(is_new == (p.from == ReplacedPiece::kNew));
      for (const WindowPiece& s : window.still) RC_ASSERT(p.canvas_from_shape != s.canvas_from_shape);
      if (is_new) continue;
      RC_ASSERT(p.from >= next);
      RC_ASSERT(p.shape == window.moving.at(p.from).shape);
      next = p.from + 1;
    }
  }));
  EXPECT_GT(kept, 20u);
}

TEST(WindowTrials, PosesStayInTheirRange) {
  EXPECT_TRUE(rc::check([] {
    ReplacementWindow window = any_window();
    for (WindowPiece& p : window.moving) {
      const float scale_px = p.canvas_from_shape.scale();
      p.poses.min_scale_px = scale_px / *rc::gen::element(1.f, 1.1f);
      p.poses.max_scale_px = scale_px * *rc::gen::element(1.f, 1.1f);
    }
    for (IncomingShape& in : window.incoming) in.poses.max_scale_px = float(*rc::gen::inRange(25, 50));
    for (const ReplacedPiece& p : outcome_of(window).pieces) {
      const bool is_new = p.from == ReplacedPiece::kNew;
      const PoseRange& poses = is_new ? window.incoming[index_of(p.shape)].poses : window.moving[p.from].poses;
      RC_ASSERT(poses.contains(p.canvas_from_shape));
    }
  }));
}

/// A piece may move if it is inside by half the distance at which pieces feel each other.
TEST(WindowPieces, MayMoveThatAreFarEnoughInside) {
  const FreeField free = relaxed_pieces::rectangle(kCanvas_px);
  ReplacementWindow window = empty_window();
  window.box = {{50, 50}, {150, 150}};
  window.distances = {20, 19};
  constexpr float kRadius_px = 15;
  const auto may_move = [&](Vec2 centre) {
    window.moving = {window_piece(kDisc, pose(kRadius_px / kDiscRadius, 0, centre))};
    return WindowPieces(window, shapes_by_id(), EdgeDistance(free)).may_move(0);
  };
  EXPECT_TRUE(may_move(kMiddle));
  for (const Vec2 side : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
    EXPECT_TRUE(may_move(kMiddle + side * (50 - 10 - kRadius_px - 0.5f)));
    EXPECT_FALSE(may_move(kMiddle + side * (50 - 10 - kRadius_px + 0.5f)));
  }
  window.still = {window_piece(kDisc, pose(30, 0, kMiddle))};
  EXPECT_FALSE(WindowPieces(window, shapes_by_id(), EdgeDistance(free)).may_move(1)) << "it stands still";
}

/// Otherwise changes in neighbouring windows at the same time could collide.
TEST(WindowTrials, WhatChangedLiesWithinTheWindow) {
  std::size_t changed = 0;
  EXPECT_TRUE(rc::check([&] {
    const ReplacementWindow window = any_window();
    const float inside_px = 0.5f * std::max(0.f, window.distances.soft_px);
    constexpr float kSlack_px = 0.6f;  // an outline reaches slightly beyond its samples
    for (const ReplacedPiece& p : outcome_of(window).pieces) {
      if (is_unchanged(p, window)) continue;
      ++changed;
      RC_ASSERT(holds(window.box, box_of(p.shape, p.canvas_from_shape), inside_px - kSlack_px));
    }
  }));
  EXPECT_GT(changed, 30u);
}

TEST(WindowTrials, PiecesThatAreNotWhollyInTheWindowStayAsTheyAre) {
  std::size_t across = 0;
  EXPECT_TRUE(rc::check([&] {
    const ReplacementWindow window = any_window();
    const std::vector<ReplacedPiece> pieces = outcome_of(window).pieces;
    for (std::uint32_t i = 0; i < window.moving.size(); ++i) {
      const WindowPiece& piece = window.moving[i];
      if (holds(window.box, box_of(piece.shape, piece.canvas_from_shape), 0)) continue;
      ++across;
      const ReplacedPiece expected{piece.shape, piece.canvas_from_shape, i};
      RC_ASSERT(std::count(pieces.begin(), pieces.end(), expected) == 1);
    }
  }));
  EXPECT_GT(across, 10u);
}

/// A trial computes the energy of some pieces. A gain there is a gain for all pieces.
TEST(WindowTrials, ColdTrialsNeverRaiseTheEnergyOfTheWhole) {
  EXPECT_TRUE(rc::check([] {
    ReplacementWindow window = any_window();
    window.first_temperature_px2 = 0;
    const SceneRelaxation relaxation(window);
    const auto energy_px2 = [&](const std::vector<ReplacedPiece>& pieces) {
      Repetition repetition(window);
      const double start_px2 = repetition.energy_px2();
      for (const WindowPiece& p : window.moving) repetition.remove(placed_drawing(p.drawing, p.canvas_from_shape));
      for (const ReplacedPiece& p : pieces) repetition.add(placed_drawing(p.shape, p.canvas_from_shape));
      return relaxation.energy_px2(scene_of(window, pieces)) + repetition.energy_px2() - start_px2;
    };
    const double old_px2 = energy_px2(before(window));
    const ReplacementOutcome outcome = outcome_of(window);
    const double new_px2 = energy_px2(outcome.pieces);
    RC_LOG() << old_px2 << " to " << new_px2 << " by " << outcome.kept << " trials\n";
    RC_ASSERT(new_px2 <= old_px2 + 1e-4 * std::abs(old_px2));
    if (outcome.kept > 0) RC_ASSERT(new_px2 < old_px2);
  }));
}

TEST(WindowTrials, ColdTrialsCoverMoreAndNotTwice) {
  double gained = 0;
  EXPECT_TRUE(rc::check([&] {
    ReplacementWindow window = any_window();
    window.distances = {0, -1};
    window.box = empty_window().box;
    window.repetition = {};
    window.first_temperature_px2 = 0;
    window.trials = 15;
    const Quality old = quality_of(window, before(window));
    const Quality now = quality_of(window, outcome_of(window).pieces);
    RC_ASSERT(now.coverage - now.overlap - now.outside > old.coverage - old.overlap - old.outside - 0.02);
    gained += now.coverage - now.overlap - old.coverage + old.overlap;
  }));
  EXPECT_GT(gained, 0.2) << "of 8 canvases";
}

double area_px2(const std::vector<ReplacedPiece>& pieces) {
  double sum = 0;
  for (const ReplacedPiece& p : pieces) sum += std::pow(p.canvas_from_shape.scale(), 2);
  return sum;
}

/// The moving pieces whose outlines hold the point.
std::vector<ReplacedPiece> pieces_over(Vec2 p, const std::vector<ReplacedPiece>& pieces) {
  std::vector<ReplacedPiece> over;
  for (const ReplacedPiece& piece : pieces) {
    if (laid(index_of(piece.shape), piece.canvas_from_shape).distance(p).value < 0) over.push_back(piece);
  }
  return over;
}

TEST(WindowTrials, AnEmptyPlaceIsFilled) {
  ReplacementWindow window = empty_window();
  window.moving = discs_round_a_hole();
  window.incoming.resize(1);  // discs
  window.trials = 40;
  const std::vector<ReplacedPiece> pieces = outcome_of(window).pieces;
  EXPECT_GT(area_px2(pieces), area_px2(before(window)) + 0.9 * kDiscScale_px * kDiscScale_px);
  EXPECT_EQ(pieces_over(kMiddle, pieces).size(), 1u);
  EXPECT_LT(quality_of(window, pieces).overlap, 0.01);
}

/// No piece around the hole makes room, but the incoming piece feels them.
TEST(WindowTrials, AnEmptyPlaceAmongPiecesThatStandStillIsFilled) {
  ReplacementWindow window = empty_window();
  window.still = discs_round_a_hole();
  window.incoming.resize(1);
  window.trials = 1;
  int filled = 0;
  for (window.random = 0; window.random < 150; ++window.random) {
    const std::vector<ReplacedPiece> pieces = outcome_of(window).pieces;
    if (pieces.empty()) continue;
    ++filled;
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].from, ReplacedPiece::kNew);
    EXPECT_LT(norm(pieces[0].canvas_from_shape.translation() - kMiddle), 2);
    EXPECT_NEAR(pieces[0].canvas_from_shape.scale(), kDiscScale_px, 2);
  }
  EXPECT_GT(filled, 0);
}

TEST(WindowTrials, PiecesGrowIntoAPlaceThatMayNotBeFilled) {
  ReplacementWindow window = empty_window();
  window.moving = discs_round_a_hole();
  window.incoming.resize(1);
  window.incoming[0].poses.min_scale_px = 45;  // too large for the hole
  window.trials = 30;
  const ReplacementOutcome outcome = outcome_of(window);
  EXPECT_GT(quality_of(window, outcome.pieces).coverage, quality_of(window, before(window)).coverage);
}

TEST(WindowTrials, WithoutTrialsNothingChanges) {
  ReplacementWindow window = empty_window();
  window.moving = discs_round_a_hole();
  window.trials = 0;
  const ReplacementOutcome outcome = outcome_of(window);
  EXPECT_EQ(outcome.kept, 0u);
  EXPECT_EQ(outcome.pieces, before(window));
}

TEST(WindowTrials, WhereNothingComesInNothingChanges) {
  ReplacementWindow window = empty_window();
  window.moving = discs_round_a_hole();
  const std::vector<ReplacedPiece> as_before = before(window);
  for (IncomingShape& in : window.incoming) in.weight = 0;
  EXPECT_EQ(outcome_of(window).pieces, as_before);
  window.incoming.clear();
  EXPECT_EQ(outcome_of(window).pieces, as_before);
}

TEST(WindowTrials, WhereRepetitionCostsMuchOtherDrawingsComeIn) {
  ReplacementWindow window = empty_window();
  window.moving = discs_round_a_hole();
  window.trials = 30;
  const auto times_of = [&](std::size_t shape) {
    std::ptrdiff_t times = 0;
    for (window.random = 0; window.random < 3; ++window.random) {
      const std::vector<ReplacedPiece> pieces = outcome_of(window).pieces;
      times += std::count_if(pieces.begin(), pieces.end(),
                             [&](const ReplacedPiece& p) { return index_of(p.shape) == shape; });
    }
    return times;
  };
  count_drawn(window);
  const std::ptrdiff_t discs_cheap = times_of(kDisc);
  window.repetition.area = 0.3;
  EXPECT_LT(times_of(kDisc), discs_cheap);
  ASSERT_GT(times_of(1), 0);
  window.repetition.area = 0.5;
  window.drawn[1].area_px2 = 1e6;
  EXPECT_EQ(times_of(1), 0) << "worth nothing";
}

/// Copies outside the window count if they are near.
TEST(WindowTrials, NextToACopyOtherDrawingsComeIn) {
  ReplacementWindow window = empty_window();
  window.moving = discs_round_a_hole();
  count_drawn(window);
  window.trials = 30;
  window.repetition.nearness = 1;
  window.repetition.reach_sizes = 5;
  const auto stars = [&] {
    std::ptrdiff_t count = 0;
    for (window.random = 0; window.random < 3; ++window.random) {
      const std::vector<ReplacedPiece> pieces = outcome_of(window).pieces;
      count += std::count_if(pieces.begin(), pieces.end(), [](const auto& p) { return index_of(p.shape) == 1; });
    }
    return count;
  };
  window.elsewhere = {{ShapeId{1}, kMiddle + Vec2{5000, 0}, 60}};
  const std::ptrdiff_t far = stars();
  ASSERT_GT(far, 0);
  window.elsewhere = std::vector<PlacedDrawing>(6, {ShapeId{1}, kMiddle, 60});
  EXPECT_LT(stars(), far);
}

/// For example mirror images, which count as one drawing.
TEST(WindowTrials, ShapesOfOneDrawingAreRepetitionsOfEachOther) {
  ReplacementWindow window = empty_window();
  window.moving = discs_round_a_hole();
  count_drawn(window);
  window.trials = 60;
  window.repetition.area = 0.4;
  ASSERT_NE(outcome_of(window).pieces, before(window));
  for (IncomingShape& in : window.incoming) in.drawing = ShapeId{kDisc};
  count_drawn(window);
  for (const ReplacedPiece& p : outcome_of(window).pieces) {
    EXPECT_EQ(index_of(p.shape), kDisc) << "nothing is gained by another shape of as many pieces";
    if (p.from == ReplacedPiece::kNew) break;
  }
}

/// A window in which smaller stars replace discs of a fixed size, which is always a loss.
ReplacementWindow stars_for_discs() {
  ReplacementWindow window = empty_window();
  window.moving = discs_round_a_hole();
  window.moving.push_back(window_piece(kDisc, {kDiscScale_px, 0, kMiddle.x, kMiddle.y}));
  for (WindowPiece& piece : window.moving) piece.poses = {kDiscScale_px, kDiscScale_px, {}};
  window.incoming = {{ShapeId{2}, ShapeId{2}, {20, 25, {}}, 1}};
  return window;
}

TEST(WindowTrials, AsManyComeInAsGoOutAtMostWhereThereIsRoom) {
  ReplacementWindow window = stars_for_discs();
  window.trials = 1;
  window.first_temperature_px2 = 1e6f;
  std::array<int, 4> times_out{};
  bool two_for_two = false;
  for (window.random = 0; window.random < 60; ++window.random) {
    const ReplacementOutcome outcome = outcome_of(window);
    const auto is_new = [](const ReplacedPiece& p) { return p.from == ReplacedPiece::kNew; };
    const auto in = std::size_t(std::count_if(outcome.pieces.begin(), outcome.pieces.end(), is_new));
    const std::size_t out = window.moving.size() - (outcome.pieces.size() - in);
    ASSERT_LT(out, times_out.size());
    EXPECT_LE(in, std::max<std::size_t>(1, out));
    EXPECT_EQ(in > 0, outcome.kept == 1);
    times_out[out] += in > 0;
    two_for_two |= out == 2 && in == 2;
  }
  EXPECT_GT(times_out[1], 30) << "mostly one";
  EXPECT_GT(times_out[2], 0);
  EXPECT_TRUE(two_for_two);
}

TEST(WindowTrials, HotTrialsKeepLosses) {
  ReplacementWindow window = stars_for_discs();
  const auto kept = [&](float first_px2, float last_px2, std::uint32_t trials) {
    window.first_temperature_px2 = first_px2;
    window.last_temperature_px2 = last_px2;
    window.trials = trials;
    std::uint32_t sum = 0;
    for (window.random = 0; window.random < 4; ++window.random) sum += outcome_of(window).kept;
    return sum;
  };
  constexpr float kHot_px2 = 1e5f;
  constexpr float kWarm_px2 = 1000;  // about the size of such a loss
  EXPECT_EQ(kept(0, 0, 16), 0u);
  const std::uint32_t hot = kept(kHot_px2, kHot_px2, 16);
  EXPECT_GT(hot, 40u);
  const std::uint32_t warm = kept(kWarm_px2, kWarm_px2, 16);
  EXPECT_GT(warm, 5u);
  EXPECT_LT(warm, hot - 10);
  EXPECT_GT(kept(kHot_px2, 0, 4), 8u) << "it begins with the first temperature";
  EXPECT_GT(kept(0, kHot_px2, 16), 20u) << "and ends with the last";
  EXPECT_EQ(kept(0, kHot_px2, 1), 0u) << "the first trial has the first temperature";
}

TEST(WindowTrials, NoPieceComesToLieInAnother) {
  ReplacementWindow window = empty_window();
  for (int k = 0; k < 16; ++k) {
    const Vec2 at = Vec2{float(k % 4) + 0.5f, float(k / 4) + 0.5f} * 50.f;
    window.moving.push_back(window_piece(std::size_t(k % 5), pose(45, float(k), at)));
  }
  window.trials = 40;
  for (std::uint64_t random = 0; random < 2; ++random) {
    window.random = random;
    const std::vector<ReplacedPiece> pieces = outcome_of(window).pieces;
    for (const ReplacedPiece& p : pieces) {
      const std::vector<Vec2>& interior = hole_shapes()[index_of(p.shape)].interior;
      const auto covered = std::count_if(interior.begin(), interior.end(), [&](Vec2 point) {
        return pieces_over(p.canvas_from_shape.apply(point), pieces).size() > 1;
      });
      EXPECT_LT(covered, 0.15 * double(interior.size()));
    }
  }
}

TEST(WindowTrials, PaddingIsKeptNearly) {
  ReplacementWindow window = empty_window();
  PieceSettings settings;
  settings.padding_px = 3;
  window.distances = contact_distances(settings);
  for (WindowPiece disc : discs_round_a_hole()) {
    disc.canvas_from_shape.a -= 3;
    window.moving.push_back(disc);
  }
  window.trials = 50;
  const ReplacementOutcome outcome = outcome_of(window);
  EXPECT_GT(outcome.kept, 3u);
  const Quality q = quality_of(window, outcome.pieces);
  ASSERT_TRUE(q.between_px);
  EXPECT_GT(*q.between_px, 1.8);
  EXPECT_LT(q.overlap, 1e-9);
}

TEST(WindowTrials, WhatLookThrowsComesOut) {
  ReplacementWindow window = empty_window();
  window.moving = discs_round_a_hole();
  std::uint32_t looks = 0;
  const auto throw_at = [&](std::uint32_t look) {
    looks = 0;
    return [&looks, look] {
      if (++looks == look) throw std::runtime_error("stop");
    };
  };
  EXPECT_THROW(outcome_of(window, throw_at(1)), std::runtime_error);
  EXPECT_THROW(outcome_of(window, throw_at(window.trials)), std::runtime_error);
  EXPECT_NO_THROW(outcome_of(window, throw_at(window.trials + 1)));
  EXPECT_EQ(looks, window.trials) << "before each trial";
}

/// The energy of a scene without its depths.
double covered_twice_px2(const Scene& scene, const ReplacementWindow& window) {
  const FreeField free = relaxed_pieces::rectangle(kCanvas_px);
  constexpr float kStiffness = 8;
  constexpr float kHardStiffness = 20;
  const double depths_px2 =
      Relaxation(free, window.distances).energy_px2(scene.pieces, scene.active, kStiffness, kHardStiffness);
  return SceneRelaxation(window).energy_px2(scene) - depths_px2;
}

/// Each pair counts for both pieces, whichever of them moves. So the active pieces' energy changes as much as that of all.
TEST(SceneEnergy, CountsWhatIsCoveredTwice) {
  const ReplacementWindow window = empty_window();
  const auto pair_px2 = [&](float scale_px, float other_px, Vec2 apart, bool one_moves, bool other_moves) {
    Scene scene;
    scene.add(hole_shapes()[kDisc], pose(scale_px, 0, kMiddle), {}, one_moves);
    scene.add(hole_shapes()[kDisc], pose(other_px, 0, kMiddle + apart), {}, other_moves);
    return covered_twice_px2(scene, window);
  };
  constexpr float kSmall_px = 12;
  const double small_px2 = kSmall_px * kSmall_px;
  for (const auto& [one, other] : {std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
    EXPECT_NEAR(pair_px2(50, kSmall_px, {}, one, other), 2 * 2 * small_px2, 150);
    EXPECT_NEAR(pair_px2(50, 50, {}, one, other), 2 * 2 * 50. * 50, 4) << "there boundaries alone see nothing";
    EXPECT_NEAR(pair_px2(40, 40, {46, 0}, one, other), 0, 2);
  }
  EXPECT_EQ(pair_px2(50, kSmall_px, {}, true, false), pair_px2(50, kSmall_px, {}, true, true));
}

}  // namespace test_window_trials
}  // namespace tessera
