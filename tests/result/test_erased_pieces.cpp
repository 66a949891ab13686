// The pieces that a user marks by drawing over a collage.
#include "result/erased_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "support/images.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_erased_pieces {

PlacedPiece placed_at(float x, float y) { return {"a", {10, 0, x, y}}; }

JudgedPiece square_at(float x, float y, float side_px) {
  const float r = side_px / 2;
  return {{{{{x - r, y - r}, {x + r, y - r}, {x + r, y + r}, {x - r, y + r}}}}, "a", {x, y}, double(side_px)};
}

TEST(ErasedPieces, ARectangleMeansThoseWithTheirCentreInIt) {
  const std::vector<PlacedPiece> pieces = {placed_at(20, 30), placed_at(60, 31), placed_at(39, 70), placed_at(40, 10)};
  EXPECT_EQ(pieces_in({{20, 10}, {40, 50}}, pieces), (std::vector<int>{0, 3})) << "its edges belong to it";
  EXPECT_TRUE(pieces_in({{0, 0}, {10, 10}}, pieces).empty());
}

/// A mask with two cells per px.
Grid<float> marked(int x0, int y0, int x1, int y1) {
  Grid<float> mask(400, 200, 0.f);
  for (int y = 2 * y0; y < 2 * y1; ++y) std::fill(mask.row(y) + 2 * x0, mask.row(y) + 2 * x1, 1.f);
  return mask;
}

TEST(ErasedPieces, AScribbleMeansThoseThatItTouches) {
  const Canvas canvas = make_rectangle_canvas(200, 100);
  const std::vector<JudgedPiece> pieces = {square_at(30, 50, 40), square_at(80, 50, 40), square_at(150, 50, 60)};
  EXPECT_EQ(pieces_under(marked(40, 48, 70, 50), pieces, canvas), (std::vector<int>{0, 1})) << "a line across two";
  EXPECT_EQ(pieces_under(marked(48, 49, 52, 50), pieces, canvas), std::vector<int>{}) << "2 px² of the first";
  EXPECT_EQ(pieces_under(marked(46, 49, 50, 50), pieces, canvas), std::vector<int>{0}) << "4 px² of it";
  EXPECT_TRUE(pieces_under(marked(102, 0, 118, 100), pieces, canvas).empty()) << "between them";
  const std::vector<JudgedPiece> tiny = {square_at(30, 50, 1)};
  EXPECT_EQ(pieces_under(marked(29, 49, 31, 51), tiny, canvas).size(), 1u) << "all of a small one";
}

TEST(ErasedPieces, APieceOnASeamIsTouchedAtBothEnds) {
  const Canvas canvas = make_seamless_canvas(200, 100, true, false);
  const std::vector<JudgedPiece> pieces = {square_at(195, 50, 40)};
  EXPECT_EQ(pieces_under(marked(2, 40, 8, 60), pieces, canvas).size(), 1u);
  EXPECT_EQ(pieces_under(marked(180, 40, 190, 60), pieces, canvas).size(), 1u);
  EXPECT_TRUE(pieces_under(marked(60, 40, 90, 60), pieces, canvas).empty());
}

std::string svg(int width, int height, const std::string& inside) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(width) + "\" height=\"" +
         std::to_string(height) + "\">" + inside + "</svg>";
}

TEST(ErasedPieces, AMaskIsLaidOverTheCanvasWhateverItsSize) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("mask.svg", svg(400, 200, "<rect x='100' y='50' width='40' height='20'/>"));
  const Canvas canvas = make_rectangle_canvas(200, 100);
  const Grid<float> mask = erasing_mask(file, "--erase", canvas).cells;
  ASSERT_EQ(mask.width(), 400);
  ASSERT_EQ(mask.height(), 200);
  EXPECT_GE(mask(120, 60), 0.5f);
  EXPECT_LT(mask(90, 60), 0.5f);
  EXPECT_LT(mask(120, 80), 0.5f);
}

/// The picture that the user draws over has a height in whole px.
TEST(ErasedPieces, AMaskMayBeAsSmallAsACollagesPicture) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("mask.svg", svg(100, 70, "<rect x='10' y='5' width='40' height='20'/>"));
  const Canvas canvas = make_rectangle_canvas(2000, 1401);
  const Grid<float> mask = erasing_mask(file, "--erase", canvas).cells;
  const std::vector<JudgedPiece> pieces = {square_at(500, 300, 50), square_at(1500, 1000, 50)};
  EXPECT_EQ(pieces_under(mask, pieces, canvas), std::vector<int>{0});
}

/// A picture like that of a collage: squares of many colours up to its edge, on white.
cv::Mat collage_picture() {
  cv::Mat picture(150, 300, CV_8UC3, cv::Scalar::all(255));
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 10; ++x) {
      const cv::Rect square(30 * x, 30 * y, 27, 27);
      picture(square).setTo(cv::Scalar(double(25 * x), double(50 * y), double(200 - 20 * x)));
    }
  }
  return picture;
}

class PaintedOverTest : public testing::Test {
 protected:
  PaintedOverTest() { test::write_image(picture_, collage_picture()); }

  ErasingMask mask_of(const std::string& name, const cv::Mat& painted) const {
    test::write_image(folder_.path(name), painted);
    return erasing_mask(folder_.path(name), "--erase", canvas_, picture_);
  }
  static float marked_part(const ErasingMask& mask) {
    const std::vector<float>& cells = mask.cells.data();
    return float(std::count_if(cells.begin(), cells.end(), [](float c) { return c >= 0.5f; })) / float(cells.size());
  }

  test::ScratchFolder folder_;
  std::string picture_ = folder_.path("collage.png");
  Canvas canvas_ = make_rectangle_canvas(300, 150);
};

/// The copy is a PNG, or a JPEG with its noise.
TEST_F(PaintedOverTest, OfACopyThatWasPaintedOverThePaintIsMeant) {
  for (const char* name : {"painted.png", "painted.jpg"}) {
    SCOPED_TRACE(name);
    cv::Mat painted = collage_picture();
    cv::line(painted, {40, 75}, {110, 75}, cv::Scalar(0, 255, 0), 6);
    const ErasingMask mask = mask_of(name, painted);
    EXPECT_TRUE(mask.is_opaque);
    EXPECT_GE(mask.cells(mask.cells.width() * 65 / 300, mask.cells.height() / 2), 0.5f);
    EXPECT_NEAR(marked_part(mask), 70.f * 6 / (300 * 150), 0.006f);
  }
}

/// Neither a painted copy of another picture nor a scribble on a separate page counts as paint.
TEST_F(PaintedOverTest, OfAnotherPictureNothingIsTakenForPaint) {
  cv::Mat other(150, 300, CV_8UC3);
  cv::randu(other, cv::Scalar::all(0), cv::Scalar::all(255));
  EXPECT_NE(test::message_of([&] { mask_of("other.png", other); }).find("that is no copy of collage.png"),
            std::string::npos);
  cv::Mat page(150, 300, CV_8UC3, cv::Scalar::all(255));
  cv::line(page, {40, 75}, {110, 75}, cv::Scalar(0, 255, 0), 6);
  EXPECT_NEAR(marked_part(mask_of("page.png", page)), 70.f * 6 / (300 * 150), 0.006f);
}

/// Its silhouette would be cut out as that of any drawing.
TEST_F(PaintedOverTest, OfACopyOnAPlainGroundThePaintIsMeantToo) {
  cv::Mat picture(150, 300, CV_8UC3, cv::Scalar::all(255));
  collage_picture()(cv::Rect(0, 0, 200, 100)).copyTo(picture(cv::Rect(50, 25, 200, 100)));
  test::write_image(picture_, picture);
  cv::line(picture, {100, 75}, {170, 75}, cv::Scalar(0, 255, 0), 6);
  EXPECT_NEAR(marked_part(mask_of("painted.png", picture)), 70.f * 6 / (300 * 150), 0.006f);
}

TEST_F(PaintedOverTest, WithoutPaintNothingIsMeant) {
  EXPECT_NE(test::message_of([&] { mask_of("same.png", collage_picture()); }).find("shows nothing"), std::string::npos);
}

TEST(ErasedPieces, WhatIsCoveredForTheMostPart) {
  const Canvas canvas = make_rectangle_canvas(200, 100);
  const std::vector<JudgedPiece> pieces = {square_at(30, 50, 40), square_at(80, 50, 40)};
  EXPECT_EQ(pieces_under(marked(10, 30, 70, 70), pieces, canvas, 0.5), std::vector<int>{0});
}

TEST(ErasedPieces, MasksThatCannotBeMeantAreErrors) {
  const test::ScratchFolder folder;
  const Canvas canvas = make_rectangle_canvas(200, 100);
  const auto mistake = [&](const std::string& file) {
    return test::message_of([&] { erasing_mask(file, "--erase", canvas); });
  };
  const std::string tall = folder.write("tall.svg", svg(100, 100, "<rect x='10' y='5' width='40' height='20'/>"));
  EXPECT_EQ(mistake(tall), "--erase " + tall + ": found another aspect: fitted into the canvas it has 100 x 100 px, " +
                               "needed: 200 x 100, as collage.png has it");
  const std::string empty = folder.write("empty.svg", svg(200, 100, ""));
  EXPECT_NE(mistake(empty), "");
  EXPECT_NE(mistake(folder.path("none.png")).find("none.png: not a readable file"), std::string::npos);
  EXPECT_NE(mistake(folder.write("text.png", "no picture")).find("text.png"), std::string::npos);
}

}  // namespace test_erased_pieces
}  // namespace tessera
