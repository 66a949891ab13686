// Pieces that are laid one after the other, and pieces that are removed again.
#include <gtest/gtest.h>

#include "cut_pieces.h"
#include "products/puzzle/laying/arrangement.h"

namespace tessera {
namespace test_arrangement {

constexpr int kPieces = 20;

/// A puzzle of tabs without a frame, with all pieces in their right places.
struct Laying {
  CutPieces cut{kPieces, CutStyle::tabs, 0};
  std::vector<std::vector<PieceMatch>> matches = piece_matches(cut.pieces, cut.scale, [](std::size_t) {});
  PuzzleArranger arranger{cut.pieces, matches, cut.scale, -1, [](std::size_t) {}};
  std::size_t count = cut.pieces.size();

  Arrangement all() const {
    Arrangement in;
    in.used.assign(count, true);
    for (std::size_t i = 0; i < count; ++i) in.laid.push_back({int(i), {1, 0, 0, 0}});
    return in;
  }

  /// The pose that moves the centre of piece `i` to the right place of piece `j`.
  Similarity at_place_of(std::size_t i, std::size_t j) const {
    const Vec2 off = cut.pieces[j].centre - cut.pieces[i].centre;
    return {1, 0, off.x, off.y};
  }
};

/// Returns whether the piece is in the middle part of the puzzle's edge y = 0.
bool at_upper_edge(const PuzzlePiece& piece) {
  const Box box = bounding_box(piece.points);
  return box.low.y < 1 && box.low.x > 1 && box.high.x < 1199;
}

bool lies(const Arrangement& in, int piece) {
  return std::any_of(in.laid.begin(), in.laid.end(), [&](const LaidPiece& laid) { return laid.piece == piece; });
}

TEST(Arrangement, PiecesThatLieWhereOthersBelongAreTakenOut) {
  const Laying laying;
  Arrangement right = laying.all();
  laying.arranger.drop_misfits(right);
  EXPECT_EQ(right.laid.size(), laying.count) << "what fits stays";

  Arrangement wrong = laying.all();
  const std::size_t i = 1, j = laying.count - 1;
  wrong.laid[i].pose = laying.at_place_of(i, j);
  wrong.laid[j].pose = laying.at_place_of(j, i);
  laying.arranger.drop_misfits(wrong);
  for (const std::size_t misfit : {i, j}) {
    EXPECT_FALSE(lies(wrong, int(misfit)));
    EXPECT_FALSE(wrong.used[misfit]) << "it may be laid again";
  }
  EXPECT_GE(wrong.laid.size(), laying.count - 2 - 8) << "their neighbours at most go with them";
  EXPECT_TRUE(lies(wrong, 0)) << "the first piece stays";
  EXPECT_EQ(laying.arranger.placed(wrong), wrong.laid.size());
}

TEST(Arrangement, PiecesThatHangOutsideByAStraightSideAreTakenOut) {
  const Laying laying;
  constexpr float kHalf = 0.5f;
  Arrangement right = laying.all();
  laying.arranger.drop_loose(kHalf, right);
  EXPECT_EQ(right.laid.size(), laying.count) << "corners and edges stay";

  // Most of the upper edge is turned as one part and laid upon its own place.
  Arrangement hanging = laying.all();
  std::vector<std::size_t> turned;
  for (std::size_t i = 1; i < laying.count; ++i) {
    if (!at_upper_edge(laying.cut.pieces[i])) continue;
    hanging.laid[i].pose = {-1, 0, 1200, 0};
    turned.push_back(i);
  }
  ASSERT_EQ(turned.size(), 3u);
  laying.arranger.drop_loose(kLeastTouching, hanging);
  EXPECT_EQ(hanging.laid.size(), laying.count) << "they touch each other, and the others by their straight sides";
  laying.arranger.drop_loose(kHalf, hanging);
  for (const std::size_t i : turned) EXPECT_FALSE(lies(hanging, int(i))) << i;
  EXPECT_GE(hanging.laid.size(), laying.count - turned.size() - 2) << "corners beside them at most go with them";
}

/// A second neighbour leads to the same place as the first one, not to another one.
TEST(Arrangement, AHoleIsOnePlaceOfEachPieceWithTheSidesOfAllMatches) {
  const Laying laying;
  std::size_t most = 0;
  for (std::size_t hole = 1; hole < laying.count; ++hole) {
    Arrangement in = laying.all();
    in.used[hole] = false;
    in.laid.erase(in.laid.begin() + std::ptrdiff_t(hole));
    laying.arranger.find_places(in);
    std::vector<PuzzlePlace> own;
    for (const PuzzlePlace& place : in.places) {
      const Vec2 centre = laying.cut.pieces[hole].centre;
      if (place.piece == int(hole) && norm(place.pose.apply(centre) - centre) < laying.cut.scale.tolerance)
        own.push_back(place);
    }
    ASSERT_EQ(own.size(), 1u) << hole;
    EXPECT_GE(own[0].whole_sides, 2) << hole;
    most = std::max(most, std::size_t(own[0].whole_sides));
    laying.arranger.lay(own[0], in);
    EXPECT_TRUE(laying.arranger.whole(in)) << hole;
    EXPECT_TRUE(in.places.empty()) << hole << ": no other place is left";
  }
  EXPECT_GE(most, 4u) << "a piece inside has four sides";
}

/// Places move while pieces are laid. Two places of a piece stay apart, or become one.
TEST(Arrangement, PlacesOfAPieceStayApart) {
  const Laying laying;
  Arrangement in = laying.arranger.beginning(0);
  while (!in.places.empty()) {
    for (std::size_t i = 0; i < in.places.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const PuzzlePlace &a = in.places[i], &b = in.places[j];
        if (a.piece != b.piece) continue;
        const Vec2 centre = laying.cut.pieces[std::size_t(a.piece)].centre;
        const bool turned = a.pose.a * b.pose.a + a.pose.b * b.pose.b < 0.995f;
        EXPECT_TRUE(turned || norm(a.pose.apply(centre) - b.pose.apply(centre)) >= 4 * laying.cut.scale.tolerance)
            << "piece " << a.piece << " with " << in.laid.size() << " laid";
      }
    }
    const auto best = std::max_element(in.places.begin(), in.places.end(),
                                       [](const PuzzlePlace& a, const PuzzlePlace& b) { return a.worth < b.worth; });
    laying.arranger.lay(PuzzlePlace(*best), in);
  }
  EXPECT_EQ(in.laid.size(), laying.count);
}

}  // namespace test_arrangement
}  // namespace tessera
