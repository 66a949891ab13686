// The mirror image of a shape equals what a library build would make of the mirrored outline.
#include "core/shape/mirrored_shape.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/polygon.h"
#include "core/shape/shape_contradiction.h"
#include "core/shape/shape_field.h"
#include "support/synthetic_library.h"

namespace tessera {
namespace test_mirrored_shape {

constexpr int kPadLevels = PadParameters{}.levels;

/// Blobs, and shapes with a hole, with spikes and with a dent.
const std::vector<Shape>& shapes() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> all = test::synthetic_library(12);
    for (Shape& shape : all) shape.field = make_shape_field(shape.outline);
    return all;
  }();
  return shapes;
}

double area_of(const Outline& outline) {
  double area = 0;
  for (const std::vector<Vec2>& curve : outline.curves) area += signed_area(curve);
  return area;
}

TEST(MirroredShape, OfTheMirrorImageIsTheShape) {
  for (const Shape& shape : shapes()) {
    const Shape twice = mirror_image(mirror_image(shape, kPadLevels), kPadLevels);
    EXPECT_EQ(twice.outline, shape.outline);
    EXPECT_EQ(twice.field.distance.data(), shape.field.distance.data());
    EXPECT_FALSE(twice.artwork.mirrored);
    for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) {
      EXPECT_EQ(twice.levels[k].points, shape.levels[k].points);
      EXPECT_EQ(twice.levels[k].samples, shape.levels[k].samples);
    }
  }
}

TEST(MirroredShape, LiesOnTheOtherSideWithItsInteriorOnTheLeft) {
  for (const Shape& shape : shapes()) {
    const Shape image = mirror_image(shape, kPadLevels);
    EXPECT_TRUE(image.artwork.mirrored);
    EXPECT_NEAR(area_of(image.outline), area_of(shape.outline), 1e-4) << "positive, as that of the shape";
    for (const Vec2 p : shape.outline.curves.front()) EXPECT_NEAR(image.field.at({-p.x, p.y}), 0, 0.02);
    EXPECT_EQ(shape_contradiction(image), "");
  }
}

/// A walk along the mirrored curve meets the same lengths and turnings, so the PADs are equal to the bit.
TEST(MirroredShape, HasThePadsOfTheMirroredCurve) {
  for (const Shape& shape : shapes()) {
    const Shape image = mirror_image(shape, kPadLevels);
    for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) {
      const SmoothingLevel& level = kSmoothingLevels[k];
      EXPECT_EQ(image.levels[k].samples, sample_pyramids(image.levels[k].points, level.sigma, level.samples, {}));
      EXPECT_NE(image.levels[k].samples, shape.levels[k].samples) << "of a shape without symmetry they are others";
    }
  }
}

/// The lengths are summed in another order.
TEST(MirroredShape, IsWhatTheMirroredOutlineGivesWithinRounding) {
  for (const Outline& outline :
       {test::star_outline(5), test::bean_outline(), test::ring_outline(), test::blob_outline(3)}) {
    Outline mirrored = outline;
    for (std::vector<Vec2>& curve : mirrored.curves) {
      for (Vec2& p : curve) p.x = -p.x;
      std::reverse(curve.begin() + 1, curve.end());
    }
    const Shape image = mirror_image(test::make_library_shape("image", outline), kPadLevels);
    const Shape afresh = test::make_library_shape("afresh", mirrored);
    for (std::size_t c = 0; c < outline.curves.size(); ++c) {
      const std::vector<Vec2>& points = image.outline.curves[c];
      for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT(norm(points[i] - afresh.outline.curves[c][i]), 1e-4f);
    }
    for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) {
      EXPECT_NEAR(image.levels[k].perimeter, afresh.levels[k].perimeter, 1e-4f);
      for (std::size_t j = 0; j < image.levels[k].samples.size(); ++j) {
        const Pad pad = make_pad(image.levels[k].samples[j], kPadLevels);
        EXPECT_LT(pad_distance(pad, make_pad(afresh.levels[k].samples[j], kPadLevels), kPadLevels), 0.03f)
            << "level " << k << " sample " << j;
      }
    }
  }
}

TEST(MirroredShape, HasTheFieldOfItsOutline) {
  for (const Shape& shape : shapes()) {
    const Shape image = mirror_image(shape, kPadLevels);
    const Grid<float> field = make_shape_field(image.outline).distance;
    for (std::size_t i = 0; i < field.data().size(); ++i)
      EXPECT_NEAR(image.field.distance.data()[i], field.data()[i], 1e-5f);
  }
}

TEST(MirroredShape, PartsThatWereNotReadStayEmpty) {
  Shape named;
  named.name = "cat";
  const Shape image = mirror_image(named, kPadLevels);
  EXPECT_EQ(image.name, "cat");
  EXPECT_TRUE(image.outline.curves.empty());
  EXPECT_TRUE(image.levels[0].samples.empty());
}

}  // namespace test_mirrored_shape
}  // namespace tessera
