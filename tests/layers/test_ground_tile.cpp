// The picture below the pieces: the size of its tiles, and how they meet, in pixels and as vectors.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "job/canvas/canvas_file.h"
#include "render/canvas_drawing.h"
#include "render/ground_strips.h"
#include "support/artwork_samples.h"
#include "support/images.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"
#include "support/svg_samples.h"

namespace tessera {
namespace test_ground_tile {

using namespace test;

const cv::Vec3b kBackground(0xc0, 0xe0, 0xff);

/// Noise, of which no two parts are alike.
cv::Mat noise(cv::Size size) {
  cv::Mat bgr(size, CV_8UC3);
  cv::RNG(7).fill(bgr, cv::RNG::UNIFORM, 0, 256);
  return bgr;
}

/// The canvas of 200 x 100 px without pieces, drawn at 1 px per canvas px.
struct WithGround : SampleCollage {
  WithGround() {
    report.placements.clear();
    report.output.width_px = 200;
  }
  void lay(const cv::Mat& picture, double width_px = 0, const char* name = "ground.png") {
    lay_file(folder.path(name), width_px, [&] { ASSERT_TRUE(test::write_image(folder.path(name), picture)); });
  }
  template <class Write>
  void lay_file(const std::string& path, double width_px, const Write& write) {
    write();
    report.output.ground = path;
    report.output.ground_px = width_px;
    Drawers drawers(canvas_drawer_settings(job.canvas));
    report.ground = draw_ground(report.output, canvas, drawers);
  }
  ScratchFolder folder;
};

double largest_difference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

TEST(Ground, TilesAreAsLargeAsDrawnOrAsWideAsIsAsked) {
  const Canvas canvas = make_rectangle_canvas(200, 100);
  EXPECT_EQ(tile_size_px({60, 30}, 0, canvas), cv::Size2d(60, 30));
  EXPECT_EQ(tile_size_px({60, 30}, 90, canvas), cv::Size2d(90, 45));
  EXPECT_EQ(tile_size_px({8192, 1}, 1e-300, canvas), cv::Size2d(1, 1)) << "no tile is smaller than a px";
}

TEST(Ground, MayBeALine) {
  WithGround along, down;
  along.lay(noise({8192, 1}));
  down.lay(noise({1, 8192}));
  EXPECT_FALSE(along.report.ground.page.empty());
  EXPECT_FALSE(down.report.ground.page.empty());
}

TEST(Ground, AWholeNumberOfTilesFitsIntoASeamlessCanvas) {
  EXPECT_EQ(tile_size_px({60, 30}, 0, make_seamless_canvas(200, 100, true, true)), cv::Size2d(200. / 3, 100. / 3));
  EXPECT_EQ(tile_size_px({60, 30}, 0, make_seamless_canvas(200, 100, true, false)), cv::Size2d(200. / 3, 30));
  EXPECT_EQ(tile_size_px({60, 30}, 0, make_seamless_canvas(200, 100, false, true)), cv::Size2d(60, 100. / 3));
  EXPECT_EQ(tile_size_px({50, 25}, 0, make_seamless_canvas(200, 100, true, true)), cv::Size2d(50, 25));
  EXPECT_EQ(tile_size_px({900, 900}, 0, make_seamless_canvas(200, 100, true, true)), cv::Size2d(200, 100));
}

TEST(Ground, AtItsOwnSizeItIsShownPixelByPixel) {
  WithGround collage;
  const cv::Mat tile = noise({50, 20});
  collage.lay(tile);
  cv::Mat tiles;
  cv::repeat(tile, 5, 4, tiles);
  EXPECT_EQ(largest_difference(drawn_picture(collage.report), tiles), 0);
}

TEST(Ground, DoesNotDependOnTheBands) {
  WithGround collage;
  collage.report.output.width_px = 800;
  collage.lay(noise({37, 23}));
  DrawnCollage drawn(collage.report);
  EXPECT_EQ(largest_difference(drawn.picture({.band_rows = 64}), drawn.picture()), 0);
}

TEST(Ground, ShownSmallerItIsAveraged) {
  WithGround collage;
  cv::Mat stripes(40, 40, CV_8UC3);
  for (int x = 0; x < 40; ++x) stripes.col(x).setTo(x % 2 == 0 ? cv::Scalar::all(0) : cv::Scalar::all(255));
  collage.lay(stripes, 10);
  cv::Scalar mean, deviation;
  cv::meanStdDev(drawn_picture(collage.report), mean, deviation);
  EXPECT_NEAR(mean[1], 127.5, 1);
  EXPECT_LT(deviation[1], 1);
}

/// The tiles have 66.7 x 33.3 px. At its right and lower edge the picture continues at the left and upper edge.
TEST(Ground, OnASeamlessCanvasHasNoSeam) {
  WithGround collage;
  collage.canvas = make_seamless_canvas(200, 100, true, true);
  cv::Mat tile(30, 60, CV_8UC3);
  for (int y = 0; y < tile.rows; ++y) {
    for (int x = 0; x < tile.cols; ++x) {
      const double wave = std::cos(2 * CV_PI * x / tile.cols) + std::cos(2 * CV_PI * y / tile.rows);
      tile.at<cv::Vec3b>(y, x) = cv::Vec3b::all(std::uint8_t(128 + 60 * wave));
    }
  }
  collage.lay(tile);
  const cv::Mat picture = drawn_picture(collage.report);
  cv::Mat twice;
  cv::repeat(picture, 2, 2, twice);
  EXPECT_GT(largest_difference(picture.col(0), picture.col(33)), 50);
  EXPECT_LT(largest_difference(twice(cv::Rect(199, 0, 1, 200)), twice(cv::Rect(200, 0, 1, 200))), 9);
  EXPECT_LT(largest_difference(twice(cv::Rect(0, 99, 400, 1)), twice(cv::Rect(0, 100, 400, 1))), 18);
}

TEST(Ground, LiesWithinTheCanvasBelowThePieces) {
  WithGround collage;
  collage.place(ShapeId{7}, 40, {100, 50}, 0);
  collage.report.canvas_edge.curves = {{{50, 0}, {150, 0}, {150, 100}, {50, 100}}};
  collage.lay(cv::Mat(10, 10, CV_8UC3, cv::Scalar(10, 20, 30)));
  const cv::Mat picture = drawn_picture(collage.report);
  EXPECT_EQ(picture.at<cv::Vec3b>(50, 60), cv::Vec3b(10, 20, 30));
  EXPECT_EQ(picture.at<cv::Vec3b>(50, 40), cv::Vec3b(255, 255, 255));
  EXPECT_NEAR(picture.at<cv::Vec3b>(50, 100)[0], 145, 3) << "the disc's grey";
  EXPECT_LT(mean_difference(picture, drawn(drawn_svg(collage.report), 200)), 0.5);
}

TEST(Ground, WithoutABackgroundItIsAllThatLiesBelowThePieces) {
  WithGround collage;
  collage.report.output.background = kNoColour;
  collage.report.canvas_edge.curves = {{{50, 0}, {150, 0}, {150, 100}, {50, 100}}};
  cv::Mat half(10, 10, CV_8UC4, cv::Scalar(10, 20, 30, 255));
  half.rowRange(5, 10).setTo(cv::Scalar::all(0));
  collage.lay(half);
  const cv::Mat picture = drawn_picture(collage.report);
  ASSERT_EQ(picture.type(), CV_8UC4);
  EXPECT_EQ(picture.at<cv::Vec4b>(52, 60), cv::Vec4b(10, 20, 30, 255));
  EXPECT_EQ(picture.at<cv::Vec4b>(57, 60), cv::Vec4b()) << "its own transparency";
  EXPECT_EQ(picture.at<cv::Vec4b>(52, 40), cv::Vec4b()) << "outside of the canvas";
  const std::string svg = drawn_svg(collage.report);
  EXPECT_NE(svg.find("layer-canvas"), std::string::npos);
  EXPECT_EQ(svg.find("fill=\"#ffffff\""), std::string::npos);
}

TEST(Ground, ItsTransparentPartsShowTheBackground) {
  WithGround collage;
  cv::Mat half(10, 10, CV_8UC4, cv::Scalar(10, 20, 30, 255));
  half.rowRange(5, 10).setTo(cv::Scalar(10, 20, 30, 0));
  collage.lay(half);
  const cv::Mat picture = drawn_picture(collage.report);
  EXPECT_EQ(picture.at<cv::Vec3b>(52, 60), cv::Vec3b(10, 20, 30));
  EXPECT_EQ(picture.at<cv::Vec3b>(57, 60), kBackground);
  EXPECT_LT(mean_difference(picture, drawn(drawn_svg(collage.report), 200)), 1);
}

TEST(Ground, OfARegionWithABackgroundOfItsOwnIsThat) {
  WithGround collage;
  collage.report.canvas_edge.curves = {{{0, 0}, {200, 0}, {200, 100}, {0, 100}}};
  collage.report.canvas_edge.grounds = {{{{{-4, -4}, {108, -4}, {108, 104}, {-4, 104}}}, "#205080"},
                                        {{{{100, -4}, {204, -4}, {204, 104}, {100, 104}}}, ""}};
  collage.lay(cv::Mat(10, 10, CV_8UC3, cv::Scalar(10, 20, 30)));
  const cv::Mat picture = drawn_picture(collage.report);
  EXPECT_EQ(picture.at<cv::Vec3b>(50, 50), cv::Vec3b(0x80, 0x50, 0x20));
  EXPECT_EQ(picture.at<cv::Vec3b>(50, 104), cv::Vec3b(10, 20, 30)) << "where the first goes on beneath the second";
  EXPECT_EQ(picture.at<cv::Vec3b>(50, 150), cv::Vec3b(10, 20, 30));
  EXPECT_LT(mean_difference(picture, drawn(drawn_svg(collage.report), 200)), 0.5);
}

TEST(Ground, IsAPatternOfTheSvg) {
  WithGround collage;
  cv::Mat tile;
  cv::GaussianBlur(noise({40, 20}), tile, {}, 3, 3, cv::BORDER_REFLECT);
  collage.lay(tile, 50);
  const std::string svg = drawn_svg(collage.report);
  EXPECT_NE(
      svg.find("<pattern id=\"ground\" patternUnits=\"userSpaceOnUse\" width=\"50.0000000\" height=\"25.0000000\""),
      std::string::npos);
  EXPECT_EQ(count(svg, "url(#ground)"), 1u);
  EXPECT_LT(mean_difference(drawn_picture(collage.report), drawn(svg, 200)), 3);
}

TEST(Ground, MayBeADrawing) {
  WithGround collage;
  const std::string stripes = std::string(kXmlns) +
                              "width=\"40\" height=\"20\"><rect width=\"20\" height=\"20\" id=\"a0\""
                              " fill=\"#102030\"/></svg>";
  collage.lay_file(collage.folder.path("ground.svg"), 0, [&] { collage.folder.write("ground.svg", stripes); });
  const cv::Mat picture = drawn_picture(collage.report);
  EXPECT_EQ(picture.at<cv::Vec3b>(30, 90), cv::Vec3b(0x30, 0x20, 0x10));
  EXPECT_EQ(picture.at<cv::Vec3b>(30, 70), kBackground);
  const std::string svg = drawn_svg(collage.report);
  EXPECT_EQ(svg.find("<image"), std::string::npos) << "vectors stay vectors";
  EXPECT_EQ(count(svg, "id=\"a0\""), 1u) << "ids of a drawing are its own";
  EXPECT_EQ(count(svg, "id=\"ground-drawing-a0\""), 1u);
  EXPECT_LT(mean_difference(picture, drawn(svg, 200)), 0.5);
}

/// The drawing has 10 x 5.5 units. Its last row of pixels is half empty and would be a line between the tiles.
TEST(Ground, TilesOfADrawingMeet) {
  WithGround collage;
  const std::string page = std::string(kXmlns) +
                           "width=\"10\" height=\"5.5\"><rect width=\"10\" height=\"5.5\" "
                           "fill=\"#102030\"/></svg>";
  collage.lay_file(collage.folder.path("ground.svg"), 0, [&] { collage.folder.write("ground.svg", page); });
  const cv::Mat picture = drawn_picture(collage.report);
  EXPECT_EQ(largest_difference(picture, cv::Mat(picture.size(), CV_8UC3, cv::Scalar(0x30, 0x20, 0x10))), 0);
}

/// A photo that fills its frame is allowed here, though `library build` refuses it.
TEST(Ground, MayBeAPhoto) {
  WithGround collage;
  cv::Mat photo;
  cv::GaussianBlur(noise({50, 50}), photo, {}, 4);
  collage.lay(photo, 0, "ground.jpg");
  EXPECT_LT(mean_difference(drawn_picture(collage.report)(cv::Rect(0, 0, 50, 50)), photo), 3);
}

TEST(Ground, ThatCannotBeReadIsAnErrorOfItsKey) {
  WithGround collage;
  const auto message = [&](const std::string& path) {
    collage.report.output.ground = path;
    return message_of([&] { check_canvas_drawing(collage.job.canvas, collage.report.output, collage.canvas); });
  };
  const std::string missing = collage.folder.path("none.png");
  EXPECT_EQ(message(missing).find("output.ground: " + missing + ": "), 0u) << message(missing);
  EXPECT_NE(message(collage.folder.write("text.png", "no image")).find("neither SVG nor a readable PNG"),
            std::string::npos);
  EXPECT_NE(message(collage.folder.path("")).find("output.ground: "), std::string::npos) << "a folder";
  const std::string wide = collage.folder.path("wide.png");
  ASSERT_TRUE(test::write_image(wide, cv::Mat(1, 8193, CV_8UC1, cv::Scalar(0))));
  EXPECT_NE(message(wide).find("8193 x 1 pixels, allowed: 8192 px each way"), std::string::npos) << message(wide);
  EXPECT_EQ(message(""), "");
}

TEST(Ground, Of16BitsAChannelIsShownWith8) {
  WithGround collage;
  collage.lay(cv::Mat(10, 10, CV_16UC4, cv::Scalar(10 * 257, 20 * 257, 30 * 257, 65535)));
  EXPECT_EQ(drawn_picture(collage.report).at<cv::Vec3b>(50, 60), cv::Vec3b(10, 20, 30));
}

}  // namespace test_ground_tile
}  // namespace tessera
