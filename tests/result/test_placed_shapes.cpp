// Placed shapes are found by their ids, mirror images by the shape that they are drawn from.
#include "result/placed_shapes.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tessera {
namespace test_placed_shapes {

Shape named(const std::string& name, bool mirrored = false) {
  Shape shape;
  shape.name = name;
  shape.artwork.mirrored = mirrored;
  return shape;
}

TEST(PlacedShapes, AreFoundByTheirIdsInAnyOrder) {
  PlacedShapes shapes;
  shapes.add(ShapeId{7}, named("disc"));
  shapes.add(ShapeId{3}, named("ring"));
  EXPECT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes.slot_of(ShapeId{7}), 0u);
  EXPECT_EQ(shapes.slot_of(ShapeId{3}), 1u);
  EXPECT_EQ(shapes[1].name, "ring");
  EXPECT_EQ(shapes.names(), (std::vector<std::string>{"disc", "ring"}));
  EXPECT_THROW(shapes.slot_of(ShapeId{0}), std::out_of_range);
}

TEST(PlacedShapes, MirrorImagesHaveTheDrawingOfTheirName) {
  PlacedShapes shapes;
  shapes.add(ShapeId{9}, named("flag", true));
  shapes.add(ShapeId{1}, named("disc"));
  shapes.add(ShapeId{2}, named("flag"));
  shapes.add(ShapeId{8}, named("ring", true));
  EXPECT_EQ(shapes.slot_of_drawing(0), 2u) << "whichever was added first";
  EXPECT_EQ(shapes.slot_of_drawing(1), 1u);
  EXPECT_EQ(shapes.slot_of_drawing(2), 2u);
  EXPECT_EQ(shapes.slot_of_drawing(3), 3u) << "which stands mirrored only";
}

}  // namespace test_placed_shapes
}  // namespace tessera
