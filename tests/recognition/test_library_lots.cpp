// The lots in which a library is searched.
#include "recognition/library_lots.h"

#include <gtest/gtest.h>

namespace tessera {
namespace test_library_lots {

TEST(LibraryLots, AreAnEighthWithinLimits) {
  EXPECT_EQ(shapes_of_lot(0), 2048u);
  EXPECT_EQ(shapes_of_lot(16'384), 2048u);
  EXPECT_EQ(shapes_of_lot(16'385), 2049u);
  EXPECT_EQ(shapes_of_lot(100'000), 12'500u);
  EXPECT_EQ(shapes_of_lot(10'000'000), 16'384u);
}

TEST(LibraryLots, HoldEachShapeOnce) {
  EXPECT_TRUE(lots_of(0, 5).empty());
  const std::vector<ShapeRange> lots = lots_of(12, 5);
  ASSERT_EQ(lots.size(), 3u);
  std::uint32_t next = 0;
  for (const ShapeRange& lot : lots) {
    EXPECT_EQ(lot.begin, next);
    next = lot.end;
  }
  EXPECT_EQ(next, 12u);
  EXPECT_EQ(lots[1].end - lots[1].begin, 5u);
  EXPECT_EQ(lots_of(10, 5).size(), 2u);
}

TEST(LibraryLots, TogetherGiveTheBestOfAll) {
  std::vector<Recognition> best = {{ShapeId{3}, {}, 0.5f, 1}};
  keep_best(best, {{ShapeId{7}, {}, 0.5f, 1}, {ShapeId{9}, {}, 0.8f, 1}}, 2);
  ASSERT_EQ(best.size(), 2u);
  EXPECT_EQ(best[0].shape, ShapeId{9});
  EXPECT_EQ(best[1].shape, ShapeId{3});
}

}  // namespace test_library_lots
}  // namespace tessera
