// A library enlarged beyond its file by varied shapes.
#include "bench/inputs/varied_shapes.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "bench/formula_library.h"
#include "core/geometry/polygon.h"
#include "core/matching/matching_context.h"

namespace tessera::bench {
namespace test_varied_shapes {

TEST(VariedShapes, VariationsAreDistinctAndMild) {
  std::set<std::tuple<bool, float, float>> seen;
  for (std::uint32_t number = 0; number < 1000; ++number) {
    const ShapeVariation v = variation_number(number);
    EXPECT_TRUE(seen.insert({v.mirrored, v.angle_rad, v.factor}).second) << number;
    EXPECT_GE(v.factor, 1);
    EXPECT_LE(v.factor, 1.5f);
  }
  EXPECT_FALSE(variation_number(0).mirrored);
  EXPECT_EQ(variation_number(0).factor, 1);
  EXPECT_TRUE(variation_number(1).mirrored);
  EXPECT_EQ(variation_number(1).factor, 1);
}

TEST(VariedShapes, AreValidAndTheSameWheneverAsked) {
  const test::FormulaLibrary file(3);
  const LibraryFile library(file.path());
  VariedShapes shapes(library);
  for (std::uint32_t index = 0; index < 12; ++index) {
    const ShapeId id{index};
    const std::vector<Vec2> outer = shapes.shape(id).outline.curves.front();
    EXPECT_NEAR(signed_area(outer), 1, 1e-4) << "area 1, interior on the left";
    EXPECT_EQ(VariedShapes(library).shape(id).outline.curves.front(), outer);
  }
  EXPECT_GT(shapes.making_s(), 0);
}

TEST(VariedShapes, ModelsAreThoseOfTheShapes) {
  const test::FormulaLibrary file(3);
  const LibraryFile library(file.path());
  VariedShapes shapes(library);
  const MatchingContext context = make_matching_context(CollageSettings(), 12);
  const std::vector<ShapeModel> models = shapes.models({4, 9}, context);
  ASSERT_EQ(models.size(), 5u);
  for (std::uint32_t i = 0; i < 5; ++i) {
    EXPECT_EQ(models[i].boundary, shapes.model(ShapeId{4 + i}).boundary);
    EXPECT_EQ(models[i].levels.size(), context.levels.size());
  }
}

}  // namespace test_varied_shapes
}  // namespace tessera::bench
