// Pictures cut up and laid together again.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/base/portable_math.h"
#include "core/geometry/closed_curve.h"
#include "core/geometry/polygon.h"
#include "core/puzzle/puzzle_contact.h"
#include "core/puzzle/puzzle_cut.h"
#include "core/puzzle/puzzle_solver.h"
#include "core/puzzle/puzzle_truth.h"

namespace tessera {
namespace {

using Polygon = std::vector<Vec2>;

constexpr int kWidth_px = 1200, kHeight_px = 900;

CutRequest request_of(int pieces, CutStyle style, std::uint64_t seed) {
  return {.width_px = kWidth_px, .height_px = kHeight_px, .pieces = pieces, .style = style, .seed = seed};
}

Polygon frame() { return {{0, 0}, {kWidth_px, 0}, {kWidth_px, kHeight_px}, {0, kHeight_px}}; }

/// The pieces as a library has them, 512 points each, turned and moved; and how each lay.
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

/// As shapes' poses: of the piece's centre, with its size. That is what agreement compares.
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

int right(const PuzzleSolution& solution, const Shuffled& puzzle) {
  return agreement(of_shapes(solution.poses, puzzle.input.pieces), of_shapes(puzzle.truth, puzzle.input.pieces)).right;
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

/// Wherever the grid ends up with long or narrow pieces.
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

class Puzzles : public testing::TestWithParam<int> {};

TEST_P(Puzzles, TabsAreLaidAsTheyWereCut) {
  const Shuffled puzzle = shuffled(cut_puzzle(request_of(36, CutStyle::tabs, std::uint64_t(GetParam()))));
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_EQ(solution.placed, 36);
  EXPECT_EQ(right(solution, puzzle), 36);
  EXPECT_LT(solution.gaps, 0.02);
  EXPECT_FALSE(solution.in_frame);
}

TEST_P(Puzzles, TabsInAFrame) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(20, CutStyle::tabs, std::uint64_t(GetParam()))));
  puzzle.input.frame = frame();
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_TRUE(solution.in_frame);
  EXPECT_EQ(right(solution, puzzle), 20);
  for (std::size_t i = 0; i < solution.poses.size(); ++i) {
    ASSERT_TRUE(solution.poses[i]);
    for (const Vec2 p : puzzle.input.pieces[i]) {
      const Vec2 q = solution.poses[i]->apply(p);
      EXPECT_GT(std::min({q.x, q.y, kWidth_px - q.x, kHeight_px - q.y}), -3) << "piece " << i << " leaves the frame";
    }
  }
}

/// Fig. 18's number of pieces. Their sides are straight, and any two may agree by chance.
TEST_P(Puzzles, PolygonsInAFrame) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(18, CutStyle::polygons, std::uint64_t(GetParam()))));
  puzzle.input.frame = frame();
  EXPECT_EQ(right(solve_puzzle(puzzle.input), puzzle), 18);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Puzzles, testing::Values(1, 2, 3));

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

/// A corner's profiles are shorter than what others are compared by.
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

/// Two large ones match longest of all, and nothing else fits them.
TEST(Puzzle, StrangersThatFitEachOtherDoNotWin) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(20, CutStyle::tabs, 1)));
  for (const float x : {0.f, 5000.f}) {
    puzzle.input.pieces.push_back(resampled_closed({{x, 0}, {x + 1500, 0}, {x + 1400, 300}, {x + 170, 210}}, 512));
  }
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  puzzle.truth.resize(22);
  EXPECT_EQ(right(solution, puzzle), 20);
}

/// The frame follows from the areas, and is too small for pieces of which one is missing.
TEST(Puzzle, AFrameOfAnotherSizeDoesNotSpoilWhatFits) {
  Shuffled puzzle = shuffled(cut_puzzle(request_of(12, CutStyle::tabs, 3)));
  puzzle.input.frame = frame();
  for (Vec2& p : puzzle.input.frame) p = p * 0.957f;
  const PuzzleSolution solution = solve_puzzle(puzzle.input);
  EXPECT_FALSE(solution.in_frame);
  EXPECT_EQ(right(solution, puzzle), 12);
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
  found[1] = followed_by(*truth[1], moved);
  found[1] = Similarity{found[1]->a * 1.02f, found[1]->b * 1.02f, found[1]->tx, found[1]->ty};
  EXPECT_EQ(agreement(found, truth).right, 2) << "too large";
  found[1] = followed_by(Similarity{std::cos(0.03f) * 20, std::sin(0.03f) * 20, 100, 0}, moved);
  EXPECT_EQ(agreement(found, truth).right, 2) << "turned too far";
  found[1].reset();
  EXPECT_EQ(agreement(found, truth).right, 2) << "not there";
}

}  // namespace
}  // namespace tessera
