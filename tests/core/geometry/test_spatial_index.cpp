// Queries by window, against a look at every entry.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

#include "core/field/edge_table.h"
#include "core/geometry/tile_index.h"

namespace tessera {
namespace test_spatial_index {

Window any_window(int low, int high) {
  const int x = *rc::gen::inRange(low, high);
  const int y = *rc::gen::inRange(low, high);
  return {x, y, x + *rc::gen::inRange(0, 90), y + *rc::gen::inRange(0, 90)};
}

TEST(EdgeTable, EqualsAMap) {
  EXPECT_TRUE(rc::check([] {
    constexpr int kWidth = 70;
    constexpr int kHeight = 50;
    EdgeTable table(kWidth, kHeight);
    std::map<std::uint32_t, int> expected;
    for (int i = 0; i < 300; ++i) {
      const GridEdge edge{*rc::gen::inRange(0, kWidth), *rc::gen::inRange(0, kHeight), *rc::gen::arbitrary<bool>()};
      const std::uint32_t number = edge.number(kWidth);
      RC_ASSERT(GridEdge::of(number, kWidth).number(kWidth) == number);
      RC_ASSERT(table.find(edge) == (expected.contains(number) ? expected[number] : EdgeTable::kNone));
      if (expected.contains(number)) {
        table.erase(edge);
        expected.erase(number);
      } else {
        table.insert(edge, i);
        expected[number] = i;
      }
    }
    const Window window = any_window(-30, 70);
    std::map<std::uint32_t, int> found;
    table.each(window,
               [&](const GridEdge& edge, int value) { RC_ASSERT(found.emplace(edge.number(kWidth), value).second); });
    std::erase_if(expected, [&](const auto& e) { return !GridEdge::of(e.first, kWidth).touches(window); });
    RC_ASSERT(found == expected);
  }));
}

TEST(TileIndex, FindsEveryThingWhoseRegionAWindowOverlaps) {
  EXPECT_TRUE(rc::check([] {
    TileIndex index;
    std::map<std::uint32_t, std::vector<Window>> regions;
    std::map<std::uint32_t, std::vector<TileIndex::Tile>> tiles;
    for (int i = 0; i < 40; ++i) {
      const std::uint32_t thing = *rc::gen::inRange(0u, 15u);
      TileIndex::Region region;
      regions[thing].resize(*rc::gen::inRange<std::size_t>(0, 4));
      for (Window& w : regions[thing]) region.add(w = any_window(-200, 200));
      std::vector<TileIndex::Tile> after = std::move(region).tiles();
      index.move(thing, tiles[thing], after);
      tiles[thing] = std::move(after);
    }
    const Window window = any_window(-200, 200);
    std::set<std::uint32_t> found;
    index.each(window, [&](std::uint32_t thing) { found.insert(thing); });
    for (const auto& [thing, windows] : regions) {
      for (const Window& w : windows) {
        if (!w.empty() && !window.empty() && w.overlaps(window)) RC_ASSERT(found.contains(thing));
      }
      if (windows.empty()) RC_ASSERT(!found.contains(thing));
    }
  }));
}

}  // namespace test_spatial_index
}  // namespace tessera
