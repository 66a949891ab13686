// The colours that pieces show within their outlines.
#include "render/pieces/drawn_colours.h"

#include <gtest/gtest.h>

#include "artwork/images/png_encoder.h"
#include "support/colours.h"
#include "support/sample_collage.h"

namespace tessera {
namespace test_drawn_colours {

/// A disc in the middle of a page of 96 px, as wide as the page.
struct DiscOnPage {
  DiscOnPage() : shape(test::make_test_shape("disc", test::disc_outline())) {
    test::embed_artwork(shape, "", 100, 100, 50 / shape.radius);
  }
  Shape shape;
  cv::Mat page{96, 96, CV_8UC4, cv::Scalar(0, 0, 0, 0)};
};

TEST(DrawnColours, AreMeansOfWhatLiesWithinTheOutline) {
  DiscOnPage disc;
  disc.page.colRange(0, 48).setTo(cv::Scalar(200, 100, 0, 255));
  disc.page.colRange(48, 96).setTo(cv::Scalar(0, 100, 200, 255));
  const DrawnColours colours = drawn_colours(disc.page, disc.shape);
  for (const std::size_t row : {0u, 1u, 2u, 3u}) {
    EXPECT_EQ(colours.bgr[4 * row], cv::Vec3d(200, 100, 0));
    EXPECT_EQ(colours.bgr[4 * row + 3], cv::Vec3d(0, 100, 200));
  }
  EXPECT_NEAR(colours.part[5], 1, 0.02);
  EXPECT_NEAR(colours.part[0], 0.315, 0.02) << "a corner of the disc";
}

TEST(DrawnColours, OfAMirrorImageLieTheOtherWayRound) {
  DiscOnPage disc;
  disc.shape.artwork.mirrored = true;
  disc.page.colRange(0, 48).setTo(cv::Scalar(200, 100, 0, 255));
  const DrawnColours colours = drawn_colours(disc.page, disc.shape);
  EXPECT_EQ(colours.bgr[7], cv::Vec3d(200, 100, 0));
  EXPECT_EQ(colours.part[4], 0);
}

/// Black lines on white: shrinking a picture averages the coded values, not the lightness.
TEST(DrawnColours, AreAveragedAsTheyAreCoded) {
  DiscOnPage disc;
  disc.page.setTo(cv::Scalar(255, 255, 255, 255));
  for (int x = 0; x < 96; x += 2) disc.page.col(x).setTo(cv::Scalar(0, 0, 0, 255));
  EXPECT_NEAR(drawn_colours(disc.page, disc.shape).bgr[5][1], 127.5, 1);
}

TEST(DrawnColours, OfTheLibraryStandInForAThumbnail) {
  Shape shape = test::make_test_shape("disc", test::disc_outline());
  for (const cv::Vec3d& bgr : drawn_colours(shape).bgr) EXPECT_EQ(bgr, cv::Vec3d(145, 145, 145)) << "the mean";
  shape.colour_grid = test::two_toned_grid({0, 0, 0}, {100, 0, 0});
  EXPECT_EQ(drawn_colours(shape).bgr[4], cv::Vec3d(0, 0, 0));
  EXPECT_EQ(drawn_colours(shape).bgr[7], cv::Vec3d(255, 255, 255));
  PlacedShapes shapes;
  shapes.add(ShapeId{1}, shape);
  Drawers drawers({.processes = 1});
  EXPECT_EQ(drawn_colours(shapes, drawers)[0].bgr[7], cv::Vec3d(255, 255, 255));
  shape.artwork.thumbnail_png = png_of(cv::Mat(96, 96, CV_8UC4, cv::Scalar::all(0)));
  PlacedShapes unseen;
  unseen.add(ShapeId{1}, shape);
  EXPECT_EQ(drawn_colours(unseen, drawers)[0].bgr[7], cv::Vec3d(255, 255, 255)) << "nothing of it is seen";
  shape.artwork.thumbnail_png = {1, 2, 3};
  PlacedShapes damaged;
  damaged.add(ShapeId{1}, shape);
  EXPECT_EQ(drawn_colours(damaged, drawers)[0].bgr[7], cv::Vec3d(255, 255, 255));
}

}  // namespace test_drawn_colours
}  // namespace tessera
