// Pieces laid on strips and sheets. An independent checker verifies what a layout promises.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <thread>

#include "products/nesting/layout/nest_check.h"
#include "products/nesting/layout/nest_poles.h"
#include "products/nesting/layout/nest_random.h"
#include "products/nesting/layout/nesting.h"
#include "products/nesting/layout/search_outline.h"

namespace tessera {
namespace test_nesting {

constexpr double kPi = 3.14159265358979323846;

NestRing rectangle(double w, double h) { return {{0, 0}, {w, 0}, {w, h}, {0, h}}; }

/// A random star-shaped polygon with dents, about `size` large.
NestRing random_star(NestRandom& random, double size) {
  const int corners = 3 + random.below(9);
  NestRing ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * (i + 0.6 * random.unit()) / corners, radius = size * random.between(0.3, 1);
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

NestProblem random_problem(std::uint64_t seed) {
  NestRandom random(seed);
  NestProblem problem;
  problem.height = random.between(60, 120);
  const std::vector<std::vector<double>> angles = {{0}, {0, 180}, {0, 90, 180, 270}, {0, 37.5, 200}};
  const int items = 2 + random.below(4);
  for (int i = 0; i < items; ++i) {
    const NestRing ring = random.below(4) == 0 ? rectangle(random.between(5, 40), random.between(5, 40))
                                               : random_star(random, random.between(8, 28));
    problem.items.push_back({ring, angles[std::size_t(random.below(4))], 1 + random.below(4)});
  }
  if (random.below(3) == 0) problem.spacing = random.between(0.5, 3);
  if (random.below(3) == 0) problem.length = random.between(60, 120);
  return problem;
}

const NestEffort kShort{1, 4'000};

/// The intervals of a horizontal line that lie inside an outline, computed independently of the product.
/// The intervals of two pieces may overlap by no more than rounding.
std::vector<std::pair<double, double>> inside_on_line(const NestRing& ring, double y) {
  std::vector<double> xs;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const NestPoint a = ring[j], b = ring[i];
    if ((a.y <= y) != (b.y <= y)) xs.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
  }
  std::sort(xs.begin(), xs.end());
  std::vector<std::pair<double, double>> inside;
  for (std::size_t i = 0; i + 1 < xs.size(); i += 2) inside.emplace_back(xs[i], xs[i + 1]);
  return inside;
}

double widest_overlap(const NestRing& a, const NestRing& b, double height) {
  double widest = 0;
  for (int line = 0; line < 400; ++line) {
    const double y = height * (line + 0.4142) / 400;
    for (const auto& [a0, a1] : inside_on_line(a, y)) {
      for (const auto& [b0, b1] : inside_on_line(b, y)) widest = std::max(widest, std::min(a1, b1) - std::max(a0, b0));
    }
  }
  return widest;
}

/// The distance of two outlines that do not meet: it lies between a corner of one and the other.
double distance_between(const NestRing& a, const NestRing& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const NestPoint p : a) least = std::min(least, distance_to_boundary(b, p));
  for (const NestPoint p : b) least = std::min(least, distance_to_boundary(a, p));
  return least;
}

void expect_sound(const NestProblem& problem, const NestLayout& layout) {
  RC_ASSERT(nest_fault(problem, layout) == "");
  std::vector<NestRing> rings;
  std::vector<int> counts = layout.left_over;
  for (const NestedPiece& piece : layout.pieces) {
    const NestItem& item = problem.items.at(std::size_t(piece.item));
    const double angle = item.angles_deg.at(std::size_t(piece.angle)) * kPi / 180;
    NestRing ring;
    for (const NestPoint p : item.outline) {
      ring.push_back({p.x * std::cos(angle) - p.y * std::sin(angle) + piece.shift.x,
                      p.x * std::sin(angle) + p.y * std::cos(angle) + piece.shift.y});
    }
    for (const NestPoint p : ring) {
      RC_ASSERT(p.x >= -1e-6 && p.y >= -1e-6 && p.y <= problem.height + 1e-6);
      RC_ASSERT(p.x <= std::min(problem.length, 1e9) + 1e-6);
      if (piece.sheet + 1 == layout.sheets) RC_ASSERT(p.x <= layout.used_length + 1e-6);
    }
    ++counts.at(std::size_t(piece.item));
    rings.push_back(std::move(ring));
  }
  for (std::size_t i = 0; i < counts.size(); ++i) RC_ASSERT(counts[i] == problem.items[i].demand);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (layout.pieces[i].sheet != layout.pieces[j].sheet) continue;
      // A tip may be cut slightly deeper along the line than across it.
      RC_ASSERT(widest_overlap(rings[i], rings[j], problem.height) < 1e-3);
      if (problem.spacing > 0) RC_ASSERT(distance_between(rings[i], rings[j]) > problem.spacing - 1e-3);
    }
  }
}

RC_GTEST_PROP(Nesting, KeepsItsPromises, (std::uint64_t seed)) {
  const NestProblem problem = random_problem(seed);
  const NestLayout layout = nest_chain(problem, posed_items(problem), kShort, seed, 0);
  expect_sound(problem, layout);
}

RC_GTEST_PROP(Nesting, FitsAllIntoAStripThatIsHighEnough, (std::uint64_t seed)) {
  NestProblem problem = random_problem(seed);
  problem.length = std::numeric_limits<double>::infinity();
  const NestLayout layout = nest_chain(problem, posed_items(problem), kShort, seed, 0);
  RC_ASSERT(std::accumulate(layout.left_over.begin(), layout.left_over.end(), 0) == 0);
  RC_ASSERT(layout.sheets == 1);
}

TEST(Nesting, IsTheSameOnAnyThread) {
  const NestProblem problem = random_problem(7);
  const PosedItems shapes = posed_items(problem);
  std::vector<NestLayout> alone, together(4);
  for (int chain = 0; chain < 4; ++chain) alone.push_back(nest_chain(problem, shapes, kShort, 3, chain));
  {
    std::vector<std::jthread> threads;
    for (int chain = 0; chain < 4; ++chain) {
      threads.emplace_back(
          [&, chain] { together[std::size_t(chain)] = nest_chain(problem, shapes, kShort, 3, chain); });
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(alone[i].pieces, together[i].pieces);
    EXPECT_EQ(alone[i].used_length, together[i].used_length);
  }
  EXPECT_NE(alone[0].pieces, alone[1].pieces);
}

/// A rectangle of 100 x 60 cut into five parts, which fit together without a gap.
NestProblem cut_rectangle() {
  NestProblem problem;
  problem.height = 60;
  for (const auto& [w, h] : std::vector<std::pair<double, double>>{{40, 60}, {30, 20}, {30, 40}, {30, 30}, {30, 30}}) {
    problem.items.push_back({rectangle(w, h), {0, 90}, 1});
  }
  return problem;
}

TEST(Nesting, TheBestDoesNotDependOnWhoHadWhichChain) {
  // Several chains of equal length: any division among ranks gives the first of them.
  for (const std::vector<double>& lengths : std::vector<std::vector<double>>{
           {9, 7, 7, 8}, {7, 7, 7, 7}, {9, 8, 7, 7}, {7, 9, 7, 9}, {9, 9, 9, 9, 8, 8, 8}}) {
    std::vector<NestLayout> chains;
    for (const double length : lengths)
      chains.push_back(
          {.pieces = {}, .left_over = {}, .sheets = 1, .used_length = length, .chain = int(chains.size())});
    const int first = int(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
    for (int ranks = 1; ranks <= 4; ++ranks) {
      std::vector<NestLayout> of_ranks;
      for (int rank = 0; rank < ranks; ++rank) {
        std::vector<NestLayout> share;
        for (std::size_t i = std::size_t(rank); i < chains.size(); i += std::size_t(ranks)) share.push_back(chains[i]);
        of_ranks.push_back(best_layout(share));
      }
      EXPECT_EQ(best_layout(of_ranks).chain, first) << ranks;
    }
  }
}

TEST(Nesting, RectanglesTouch) {
  const NestProblem problem = cut_rectangle();
  const NestLayout layout = nest_chain(problem, posed_items(problem), {1, 40'000}, 1, 0);
  EXPECT_EQ(nest_fault(problem, layout), "");
  EXPECT_NEAR(layout.used_length, 100, 1e-3);
}

TEST(Nesting, SheetsAreFilledOneAfterTheOther) {
  NestProblem problem;
  problem.height = 40;
  problem.length = 40;
  problem.items.push_back({rectangle(20, 20), {0}, 9});
  problem.items.push_back({rectangle(50, 10), {0, 90}, 2});
  const NestLayout layout = nest_chain(problem, posed_items(problem), {1, 20'000}, 1, 0);
  EXPECT_EQ(nest_fault(problem, layout), "");
  EXPECT_EQ(layout.sheets, 3);
  EXPECT_EQ(layout.left_over, (std::vector<int>{0, 2}));
  EXPECT_NEAR(layout.used_length, 20, 1e-6);
}

TEST(Nesting, ASheetHasABudgetByThePiecesThatAreLeft) {
  NestProblem problem;
  problem.height = 40;
  problem.length = 40;
  problem.items.push_back({{{0, 0}, {25, 0}, {25, 8}, {8, 8}, {8, 25}, {0, 25}}, {0, 90, 180, 270}, 16});
  std::vector<int> looks;  // the number of progress calls after each found layout
  nest_chain(
      problem, posed_items(problem), {1, 3'000}, 1, 0, [&](const NestLayout&) { looks.push_back(0); },
      [&](double) { ++looks.back(); });
  ASSERT_GT(looks.size(), 4u);
  EXPECT_LT(looks[4], 0.6 * looks[0]);
}

/// Ends a chain after `looks` progress calls, and returns the layouts found so far.
std::vector<NestLayout> found_until(const NestProblem& problem, const NestEffort& effort, std::uint64_t seed,
                                    int looks) {
  struct Stop {};
  std::vector<NestLayout> found;
  try {
    nest_chain(
        problem, posed_items(problem), effort, seed, 0, [&](const NestLayout& layout) { found.push_back(layout); },
        [&](double) {
          if (--looks < 0) throw Stop{};
        });
  } catch (const Stop&) {
  }
  return found;
}

RC_GTEST_PROP(Nesting, HasAWholeLayoutWheneverItIsStopped, (std::uint64_t seed)) {
  const NestProblem problem = random_problem(seed);
  const int looks = *rc::gen::inRange(0, 400);
  const std::vector<NestLayout> found = found_until(problem, kShort, seed, looks);
  RC_ASSERT(!found.empty());
  for (std::size_t i = 0; i < found.size(); ++i) {
    expect_sound(problem, found[i]);
    if (i > 0) RC_ASSERT(is_better(found[i], found[i - 1]));
  }
}

TEST(Nesting, WhatItFindsDoesNotDependOnWhoIsTold) {
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    const NestProblem problem = random_problem(seed);
    const NestLayout alone = nest_chain(problem, posed_items(problem), kShort, seed, 0);
    NestLayout last;
    const NestLayout told = nest_chain(
        problem, posed_items(problem), kShort, seed, 0, [&](const NestLayout& layout) { last = layout; },
        [](double) {});
    EXPECT_EQ(alone.pieces, told.pieces);
    EXPECT_FALSE(is_better(told, last));
  }
}

TEST(Nesting, TellsHowFarItIs) {
  for (const double length : {std::numeric_limits<double>::infinity(), 80.0}) {
    NestProblem problem = random_problem(7);
    problem.length = length;
    std::vector<double> done{0};
    nest_chain(problem, posed_items(problem), kShort, 1, 0, {}, [&](double part) {
      EXPECT_GE(part, done.back());
      done.push_back(part);
    });
    EXPECT_GT(done.size(), 50u);
    EXPECT_LE(done.back(), 1);
  }
}

TEST(Nesting, ASlantedPieceIsTurnedUpright) {
  NestProblem problem;
  problem.height = 200;
  problem.items.push_back({rectangle(100, 10), {0, 90}, 3});
  const NestLayout layout = nest_chain(problem, posed_items(problem), {1, 20'000}, 1, 0);
  EXPECT_NEAR(layout.used_length, 20, 0.1);  // two pieces on top of each other, and one beside them
}

TEST(Nesting, TheCheckerSeesFaults) {
  NestProblem problem;
  problem.height = 10;
  problem.items.push_back({rectangle(4, 4), {0}, 2});
  NestLayout layout{.pieces = {{0, 0, {0, 0}, 0}, {0, 0, {4, 0}, 0}}, .left_over = {0}, .sheets = 1, .used_length = 8};
  EXPECT_EQ(nest_fault(problem, layout), "");
  problem.spacing = 0.5;
  EXPECT_EQ(nest_fault(problem, layout), "pieces 0 and 1 are too near");
  problem.spacing = 0;
  layout.pieces[1].shift.x = 3.999;
  EXPECT_EQ(nest_fault(problem, layout), "pieces 0 and 1 overlap");
  layout.pieces[1].shift.x = 0;
  EXPECT_EQ(nest_fault(problem, layout), "pieces 0 and 1 overlap");
  layout.pieces[1].shift = {4, 6.001};
  EXPECT_EQ(nest_fault(problem, layout), "piece 1 sticks out");
  layout.pieces[1] = {0, 1, {4, 0}, 0};
  EXPECT_EQ(nest_fault(problem, layout), "a piece at an angle that it may not have");
  layout.pieces.pop_back();
  EXPECT_EQ(nest_fault(problem, layout), "item 0 has a wrong number of pieces");
}

TEST(NestCheck, ACrossIsSeenThatHasNoCornerInside) {
  const NestRing lying{{0, 4}, {10, 4}, {10, 6}, {0, 6}}, standing{{4, 0}, {6, 0}, {6, 10}, {4, 10}};
  EXPECT_TRUE(lie_deeper(lying, standing, 0.9));
  EXPECT_FALSE(lie_deeper(lying, standing, 1.1));
  EXPECT_FALSE(lie_deeper({{0, 0}, {4, 0}, {4, 4}}, {{4, 0}, {8, 0}, {8, 4}}, 1e-9));
}

/// Compares all points and sides, without rows.
bool lies_deeper_by_all(const NestRing& inner, const NestRing& outer, double depth) {
  const auto deeper = [&](NestPoint p) { return contains(outer, p) && distance_to_boundary(outer, p) > depth; };
  bool any = deeper(poles_of(inner, 1).front().centre);
  for (std::size_t i = 0, j = inner.size() - 1; i < inner.size(); j = i++) {
    for (int part = 0; part <= 64; ++part) any |= deeper(inner[j] + (inner[i] - inner[j]) * (part / 64.0));
  }
  return any;
}

RC_GTEST_PROP(NestCheck, SeesWhatALookAtAllSidesSees, (std::uint64_t seed)) {
  NestRandom random(seed);
  const NestRing a = random_star(random, 20);
  NestRing b = random_star(random, 20);
  const NestPoint by{random.between(-40, 40), random.between(-40, 40)};
  for (NestPoint& p : b) p = p + by;
  if (lies_deeper_by_all(a, b, 0.5) || lies_deeper_by_all(b, a, 0.5)) RC_ASSERT(lie_deeper(a, b, 0.5));
  if (!lie_deeper(a, b, 0)) {
    const double distance = distance_between(a, b);
    RC_ASSERT(are_nearer(a, b, distance * 1.001 + 1e-9));
    RC_ASSERT(!are_nearer(a, b, distance * 0.999));
  }
}

TEST(NestCheck, ManyPiecesOfManyPointsAreCheckedInTime) {
  NestProblem problem;
  problem.height = 1e3;
  NestRing wavy;
  for (int i = 0; i < 5'000; ++i) {
    const double angle = 2 * kPi * i / 5'000, radius = 10 + 0.1 * std::sin(100 * angle);
    wavy.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  problem.items.push_back({wavy, {0}, 500});
  NestLayout layout{.pieces = {}, .left_over = {0}, .sheets = 1, .used_length = 1e3};
  for (int i = 0; i < 500; ++i) layout.pieces.push_back({0, 0, {11 + 20.2 * (i % 40), 11 + 20.2 * (i / 40)}, 0});
  EXPECT_EQ(nest_fault(problem, layout), "");
  layout.pieces[479].shift.x -= 0.5;
  EXPECT_EQ(nest_fault(problem, layout), "pieces 478 and 479 overlap");
}

RC_GTEST_PROP(SearchOutline, HoldsThePiece, (std::uint64_t seed)) {
  NestRandom random(seed);
  std::size_t spikes = 0;
  NestRing ring;
  for (int i = 0; i < 200; ++i) {
    const double angle = 2 * kPi * i / 200, radius = 50 + 20 * std::sin(5 * angle) + random.unit();
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    if (random.below(50) > 0) continue;
    ++spikes;
    const NestPoint base = ring.back();  // a spike that goes out and back
    ring.insert(ring.end(), {base * random.between(1.1, 1.5), base});
  }
  const double area = signed_area(ring);
  const NestRing fewer = enlarged_to_fewer_points(tidied(ring), 0.005 * area);
  RC_ASSERT(fewer.size() < 100 + 5 * spikes);
  RC_ASSERT(signed_area(fewer) <= area * 1.005 + 1e-6);
  for (const NestPoint p : ring) RC_ASSERT(contains(fewer, p) || distance_to_boundary(fewer, p) < 1e-9);
  for (const NestPoint p : grown(fewer, 2)) {
    const double distance = distance_to_boundary(fewer, p);
    RC_ASSERT(distance <= 2 * 1.04);
  }
}

RC_GTEST_PROP(SearchOutline, SpikesGo, (std::uint64_t seed)) {
  NestRandom random(seed);
  const NestRing ring = random_star(random, 50);
  NestRing spiky;
  for (const NestPoint p : ring) {
    spiky.push_back(p);
    if (random.below(2) == 0) spiky.insert(spiky.end(), {p * 1.5, p});
    if (random.below(4) == 0) spiky.insert(spiky.end(), {p * 1.5, p * 1.75, p * 1.5, p});
  }
  const NestRing without = without_spikes(spiky);
  RC_ASSERT(std::is_permutation(without.begin(), without.end(), ring.begin(), ring.end()));
  RC_ASSERT(without_spikes(ring) == ring);
}

TEST(SearchOutline, ASpikeMayReachBeyondItsBase) {
  // The spike comes back by less than it went out, and by more.
  EXPECT_EQ(without_spikes({{0, 0}, {4, 0}, {4, 2}, {9, 2}, {5, 2}, {5, 4}, {0, 4}}),
            (NestRing{{0, 0}, {4, 0}, {4, 2}, {5, 2}, {5, 4}, {0, 4}}));
  EXPECT_EQ(without_spikes({{0, 0}, {4, 0}, {4, 2}, {9, 2}, {3, 2}, {3, 4}, {0, 4}}),
            (NestRing{{0, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 4}, {0, 4}}));
}

TEST(Nesting, WhatIsAsLargeAsTheMaterialFits) {
  // In floating point, 62.2 - 7.6 is slightly more than 54.6, and 255.4 - 229.1 slightly more than 26.3.
  for (const auto& [low, high, height] : std::vector<std::array<double, 3>>{{7.6, 62.2, 54.6}, {229.1, 255.4, 26.3}}) {
    NestProblem problem;
    problem.height = height;
    problem.items.push_back({{{0, low}, {20, low}, {20, high}, {0, high}}, {0}, 3});
    const NestLayout strip = nest_chain(problem, posed_items(problem), kShort, 1, 0);
    EXPECT_EQ(strip.left_over, std::vector<int>{0});
    EXPECT_EQ(nest_fault(problem, strip), "");
    EXPECT_NEAR(strip.used_length, 60, 1e-4);
    problem.items[0].outline = {{low, 0}, {high, 0}, {high, 20}, {low, 20}};
    problem.height = 40;
    problem.length = height;
    const NestLayout sheets = nest_chain(problem, posed_items(problem), kShort, 1, 0);
    EXPECT_EQ(sheets.left_over, std::vector<int>{0});
    EXPECT_EQ(sheets.sheets, 2);
    EXPECT_EQ(nest_fault(problem, sheets), "");
  }
}

TEST(Nesting, TinyPiecesAmongLargeOnesSlideInTime) {
  NestProblem problem;
  problem.height = 100;
  problem.items.push_back({rectangle(1000, 90), {0}, 1});
  problem.items.push_back({rectangle(2e-4, 2e-4), {0}, 20});  // leads to steps of 4e-6
  const NestLayout layout = nest_chain(problem, posed_items(problem), kShort, 1, 0);
  EXPECT_EQ(nest_fault(problem, layout), "");
  EXPECT_NEAR(layout.used_length, 1000, 1e-3);
}

TEST(NestPoles, ASliverOfManyPointsHasOneInTime) {
  // The sliver lies along a diagonal, thinner than any node of a grid. A grid 32 times as fine would take minutes.
  NestRing ring;
  constexpr int kSide = 2'000;
  for (int i = 0; i <= kSide; ++i) ring.push_back({i * 0.05, i * 0.05 * 0.7});
  for (int i = kSide; i >= 0; --i) ring.push_back({i * 0.05, i * 0.05 * 0.7 + 1e-4});
  const std::vector<NestPole> poles = poles_of(ring, 1);
  ASSERT_EQ(poles.size(), 1u);
  EXPECT_TRUE(contains(ring, poles.front().centre));
}

TEST(NestTurn, IsExactAtQuartersAndNearElsewhere) {
  EXPECT_EQ(turn_of(90).apply({3, 1}), (NestPoint{-1, 3}));
  EXPECT_EQ(turn_of(-180).apply({3, 1}), (NestPoint{-3, -1}));
  for (double angle = -720; angle < 720; angle += 7.3) {
    EXPECT_NEAR(turn_of(angle).cosine, std::cos(angle * kPi / 180), 1e-14);
    EXPECT_NEAR(turn_of(angle).sine, std::sin(angle * kPi / 180), 1e-14);
  }
}

TEST(CrossesItself, TellsABowTieFromABox) {
  EXPECT_TRUE(crosses_itself({{0, 0}, {4, 4}, {4, 0}, {0, 4}}));
  EXPECT_FALSE(crosses_itself(rectangle(4, 2)));
}

}  // namespace test_nesting
}  // namespace tessera
