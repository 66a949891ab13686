// Pictures are cut into pieces and laid together again.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "core/base/portable_math.h"
#include "core/geometry/closed_curve.h"
#include "core/geometry/polygon.h"
#include "products/puzzle/laying/puzzle_solver.h"
#include "products/puzzle/pieces/piece_erosion.h"
#include "products/puzzle/pieces/puzzle_contact.h"
#include "products/puzzle/polygon_parts.h"
#include "products/puzzle/puzzle_cut.h"
#include "products/puzzle/puzzle_truth.h"

namespace tessera {
namespace test_puzzle {

using Polygon = std::vector<Vec2>;

constexpr int kWidth_px = 1200, kHeight_px = 900;

CutRequest request_of(int pieces, CutStyle style, std::uint64_t seed) {
  return {.width_px = kWidth_px, .height_px = kHeight_px, .pieces = pieces, .style = style, .seed = seed};
}

Polygon frame() { return {{0, 0}, {kWidth_px, 0}, {kWidth_px, kHeight_px}, {0, kHeight_px}}; }

/// The pieces as a library holds them, with 512 points each, turned and moved; and their true poses.
struct Shuffled {
  PuzzleInput input;
  std::vector<std::optional<Similarity>> truth;  // puzzle_from_piece
};

Shuffled shuffled(const std::vector<Polygon>& cut) {
  Shuffled puzzle;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    const float angle = 2.4f * float(i);
    const Similarity piece_from_puzzle{std::cos(angle), std::sin(angle), 37 * float(i), -11};
    Polygon piece = resampled_closed(cut[i], 512);
    for (Vec2& p : piece) p = piece_from_puzzle.apply(p);
    puzzle.input.pieces.push_back(piece);
    puzzle.truth.push_back(rigid_inverse(piece_from_puzzle));
  }
  return puzzle;
}

/// The colour of a scene that has detail everywhere, at x and y of the frame.
std::array<float, 3> scene(Vec2 p) {
  const float x = p.x / 1200, y = p.y / 900;
  return {127 + 60 * std::sin(9 * x + 4 * y) + 60 * std::sin(23 * y - 11 * x),
          127 + 90 * std::sin(7 * y - 3 * x + 2) + 30 * std::sin(31 * x),
          127 + 70 * std::sin(13 * x * y + 5) + 50 * std::sin(17 * x + 19 * y)};
}

/// Gives each piece its own picture with a transparent ground.
void paint(Shuffled& puzzle) {
  for (std::size_t i = 0; i < puzzle.input.pieces.size(); ++i) {
    const Box box = bounding_box(puzzle.input.pieces[i]);
    constexpr float kScale = 0.7f;  // px per unit
    const int width = int(box.width() * kScale) + 4, height = int(box.height() * kScale) + 4;
    std::vector<std::uint8_t> bgra;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Vec2 p = Vec2{float(x) - 1.5f, float(y) - 1.5f} * (1 / kScale) + box.low;
        for (const float c : scene(puzzle.truth[i]->apply(p))) bgra.push_back(std::uint8_t(c));
        bgra.push_back(contains(puzzle.input.pieces[i], p) ? 255 : 0);
      }
    }
    puzzle.input.pictures.emplace_back(width, height, bgra,
                                       Similarity{kScale, 0, 2 - kScale * box.low.x, 2 - kScale * box.low.y});
  }
}

/// Converts to poses of shapes: of the piece's centre, with its size, as agreement() compares them.
std::vector<std::optional<Similarity>> of_shapes(std::vector<std::optional<Similarity>> poses,
                                                 const std::vector<Polygon>& pieces) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i]) continue;
    const AreaMoment moment = area_moment(pieces[i]);
    const float size = float(std::sqrt(moment.area));
    const Vec2 centre = poses[i]->apply({float(moment.x / moment.area), float(moment.y / moment.area)});
    poses[i] = Similarity{poses[i]->a * size, poses[i]->b * size, centre.x, centre.y};
  }
  return poses;
}

/// The number of pieces in their right places. `tolerance` is in units of kRightShift_px.
int right(const PuzzleSolution& solution, const Shuffled& puzzle, float tolerance = 1) {
  const auto shrunk = [&](std::vector<std::optional<Similarity>> poses) {
    poses = of_shapes(std::move(poses), puzzle.input.pieces);
    for (std::optional<Similarity>& pose : poses) {
      if (pose) pose = scaled(*pose, 1 / tolerance);
    }
    return poses;
  };
  return agreement(shrunk(solution.poses), shrunk(puzzle.truth)).right;
}

RC_GTEST_PROP(PuzzleCut, PiecesCoverTheFrameOnce, ()) {
  const auto style = *rc::gen::element(CutStyle::tabs, CutStyle::polygons);
  const CutRequest request = request_of(*rc::gen::inRange(2, 60), style, *rc::gen::inRange<std::uint64_t>(0, 1000));
  const std::vector<Polygon> cut = cut_puzzle(request);
  double area = 0;
  for (const Polygon& piece : cut) {
    RC_ASSERT(signed_area(piece) > 0);
    area += signed_area(piece);
    const Box box = bounding_box(piece);
    RC_ASSERT(box.low.x >= -0.01f && box.low.y >= -0.01f);
    RC_ASSERT(box.high.x <= kWidth_px + 0.01f && box.high.y <= kHeight_px + 0.01f);
  }
  RC_ASSERT(std::abs(area / (kWidth_px * kHeight_px) - 1) < 1e-4);
  const Vec2 somewhere{float(*rc::gen::inRange(1, kWidth_px)) - 0.37f, float(*rc::gen::inRange(1, kHeight_px)) - 0.41f};
  const auto holds = [&](const Polygon& piece) { return contains(piece, somewhere); };
  RC_ASSERT(std::count_if(cut.begin(), cut.end(), holds) == 1);
  RC_ASSERT(cut_puzzle(request) == cut);
  if (style == CutStyle::polygons) RC_ASSERT(int(cut.size()) == request.pieces);
}

TEST(PuzzleCut, TabsComeInTheNumberThatIsWishedWherePiecesAreNearlySquare) {
  EXPECT_EQ(cut_puzzle(request_of(12, CutStyle::tabs, 1)).size(), 12u);
  EXPECT_EQ(cut_puzzle(request_of(36, CutStyle::tabs, 1)).size(), 36u);
  EXPECT_NEAR(double(cut_puzzle(request_of(97, CutStyle::tabs, 1)).size()), 97, 3) << "a prime has no rows";
}

TEST(PuzzleCut, NoTwoTabsAreAlike) {
  const std::vector<Polygon> cut = cut_puzzle(request_of(36, CutStyle::tabs, 1));
  std::vector<double> areas;
  for (const Polygon& piece : cut) areas.push_back(signed_area(piece));
  std::sort(areas.begin(), areas.end());
  EXPECT_EQ(std::adjacent_find(areas.begin(), areas.end()), areas.end());
}

/// The test includes numbers of pieces that give a grid of long or narrow pieces.
TEST(PuzzleCut, TabsNeitherMeetNorLeaveTheFrame) {
  for (int pieces = 2; pieces <= 20; ++pieces) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const std::vector<Polygon> cut = cut_puzzle(request_of(pieces, CutStyle::tabs, seed));
      for (int y = 20; y < kHeight_px; y += 23) {
        for (int x = 20; x < kWidth_px; x += 23) {
          const auto holds = [&](const Polygon& piece) { return contains(piece, {float(x) + 0.3f, float(y) + 0.7f}); };
          ASSERT_EQ(std::count_if(cut.begin(), cut.end(), holds), 1) << pieces << " pieces, seed " << seed;
        }
      }
      for (const Polygon& piece : cut) {
        const Box box = bounding_box(piece);
        ASSERT_TRUE(box.low.x > -0.01f && box.low.y > -0.01f && box.high.x < kWidth_px + 0.01f &&
                    box.high.y < kHeight_px + 0.01f)
            << pieces << " pieces, seed " << seed;
      }
    }
  }
}

/// A round drop with one corner; y runs from 100 to 800.
Polygon drop() {
  Polygon curve;
  for (int k = 0; k < 240; ++k) {
    const float t = 0.0261799f * float(k), narrow = std::sin(t / 2);
    curve.push_back({600 + 420 * std::sin(t) * narrow * narrow, 450 - 350 * std::cos(t)});
  }
  if (signed_area(curve) < 0) std::reverse(curve.begin(), curve.end());
  return curve;
}

/// An outline without corners and without rotational symmetry.
Polygon pebble() {
  Polygon curve;
  for (int k = 0; k < 240; ++k) {
    const float t = 0.0261799f * float(k), r = 330 + 70 * std::cos(2 * t) + 30 * std::sin(3 * t);
    curve.push_back({600 + r * std::cos(t), 450 + r * std::sin(t)});
  }
  return curve;
}

TEST(PolygonParts, OfACombAreItsTeeth) {
  const Polygon comb = {{0, 0}, {90, 0}, {90, 50}, {70, 50}, {70, 10}, {20, 10}, {20, 50}, {0, 50}};
  const Polygon above = {{-5, 30}, {95, 30}, {95, 60}, {-5, 60}}, below = {{-5, -5}, {95, -5}, {95, 30}, {-5, 30}};
  const std::vector<Polygon> teeth = common_parts(above, comb), back = common_parts(below, comb);
  ASSERT_EQ(teeth.size(), 2u);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_NEAR(signed_area(teeth[0]) + signed_area(teeth[1]), 2 * 20 * 20, 1e-3);
  EXPECT_NEAR(shared_length(teeth[0], back[0]), 20, 1e-4);
  const std::optional<Polygon> longer = joined(teeth[0], back[0]);
  ASSERT_TRUE(longer);
  EXPECT_NEAR(signed_area(*longer), signed_area(teeth[0]) + signed_area(back[0]), 1e-3);
  EXPECT_FALSE(joined(teeth[0], teeth[1])) << "they do not touch";
  EXPECT_EQ(common_parts(comb, {{-9, -9}, {99, -9}, {99, 99}, {-9, 99}}), std::vector<Polygon>{comb});
  EXPECT_TRUE(common_parts(comb, {{30, 20}, {50, 20}, {50, 40}, {30, 40}}).empty()) << "between the teeth";
}

RC_GTEST_PROP(PuzzleCut, PiecesCoverAShapeOnce, ()) {
  CutRequest request = request_of(*rc::gen::inRange(2, 60), *rc::gen::element(CutStyle::tabs, CutStyle::polygons),
                                  *rc::gen::inRange<std::uint64_t>(0, 1000));
  request.outline = *rc::gen::element(drop(), pebble());
  const std::vector<Polygon> cut = cut_puzzle(request);
  double area = 0, least = INFINITY;
  for (const Polygon& piece : cut) {
    area += signed_area(piece);
    least = std::min(least, signed_area(piece));
  }
  const double whole = signed_area(request.outline);
  RC_ASSERT(std::abs(area / whole - 1) < 1e-4);
  RC_ASSERT(least > 0.19 * whole / request.pieces);
  RC_ASSERT(int(cut.size()) <= 2 * request.pieces + 4);
  for (int k = 0; k < 20; ++k) {
    const Vec2 p{float(*rc::gen::inRange(200, 1000)) - 0.37f, float(*rc::gen::inRange(80, 820)) - 0.41f};
    const auto holds = [&](const Polygon& piece) { return contains(piece, p); };
    RC_ASSERT(std::count_if(cut.begin(), cut.end(), holds) == (contains(request.outline, p) ? 1 : 0));
  }
}

class Puzzles : public testing::TestWithParam<int> {};

/// One frame has one corner, the other none.
TEST_P(Puzzles, TabsOfAShapeInItsFrame) {
  for (const Polygon& outline : {drop(), pebble()}) {
    CutRequest request = request_of(24, CutStyle::tabs, std::uint64_t(GetParam()));
    request.outline = outline;
    Shuffled puzzle = shuffled(cut_puzzle(request));
    puzzle.input.frame = outline;
    const PuzzleSolution solution = solve_puzzle(puzzle.input);
    EXPECT_EQ(right(solution, puzzle), int(puzzle.input.pieces.size()));
    for (std::size_t i = 0; i < solution.poses.size(); ++i) {
      ASSERT_TRUE(solution.poses[i]);
      EXPECT_NEAR(solution.poses[i]->tx, puzzle.truth[i]->tx, 4) << "there, not only beside each other";
      EXPECT_NEAR(solution.poses[i]->ty, puzzle.truth[i]->ty, 4);
    }
  }
}

TEST_P(Puzzles, PolygonsOfAShapeInItsFrame) {
  CutRequest request = request_of(15, CutStyle::polygons, std::uint64_t(GetParam()));
  request.outline = drop();
  Shuffled puzzle = shuffled(cut_puzzle(request));
  puzzle.input.frame = drop();
  EXPECT_EQ(right(solve_puzzle(puzzle.input), puzzle), int(puzzle.input.pieces.size()));
}

TEST_P(Puzzles, TabsAreLaidAsTheyWereCut) {
  const Shuffled puzzle = shuffled(cut_puzzle(request_of(36, CutStyle::tabs, std::uint64_t(GetParam()))));
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_EQ(solution.placed, 36);
  EXPECT_EQ(right(solution, puzzle), 36);
  EXPECT_LT(solution.gaps, 0.02);
}

TEST_P(Puzzles, TabsInAFrame) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(20, CutStyle::tabs, std::uint64_t(GetParam()))));
  puzzle.input.frame = frame();
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_EQ(right(solution, puzzle), 20);
  for (std::size_t i = 0; i < solution.poses.size(); ++i) {
    ASSERT_TRUE(solution.poses[i]);
    for (const Vec2 p : puzzle.input.pieces[i]) {
      const Vec2 q = solution.poses[i]->apply(p);
      EXPECT_GT(std::min({q.x, q.y, kWidth_px - q.x, kHeight_px - q.y}), -3) << "piece " << i << " leaves the frame";
    }
  }
}

/// The number of pieces is that of Fig. 18. The sides are straight, so any two may agree by chance.
TEST_P(Puzzles, PolygonsInAFrame) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(18, CutStyle::polygons, std::uint64_t(GetParam()))));
  puzzle.input.frame = frame();
  EXPECT_EQ(right(solve_puzzle(puzzle.input), puzzle), 18);
}

/// Returns the piece as a scan gives it: with rounded corners, and each point up to half a unit off.
Polygon traced(const Polygon& piece) {
  const int count = int(piece.size());
  Polygon smooth;
  for (int k = 0; k < count; ++k) {
    Vec2 mean{};
    for (int j = -3; j <= 3; ++j) {
      const Vec2 p = piece[std::size_t((k + j + count) % count)];
      mean = mean + Vec2{std::round(p.x), std::round(p.y)} * (1.f / 7);
    }
    smooth.push_back(mean);
  }
  return smooth;
}

/// Without a frame, pieces could be laid outside by their straight sides and leave their own places open.
TEST(LongPuzzle, TracedPiecesLeaveNoHoleWithoutAFrame) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(143, CutStyle::tabs, 3)));
  for (Polygon& piece : puzzle.input.pieces) piece = traced(piece);
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_EQ(solution.placed, 143);
  EXPECT_EQ(right(solution, puzzle, 4), 143);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Puzzles, testing::Values(1));
INSTANTIATE_TEST_SUITE_P(LongSeeds, Puzzles, testing::Values(2, 3));

/// The seven pieces in a square of 400: two large triangles, a middle one, two small ones, a square, a parallelogram.
std::vector<Polygon> tangram() {
  std::vector<Polygon> cut = {{{0, 0}, {4, 0}, {2, 2}},        {{0, 0}, {2, 2}, {0, 4}},
                              {{4, 2}, {4, 4}, {2, 4}},        {{4, 0}, {4, 2}, {3, 1}},
                              {{2, 2}, {3, 3}, {1, 3}},        {{2, 2}, {3, 1}, {4, 2}, {3, 3}},
                              {{0, 4}, {1, 3}, {3, 3}, {2, 4}}};
  for (Polygon& piece : cut) {
    for (Vec2& p : piece) p = p * 100;
  }
  return cut;
}

class TangramFrames : public testing::TestWithParam<Polygon> {};

/// Any arrangement of the pieces is right.
TEST_P(TangramFrames, AreCoveredOnce) {
  Shuffled puzzle = shuffled(tangram());
  for (const Vec2 p : GetParam()) puzzle.input.frame.push_back(p * 100);
  ASSERT_NEAR(signed_area(puzzle.input.frame), 160'000, 100);
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  ASSERT_EQ(solution.placed, 7);
  std::vector<Polygon> laid = puzzle.input.pieces;
  for (std::size_t i = 0; i < laid.size(); ++i) {
    for (Vec2& p : laid[i]) p = solution.poses[i]->apply(p);
  }
  int inside = 0, right = 0;
  for (float y = -401.3f; y < 800; y += 9.7f) {
    for (float x = -401.7f; x < 800; x += 9.3f) {
      const auto holds = [&](const Polygon& piece) { return contains(piece, {x, y}); };
      const auto covered = std::count_if(laid.begin(), laid.end(), holds);
      const bool in_frame = contains(puzzle.input.frame, {x, y});
      inside += in_frame ? 1 : 0;
      right += in_frame && covered == 1 ? 1 : 0;
    }
  }
  EXPECT_GT(right, 0.97 * inside) << "but for points on boundaries, once";
}

/// The square; a triangle of its halves; these halves, shifted along their longest side.
/// The last one is a house of the two large triangles, with a roof of the others that is wider than the house.
INSTANTIATE_TEST_SUITE_P(Silhouettes, TangramFrames,
                         testing::Values(Polygon{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, Polygon{{-4, 0}, {4, 0}, {0, 4}},
                                         Polygon{{0, 0}, {4, 0}, {5, -1}, {5, 3}, {1, 3}, {0, 4}},
                                         Polygon{{-1.414214f, 0},
                                                 {1.414214f, 0},
                                                 {1.414214f, 2.828427f},
                                                 {2.828427f, 2.828427f},
                                                 {0, 5.656854f},
                                                 {-2.828427f, 2.828427f},
                                                 {-1.414214f, 2.828427f}}));

/// All pieces are alike, so their outlines give no information.
TEST_P(Puzzles, RectanglesAreLaidByTheirPictures) {
  CutRequest request = request_of(20, CutStyle::rectangles, std::uint64_t(GetParam()));
  request.height_px = 960;  // makes squares
  Shuffled puzzle = shuffled(cut_puzzle(request));
  ASSERT_EQ(puzzle.input.pieces.size(), 20u);
  EXPECT_LT(right(solve_puzzle(puzzle.input), puzzle), 10);
  paint(puzzle);
  EXPECT_EQ(right(solve_puzzle(puzzle.input), puzzle), 20);
  puzzle.input.frame = {{0, 0}, {1200, 0}, {1200, 960}, {0, 960}};
  EXPECT_EQ(right(solve_puzzle(puzzle.input), puzzle), 20);
}

TEST_P(Puzzles, PolygonsInAFrameWithPictures) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(36, CutStyle::polygons, std::uint64_t(GetParam()))));
  paint(puzzle);
  puzzle.input.frame = frame();
  EXPECT_EQ(right(solve_puzzle(puzzle.input), puzzle), 36);
}

TEST_P(Puzzles, TabsWithPictures) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(36, CutStyle::tabs, std::uint64_t(GetParam()))));
  paint(puzzle);
  EXPECT_EQ(right(solve_puzzle(puzzle.input), puzzle), 36);
}

TEST(Puzzle, WithAPieceMissingTheOthersAreLaid) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(20, CutStyle::tabs, 1)));
  puzzle.input.pieces.erase(puzzle.input.pieces.begin() + 7);
  puzzle.truth.erase(puzzle.truth.begin() + 7);
  EXPECT_EQ(right(solve_puzzle(puzzle.input), puzzle), 19);
}

TEST(Puzzle, APieceThatIsThereTwiceIsLaidOnce) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(20, CutStyle::tabs, 1)));
  puzzle.input.pieces.push_back(puzzle.input.pieces[7]);
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_EQ(solution.placed, 20);
  EXPECT_NE(bool(solution.poses[7]), bool(solution.poses[20]));
}

TEST(Puzzle, PiecesOfAnotherPuzzleFindNoPlace) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(20, CutStyle::tabs, 1)));
  const Shuffled other = shuffled(cut_puzzle(request_of(20, CutStyle::tabs, 2)));
  for (const std::size_t inner : {6u, 7u, 8u}) puzzle.input.pieces.push_back(other.input.pieces[inner]);
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_EQ(solution.placed, 20);
  for (std::size_t i = 20; i < solution.poses.size(); ++i) EXPECT_FALSE(solution.poses[i]) << i;
}

TEST(Puzzle, TheSameSolutionEachTime) {
  const Shuffled puzzle = shuffled(cut_puzzle(request_of(12, CutStyle::tabs, 5)));
  EXPECT_EQ(solve_puzzle(puzzle.input).poses, solve_puzzle(puzzle.input).poses);
}

TEST(Puzzle, FewOrShapelessPiecesAreNoError) {
  EXPECT_EQ(solve_puzzle({}).placed, 0);
  EXPECT_EQ(solve_puzzle({.pieces = {frame()}, .frame = {}}).placed, 1);
  Polygon disc;
  for (int k = 0; k < 64; ++k)
    disc.push_back({40 * std::cos(0.0981748f * float(k)), 40 * std::sin(0.0981748f * float(k))});
  const PuzzleSolution solution = solve_puzzle({.pieces = {disc, disc, disc}, .frame = frame()});
  EXPECT_LE(solution.placed, 1) << "no corners, nothing to go by";
}

/// The profile at a corner of a speck is shorter than the length that is compared.
TEST(Puzzle, ASpeckIsNoError) {
  PuzzleInput input = shuffled(cut_puzzle(request_of(12, CutStyle::tabs, 1))).input;
  Polygon drop = {{0, 30}};
  for (int k = 0; k <= 20; ++k) {
    const float angle = -0.6f + 0.2f * float(k);
    drop.push_back({8 * std::cos(angle + 3.7f), 8 * std::sin(angle + 3.7f)});
  }
  if (signed_area(drop) < 0) std::reverse(drop.begin(), drop.end());
  input.pieces.push_back(drop);
  input.pieces.push_back({{0, 0}, {5, 0}, {5, 5}, {0, 5}});
  EXPECT_GE(solve_puzzle(input).placed, 12);
}

/// Two large foreign pieces have the longest match of all, but no other piece fits them.
TEST(Puzzle, StrangersThatFitEachOtherDoNotWin) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(20, CutStyle::tabs, 1)));
  for (const float x : {0.f, 5000.f}) {
    puzzle.input.pieces.push_back(resampled_closed({{x, 0}, {x + 1500, 0}, {x + 1400, 300}, {x + 170, 210}}, 512));
  }
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  puzzle.truth.resize(22);
  EXPECT_EQ(right(solution, puzzle), 20);
}

/// The largest distance of a piece beyond the frame; negative if all lie inside.
float farthest_beyond(const PuzzleSolution& solution, const PuzzleInput& input) {
  const Box box = bounding_box(input.frame);
  const float times = float(solution.scale);
  float farthest = -INFINITY;
  for (std::size_t i = 0; i < solution.poses.size(); ++i) {
    if (!solution.poses[i]) continue;
    for (const Vec2 p : input.pieces[i]) {
      const Vec2 q = solution.poses[i]->apply(p) * times;
      farthest = std::max({farthest, box.low.x - q.x, q.x - box.high.x, box.low.y - q.y, q.y - box.high.y});
    }
  }
  return farthest;
}

/// The bound follows from the accuracy of outlines, for 12 pieces.
constexpr float kMostBeyond = 6;

Polygon frame_times(float times) {
  Polygon scaled = frame();
  for (Vec2& p : scaled) p = p * times;
  return scaled;
}

/// The area of the pieces suggests the frame. With a missing piece, the suggested frame would be too small.
TEST_P(Puzzles, TheScaleOfAFrameIsFound) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(12, CutStyle::tabs, std::uint64_t(GetParam()))));
  puzzle.input.frame = frame_times(0.957f);
  puzzle.input.frame_fits = false;
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_EQ(right(solution, puzzle), 12);
  EXPECT_NEAR(solution.scale, 0.957, 0.005);
  EXPECT_LT(farthest_beyond(solution, puzzle.input), kMostBeyond);
}

TEST(Puzzle, OneMissingAndOneForeignPieceDoNotSpoilTheScale) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(12, CutStyle::tabs, 3)));
  const Shuffled other = shuffled(cut_puzzle(request_of(12, CutStyle::tabs, 4)));
  puzzle.input.pieces.erase(puzzle.input.pieces.begin() + 2);
  puzzle.truth.erase(puzzle.truth.begin() + 2);
  puzzle.input.pieces.push_back(other.input.pieces[5]);
  puzzle.truth.emplace_back();
  puzzle.input.frame = frame_times(1.1f);
  puzzle.input.frame_fits = false;
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_NEAR(solution.scale, 1.1, 0.005);
  EXPECT_EQ(right(solution, puzzle), 11);
  EXPECT_LT(farthest_beyond(solution, puzzle.input), kMostBeyond);
}

/// Sawn and scanned pieces: smaller all round by an eightieth of a piece, at three quarters of the size.
constexpr float kSawn = 3.75f;
Shuffled sawn(Shuffled puzzle) {
  for (std::size_t i = 0; i < puzzle.input.pieces.size(); ++i) {
    puzzle.input.pieces[i] = grown_polygon(puzzle.input.pieces[i], -kSawn);
    for (Vec2& p : puzzle.input.pieces[i]) p = p * 0.75f;
    puzzle.truth[i] =
        Similarity{puzzle.truth[i]->a / 0.75f, puzzle.truth[i]->b / 0.75f, puzzle.truth[i]->tx, puzzle.truth[i]->ty};
  }
  return puzzle;
}

TEST_P(Puzzles, SawnPiecesAreGrownAndFit) {
  Shuffled puzzle = sawn(shuffled(cut_puzzle(request_of(12, CutStyle::tabs, std::uint64_t(GetParam())))));
  double area = 0;
  for (const Polygon& piece : puzzle.input.pieces) area += signed_area(piece);
  const float of_areas = float(std::sqrt(area / (kWidth_px * kHeight_px)));
  ASSERT_LT(of_areas, 0.74f);
  for (const float times :
       {0.f, 0.75f, of_areas}) {  // without a frame, in the right one, and in one that follows from the areas
    if (times > 0) puzzle.input.frame = frame_times(times);
    puzzle.input.frame_fits = times != of_areas;
    const PuzzleSolution solution = solve_puzzle(puzzle.input);
    EXPECT_EQ(solution.placed, 12) << times;
    EXPECT_EQ(right(solution, puzzle, 4), 12) << times;
    EXPECT_LT(solution.gaps, kMostPuzzleGaps) << times;
    EXPECT_NEAR(solution.erosion, kSawn * 0.75, 0.6) << times;
    if (times > 0) {
      EXPECT_LT(farthest_beyond(solution, puzzle.input), 1) << times;
      EXPECT_NEAR(solution.scale, times / 0.75f, 0.008) << times;
    }
  }
}

/// Straight sides do not show by how much they must grow. A frame of known size does; without one little is lost.
TEST_P(Puzzles, ErodedPolygonsAreLaid) {
  constexpr float kLost = 2.4f;  // one pixel, for pieces of 100 px
  const auto eroded = [&](int pieces, std::uint64_t seed) {
    Shuffled puzzle = shuffled(cut_puzzle(request_of(pieces, CutStyle::polygons, seed)));
    for (Polygon& piece : puzzle.input.pieces) piece = grown_polygon(piece, -kLost);
    return puzzle;
  };
  Shuffled puzzle = eroded(12, std::uint64_t(GetParam()));
  EXPECT_EQ(solve_puzzle(puzzle.input).placed, 12) << "without a frame, where gaps add up";
  puzzle.input.frame = frame();
  const PuzzleSolution in_frame = solve_puzzle(puzzle.input);
  EXPECT_EQ(right(in_frame, puzzle), 12);
  EXPECT_NEAR(in_frame.erosion, kLost, 0.2);
  EXPECT_LT(in_frame.gaps, kMostPuzzleGaps);
  puzzle.input.frame = frame_times(0.98f);
  puzzle.input.frame_fits = false;
  EXPECT_EQ(right(solve_puzzle(puzzle.input), puzzle, 8), 12) << "in a frame of some size";
}

TEST_P(Puzzles, WhetherPolygonsAreErodedIsNotToldByTheirBoundaries) {
  const Shuffled puzzle = shuffled(cut_puzzle(request_of(12, CutStyle::polygons, std::uint64_t(GetParam()))));
  std::vector<double> areas;
  for (const Polygon& piece : puzzle.input.pieces) areas.push_back(signed_area(piece));
  const PuzzleScale scale = PuzzleScale::of(areas);
  EXPECT_EQ(likely_erosions(puzzle.input.pieces, kWidth_px * kHeight_px, scale, [] {}).front(), 0);
  const std::vector<float> larger = likely_erosions(puzzle.input.pieces, 1.03 * kWidth_px * kHeight_px, scale, [] {});
  ASSERT_EQ(larger.size(), 4u) << "what fills the frame, none, and usual ones";
  EXPECT_GT(larger.front(), 1);
  EXPECT_EQ(larger[1], 0);
}

TEST_P(Puzzles, PiecesAsTheyWereCutAreNotGrown) {
  for (const CutStyle style : {CutStyle::tabs, CutStyle::polygons, CutStyle::rectangles}) {
    const Shuffled puzzle = shuffled(cut_puzzle(request_of(18, style, std::uint64_t(GetParam()))));
    std::vector<double> areas;
    for (const Polygon& piece : puzzle.input.pieces) areas.push_back(signed_area(piece));
    EXPECT_EQ(erosion_of(puzzle.input.pieces, PuzzleScale::of(areas), [] {}).value_or(0), 0);
  }
}

/// The frame is smaller than the puzzle, but counts as right.
TEST(Puzzle, NothingLiesBeyondASmallerFrame) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(20, CutStyle::tabs, 1)));
  puzzle.input.frame = frame();
  for (Vec2& p : puzzle.input.frame) p.x *= 0.7f;
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_LT(farthest_beyond(solution, puzzle.input), kMostBeyond);
  EXPECT_GE(solution.placed, 12) << "three of five columns";
  EXPECT_LT(solution.placed, 20);
}

TEST(Puzzle, NothingOfAnotherPuzzleLiesBeyondTheFrame) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(12, CutStyle::tabs, 2)));
  const Shuffled other = shuffled(cut_puzzle(request_of(20, CutStyle::tabs, 9)));
  for (std::size_t i = 0; i < 8; ++i) {
    puzzle.input.pieces.push_back(other.input.pieces[2 * i]);
    puzzle.truth.emplace_back();
  }
  puzzle.input.frame = frame();
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_LT(farthest_beyond(solution, puzzle.input), kMostBeyond);
  EXPECT_EQ(right(solution, puzzle), 12);
  EXPECT_EQ(solution.placed, 12) << "the frame is full";
}

TEST(Agreement, DoesNotAskWhereThePuzzleLies) {
  const std::vector<std::optional<Similarity>> truth = {Similarity{10, 0, 0, 0}, Similarity{20, 0, 100, 0},
                                                        Similarity{0, 10, 0, 80}};
  const Similarity moved{0.6f, 0.8f, 7, 9};
  std::vector<std::optional<Similarity>> found;
  for (const auto& pose : truth) found.push_back(followed_by(*pose, moved));
  EXPECT_EQ(agreement(found, truth).right, 3);
  EXPECT_NEAR(agreement(found, truth).worst_px, 0, 1e-3);
  found[1]->tx += 2.5f;
  EXPECT_EQ(agreement(found, truth).right, 2) << "too far";
  EXPECT_EQ(agreement(found, truth).laid, 3);
  EXPECT_NEAR(agreement(found, truth).worst_px, 0, 1e-3);
  EXPECT_NEAR(agreement(found, truth).farthest_px, 2.5, 1e-3) << "of all, not of the right ones alone";
  found[1] = followed_by(*truth[1], moved);
  found[1] = Similarity{found[1]->a * 1.02f, found[1]->b * 1.02f, found[1]->tx, found[1]->ty};
  EXPECT_EQ(agreement(found, truth).right, 2) << "too large";
  found[1] = followed_by(Similarity{std::cos(0.03f) * 20, std::sin(0.03f) * 20, 100, 0}, moved);
  EXPECT_EQ(agreement(found, truth).right, 2) << "turned too far";
  found[1].reset();
  EXPECT_EQ(agreement(found, truth).right, 2) << "not there";
}

}  // namespace test_puzzle
}  // namespace tessera
