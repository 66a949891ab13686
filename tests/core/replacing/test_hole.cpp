// A hole between pieces, and the shapes that fit into it.
#include "core/replacing/hole.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include "core/matching/match_round.h"
#include "core/replaced_pieces.h"
#include "core/replacing/hole_candidates.h"

namespace tessera {
namespace test_hole {

using namespace replaced_pieces;
using relaxed_pieces::kDisc;
using relaxed_pieces::kDiscRadius;
using relaxed_pieces::pose;

/// The best candidates, computed on one thread.
std::vector<HoleCandidate> best(const Hole& hole, float reach_px, const std::vector<CandidateShape>& guests,
                                float softness, Draws& draws) {
  TaskPool alone(1);
  return best_candidates(hole, reach_px, guests, softness, draws, alone);
}

/// A corner of a canvas with two discs, whose distances are known exactly.
class HoleInACorner : public testing::Test {
 protected:
  static constexpr float kHalf_px = 70;
  static constexpr float kCell_px = 1.5f;
  static constexpr float kFar_px = 40;
  static constexpr float kRadius_px = 25;

  HoleInACorner() {
    for (const Vec2 centre : centres_) hole_.add(laid(kDisc, pose(kRadius_px / kDiscRadius, 1, centre)));
  }

  float free_px(Vec2 p) const {
    float distance = std::min({p.x, p.y, kCanvas_px - p.x, kCanvas_px - p.y});
    for (const Vec2 centre : centres_) distance = std::min(distance, norm(p - centre) - kRadius_px);
    return distance;
  }

  /// Returns whether a node is near; there the gradient jumps.
  static bool nodes_near(float at_px, float centre_px) {
    const float nodes = (at_px - centre_px + kHalf_px) / kCell_px;
    return std::abs(nodes - std::round(nodes)) < 0.05f;
  }

  const FreeField free_ = relaxed_pieces::rectangle(kCanvas_px);
  const EdgeDistance edge_{free_};
  const Vec2 centre_{50, 60};
  const std::vector<Vec2> centres_ = {{95, 50}, {40, 115}};
  Hole hole_{centre_, kHalf_px, kCell_px, edge_};
};

TEST_F(HoleInACorner, DistancesAreThoseToDiscsAndEdge) {
  for (float y = -3; y < 128; y += 3.7f) {
    for (float x = -3; x < 118; x += 3.3f) {
      const float expected = std::min(kFar_px, free_px({x, y}));
      if (std::max(x, y) < 3 || expected < -20) continue;  // beyond two edges, or near the middle of a disc
      EXPECT_LT(hole_.at({x, y}).value, expected + 0.8f) << x << ", " << y;
      // A shape's field ends at this distance. Beyond it the distance is a lower bound.
      constexpr float kOfAField_px = 0.15f * kRadius_px / 0.564f;
      const float least = expected < kOfAField_px ? expected - 0.8f : 0.6f * expected;
      EXPECT_GT(hole_.at({x, y}).value, least) << x << ", " << y;
    }
  }
}

TEST_F(HoleInACorner, ADistanceIsThatOfTheNearestWhoeverCameFirst) {
  Hole other(centre_, kHalf_px, kCell_px, edge_);
  for (auto centre = centres_.rbegin(); centre != centres_.rend(); ++centre) {
    other.add(laid(kDisc, pose(kRadius_px / kDiscRadius, 1, *centre)));
  }
  for (float x = -20; x < 130; x += 1.1f) EXPECT_EQ(hole_.at({x, 61}).value, other.at({x, 61}).value);
}

TEST_F(HoleInACorner, GradientIsThatOfTheValue) {
  for (float y = 5; y < 110; y += 7.3f) {
    for (float x = 5; x < 110; x += 6.7f) {
      constexpr float kStep_px = 0.01f;
      if (nodes_near(x, centre_.x) || nodes_near(y, centre_.y)) continue;
      const auto slope = [&](Vec2 by) {
        return (hole_.at(Vec2{x, y} + by).value - hole_.at(Vec2{x, y} - by).value) / (2 * kStep_px);
      };
      EXPECT_NEAR(hole_.at({x, y}).gradient.x, slope({kStep_px, 0}), 0.05f) << x << ", " << y;
      EXPECT_NEAR(hole_.at({x, y}).gradient.y, slope({0, kStep_px}), 0.05f) << x << ", " << y;
    }
  }
}

TEST_F(HoleInACorner, BeyondTheRasterItIsAsAtItsEdge) {
  EXPECT_NEAR(hole_.at({150, 110}).value, hole_.at({121, 110}).value, 0.01f);
  EXPECT_NEAR(hole_.at({-300, 50}).value, hole_.at({-20, 50}).value, 0.01f);
}

TEST_F(HoleInACorner, FreeIsWhatNothingCoversWithinReach) {
  for (const float reach_px : {20.f, 45.f, 65.f}) {
    constexpr float kStep_px = 0.25f;
    double expected_px2 = 0;
    for (float y = centre_.y - reach_px; y < centre_.y + reach_px; y += kStep_px) {
      for (float x = centre_.x - reach_px; x < centre_.x + reach_px; x += kStep_px) {
        expected_px2 += (norm(Vec2{x, y} - centre_) < reach_px && free_px({x, y}) > 0) * kStep_px * kStep_px;
      }
    }
    EXPECT_NEAR(hole_.free_px2(reach_px), expected_px2, 0.05 * expected_px2 + 20) << reach_px;
  }
}

TEST_F(HoleInACorner, RimPointsLieBesideWhatIsThereAndLookInward) {
  constexpr float kReach_px = 55;
  const std::vector<RimPoint> rim = hole_.rim(kReach_px);
  EXPECT_GT(rim.size(), 60u);
  bool at_edge = false, at_first = false, at_second = false;
  for (const RimPoint& r : rim) {
    EXPECT_LT(norm(r.at - centre_), kReach_px + kCell_px);
    EXPECT_NEAR(free_px(r.at), 0, 0.7f) << r.at.x << ", " << r.at.y;
    EXPECT_NEAR(norm(r.inward), 1, 1e-4f);
    EXPECT_GT(free_px(r.at + r.inward * 3), 1.2f) << r.at.x << ", " << r.at.y;
    at_edge |= std::min(r.at.x, r.at.y) < 1;
    at_first |= std::abs(norm(r.at - centres_[0]) - kRadius_px) < 1;
    at_second |= std::abs(norm(r.at - centres_[1]) - kRadius_px) < 1;
  }
  EXPECT_TRUE(at_edge && at_first && at_second) << "all that surrounds it";
}

TEST_F(HoleInACorner, TheRoomOfARimPointGoesToTheOtherSide) {
  constexpr float kReach_px = 40;
  int bounded = 0;
  for (const RimPoint& r : hole_.rim(kReach_px)) {
    float room_px = 3;
    while (room_px <= 2 * kReach_px && free_px(r.at + r.inward * room_px) > 0) room_px += 0.1f;
    // Where the path passes another piece at a slant, one px of distance is several px of the path.
    if (free_px(r.at + r.inward * (room_px + 4)) > -2 || room_px > 2 * kReach_px - 4) continue;
    EXPECT_NEAR(r.room_px, room_px, 4) << r.at.x << ", " << r.at.y;
    ++bounded;
  }
  EXPECT_GT(bounded, 15);
}

TEST_F(HoleInACorner, NoRoomIsSeenBeyondTwiceTheReach) {
  constexpr float kReach_px = 15;
  Hole open({100, 100}, 60, kCell_px, edge_);
  open.add(laid(kDisc, pose(30 / kDiscRadius, 0, {60, 100})));
  for (const RimPoint& r : open.rim(kReach_px)) EXPECT_LT(r.room_px, 2 * kReach_px + kFar_px);
  EXPECT_FALSE(open.rim(kReach_px).empty());
}

CandidateShape guest(std::size_t shape, const PoseRange& poses, float weight = 1, float worth = 1) {
  return {&hole_shapes()[shape], poses, weight, worth};
}

std::vector<CandidateShape> all_guests(const PoseRange& poses) {
  std::vector<CandidateShape> guests;
  for (std::size_t i = 0; i < hole_shapes().size(); ++i) guests.push_back(guest(i, poses));
  return guests;
}

constexpr float kReach_px = 40;
constexpr float kSoftness = 1.5f;

/// A hole with the outline of a shape in an otherwise covered plane.
class HoleOfAShape {
 public:
  HoleOfAShape(std::size_t shape, const Similarity& where)
      : field_(inside_of(laid(shape, where))),
        edge_(field_, 1),
        hole(where.translation(), 55, 1.5f, edge_) {}

  std::vector<HoleCandidate> candidates(const std::vector<CandidateShape>& guests, std::uint64_t random = 1) const {
    Draws draws(random);
    return best(hole, kReach_px, guests, kSoftness, draws);
  }

 private:
  static CanvasField inside_of(const ContactPiece& piece) {
    CanvasField field{Grid<float>(kCanvas_px, kCanvas_px), {0, 0}};
    for (int j = 0; j < kCanvas_px; ++j) {
      for (int i = 0; i < kCanvas_px; ++i) field.value(i, j) = -piece.distance({float(i), float(j)}).value;
    }
    return field;
  }

  CanvasField field_;
  EdgeDistance edge_;

 public:
  Hole hole;
};

/// Checks that hold for the candidates of every hole.
void check_candidates(const std::vector<HoleCandidate>& found, const std::vector<CandidateShape>& guests) {
  for (std::size_t k = 0; k < found.size(); ++k) {
    const HoleCandidate& c = found[k];
    RC_ASSERT(guests.at(c.incoming).poses.contains(c.canvas_from_shape));
    RC_ASSERT(c.score_px2 > 0);
    const float scale_px = c.canvas_from_shape.scale();
    RC_ASSERT(c.score_px2 <= 1.0001f * guests[c.incoming].worth * scale_px * scale_px);
    if (k > 0) RC_ASSERT(c.score_px2 <= found[k - 1].score_px2);
    for (std::size_t j = 0; j < k; ++j) {
      if (found[j].incoming != c.incoming) continue;
      RC_ASSERT(!near_copy(found[j].canvas_from_shape, c.canvas_from_shape, 0.15f));
    }
  }
}

TEST(HoleCandidates, AHoleGetsItsShapeBack) {
  EXPECT_TRUE(rc::check([] {
    const auto shape = *rc::gen::element<std::size_t>(1, 2, 4);
    const Similarity was = pose(40, relaxed_pieces::any_number(0, 6), kMiddle);
    const std::vector<CandidateShape> guests = all_guests({20, 60, {}});
    const std::vector<HoleCandidate> found = HoleOfAShape(shape, was).candidates(guests, *rc::gen::inRange(0, 1000));
    check_candidates(found, guests);
    RC_ASSERT(!found.empty());
    const HoleCandidate& best = found.front();
    RC_ASSERT(best.incoming == shape);
    RC_ASSERT(best.score_px2 > 0.9f * 40 * 40);
    RC_ASSERT(std::abs(best.canvas_from_shape.scale() - 40) < 4);  // the neighbours make room
    RC_ASSERT(norm(best.canvas_from_shape.translation() - kMiddle) < 2);
  }));
}

TEST(HoleCandidates, KeepToScalesAndRotations) {
  EXPECT_TRUE(rc::check([] {
    const float was_rad = relaxed_pieces::any_number(-3, 3);
    const float low_rad = relaxed_pieces::any_number(-3, 3);
    const PoseRange poses{*rc::gen::element(20.f, 30.f, 35.f), *rc::gen::element(35.f, 50.f),
                          direction_range(low_rad, low_rad + *rc::gen::element(0.f, 0.2f, 1.5f, 4.f))};
    const std::vector<CandidateShape> guests = all_guests(poses);
    const HoleOfAShape hole(*rc::gen::element<std::size_t>(0, 1, 4), pose(42, was_rad, kMiddle));
    const std::vector<HoleCandidate> found = hole.candidates(guests);
    RC_ASSERT(!found.empty());
    check_candidates(found, guests);
  }));
}

/// Many shapes fit into an open place, and none fits it all round.
TEST(HoleCandidates, OfAnOpenPlaceAreTheBestFirst) {
  const FreeField free = relaxed_pieces::rectangle(kCanvas_px);
  const EdgeDistance edge(free);
  Hole open({50, 60}, 55, 1.5f, edge);
  open.add(laid(kDisc, pose(45, 0, {95, 50})));
  const std::vector<CandidateShape> guests = all_guests({20, 60, {}});
  EXPECT_TRUE(rc::check([&] {
    Draws draws(*rc::gen::arbitrary<std::uint64_t>());
    const std::vector<HoleCandidate> found = best(open, kReach_px, guests, kSoftness, draws);
    RC_ASSERT(found.size() == 4u);
    check_candidates(found, guests);
  }));
}

/// Without adjustment few dockings would have a turn that is allowed.
TEST(HoleCandidates, AShapeThatMayNotTurnFindsItsPlace) {
  for (const float was_rad : {0.f, 2.f}) {
    const HoleOfAShape hole(1, pose(40, was_rad, kMiddle));
    const std::vector<CandidateShape> guests = {guest(1, {20, 60, direction_range(was_rad, was_rad)}, 0.01f)};
    float sum_px2 = 0;
    for (std::uint64_t random = 0; random < 12; ++random) {
      const std::vector<HoleCandidate> found = hole.candidates(guests, random);
      if (!found.empty()) sum_px2 += found.front().score_px2;
    }
    EXPECT_GT(sum_px2, 12 * 0.7f * 40 * 40) << "a mean of 15 dockings each";
  }
}

TEST(HoleCandidates, WhatCannotBeSmallEnoughIsLeftOut) {
  const HoleOfAShape hole(1, pose(30, 0, kMiddle));
  std::vector<CandidateShape> guests = all_guests({20, 60, {}});
  guests[1].poses.min_scale_px = 36;
  for (const HoleCandidate& c : hole.candidates(guests)) EXPECT_NE(c.incoming, 1u);
  EXPECT_FALSE(hole.candidates(guests).empty());
}

TEST(HoleCandidates, WhatWeighsNothingIsNeverDrawn) {
  const HoleOfAShape hole(1, pose(40, 0, kMiddle));
  std::vector<CandidateShape> guests = all_guests({20, 60, {}});
  guests[1].weight = 0;
  const std::vector<HoleCandidate> found = hole.candidates(guests);
  EXPECT_FALSE(found.empty());
  for (const HoleCandidate& c : found) EXPECT_NE(c.incoming, 1u);
  for (CandidateShape& g : guests) g.weight = 0;
  EXPECT_TRUE(hole.candidates(guests).empty());
}

/// Dockings are divided by weight, so a shape of little weight gets few, and hardly any fits well.
TEST(HoleCandidates, WhatWeighsLittleIsSeldomAmongTheBest) {
  const HoleOfAShape hole(1, pose(40, 0, kMiddle));
  const auto times_found = [&](float weight) {
    int times = 0;
    for (std::uint64_t random = 0; random < 12; ++random) {
      const std::vector<CandidateShape> guests = {guest(0, {20, 60, {}}), guest(1, {20, 60, {}}, weight)};
      for (const HoleCandidate& c : hole.candidates(guests, random)) times += c.incoming == 1;
    }
    return times;
  };
  EXPECT_GT(times_found(1), 2 * times_found(0.002f));
}

TEST(HoleCandidates, WorthDecidesAmongThem) {
  const HoleOfAShape hole(1, pose(40, 0, kMiddle));
  std::vector<CandidateShape> guests = all_guests({20, 60, {}});
  ASSERT_EQ(hole.candidates(guests).front().incoming, 1u);
  for (const std::size_t wanted : {0u, 2u, 4u}) {
    for (std::size_t i = 0; i < guests.size(); ++i) guests[i].worth = i == wanted ? 1 : 0.3f;
    EXPECT_EQ(hole.candidates(guests).front().incoming, wanted);
  }
  for (CandidateShape& g : guests) g.worth = -0.1f;
  EXPECT_TRUE(hole.candidates(guests).empty()) << "worth nothing";
}

/// Neighbours make some room. The softer they are, the more of it candidates use.
TEST(HoleCandidates, SofterNeighboursAreCoveredMore) {
  const HoleOfAShape hole(0, pose(40, 0, kMiddle));
  const std::vector<CandidateShape> guests = {guest(2, {42, 60, {}})};
  const auto best_px2 = [&](float softness) {
    Draws draws(1);
    const std::vector<HoleCandidate> found = best(hole.hole, kReach_px, guests, softness, draws);
    return found.empty() ? 0.f : found.front().score_px2;
  };
  EXPECT_GT(best_px2(0.5f), best_px2(3) + 50);
}

TEST(HoleCandidates, NothingFitsWhereThereIsNoHole) {
  Draws draws(1);
  const FreeField free = relaxed_pieces::rectangle(kCanvas_px);
  Hole full(kMiddle, 30, 1.5f, EdgeDistance(free));
  full.add(laid(kDisc, pose(300, 0, kMiddle)));
  EXPECT_TRUE(best(full, 30, all_guests({20, 60, {}}), kSoftness, draws).empty());
  const HoleOfAShape hole(1, pose(40, 0, kMiddle));
  EXPECT_TRUE(hole.candidates({}).empty()) << "nobody comes";
}

TEST(HoleCandidates, AreTheSameAgain) {
  const HoleOfAShape hole(4, pose(40, 1, kMiddle));
  const std::vector<CandidateShape> guests = all_guests({20, 60, {}});
  const std::vector<HoleCandidate> found = hole.candidates(guests, 5);
  const std::vector<HoleCandidate> again = hole.candidates(guests, 5);
  ASSERT_EQ(found.size(), again.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].canvas_from_shape, again[k].canvas_from_shape);
  }
}

TEST(HoleShape, DocksLieOnTheOutlineAndLookThroughTheShape) {
  for (std::size_t shape = 0; shape < hole_shapes().size(); ++shape) {
    const HoleShape& made = hole_shapes()[shape];
    const Outline& outline = relaxed_pieces::shapes()[shape].outline;
    ASSERT_EQ(made.docks.size(), 64u);
    for (const DockPoint& dock : made.docks) {
      EXPECT_NEAR(test::signed_distance(outline, dock.at), 0, 0.01f);
      EXPECT_NEAR(norm(dock.inward), 1, 1e-4f);
      EXPECT_LT(test::signed_distance(outline, dock.at + dock.inward * 0.03f), 0.005f);
      EXPECT_GE(dock.thickness, 0.05f);
      // The way through the shape ends on the outline again, at the other side.
      EXPECT_NEAR(test::signed_distance(outline, dock.at + dock.inward * dock.thickness), 0, 0.05f) << shape;
    }
  }
  // The way through a disc is its diameter.
  for (const DockPoint& dock : hole_shapes()[kDisc].docks) EXPECT_NEAR(dock.thickness, 2 * kDiscRadius, 0.03f);
}

/// The points cover an area of 1, except for a seam along the boundary.
TEST(HoleShape, InteriorPointsAreEvenInside) {
  for (std::size_t shape = 0; shape < hole_shapes().size(); ++shape) {
    const HoleShape& made = hole_shapes()[shape];
    for (const Vec2 p : made.interior) EXPECT_LT(made.contact.distance(p).value, 0);
    const float step = 2 * made.contact.field.extent / 16;
    const float area = float(made.interior.size()) * step * step;
    EXPECT_GT(area, 0.6f) << shape;
    EXPECT_LT(area, 1.02f) << shape;
  }
}

}  // namespace test_hole
}  // namespace tessera
