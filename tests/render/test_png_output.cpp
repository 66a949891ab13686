// The picture: the places of artworks, the look of their edges, and the substitutes for lost artworks.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "core/base/stop.h"
#include "render/pieces/artwork_original.h"
#include "render/png_stream.h"
#include "render/tiff_pyramid.h"
#include "result/drawing_notes.h"
#include "support/artwork_samples.h"
#include "support/drawn_collage.h"
#include "support/images.h"
#include "support/planted_files.h"
#include "support/rank_breadth.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_png_output {

using test::drawn_picture;
using test::SampleCollage;

constexpr char kSvgHead[] =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" viewBox="0 0 100 100">)";

/// A page of 100 x 100 with a square of 80, red on its left half and blue on its right half.
const std::string kTwoHalves = std::string(kSvgHead) +
                               R"(<rect x="10" y="10" width="40" height="80" fill="red"/>)"
                               R"(<rect x="50" y="10" width="40" height="80" fill="blue"/></svg>)";

cv::Vec3b at(const cv::Mat& picture, int x, int y) { return picture.at<cv::Vec3b>(y, x); }

const cv::Vec3b kRed(0, 0, 255);
const cv::Vec3b kBlue(255, 0, 0);
const cv::Vec3b kBackground(0xc0, 0xe0, 0xff);

/// One square of 40 canvas px at (100, 50) of the 200 x 100 canvas; the picture is twice as large.
struct OneSquare : SampleCollage {
  explicit OneSquare(float rotation_rad) {
    report.shapes[0] = test::make_test_shape("square", test::rectangle_outline(1, 1));
    test::embed_artwork(report.shapes[0], kTwoHalves, 100, 100, 80);
    report.placements.clear();
    place(ShapeId{7}, 40, {100, 50}, rotation_rad);
  }
};

TEST(Png, ArtworkLiesWhereItIsPlaced) {
  const OneSquare sample(0);
  const cv::Mat picture = drawn_picture(sample.report);
  EXPECT_EQ(picture.size(), cv::Size(400, 200));
  EXPECT_EQ(at(picture, 161, 100), kRed);
  EXPECT_EQ(at(picture, 198, 61), kRed);
  EXPECT_EQ(at(picture, 201, 138), kBlue);
  EXPECT_EQ(at(picture, 238, 100), kBlue);
  EXPECT_EQ(at(picture, 158, 100), kBackground);
  EXPECT_EQ(at(picture, 241, 100), kBackground);
  EXPECT_EQ(at(picture, 200, 58), kBackground);
}

/// A collage and the same one moved by half a period give pictures of one pattern.
TEST(Png, ASeamlessCollageShowsPiecesAtBothEndsOfASeam) {
  const auto with_pieces_at = [](Vec2 shift, cv::Mat& picture, std::string& svg) {
    OneSquare sample(0.3f);
    sample.canvas = make_seamless_canvas(200, 100, true, true);
    sample.report.placements.clear();
    for (const Vec2 centre : {Vec2{195, 50}, Vec2{3, 97}, Vec2{100, 2}, Vec2{60, 50}}) {
      const Vec2 at = sample.canvas.period.wrapped(centre + shift);
      sample.place(ShapeId{7}, 40, at, 0.3f);
    }
    picture = drawn_picture(sample.report);
    svg = test::drawn_svg(sample.report);
  };
  cv::Mat here, there, difference;
  std::string svg;
  with_pieces_at({0, 0}, here, svg);
  std::size_t uses = 0;
  for (std::size_t at = svg.find("<use "); at != std::string::npos; at = svg.find("<use ", at + 1)) ++uses;
  EXPECT_EQ(uses, 2u + 4u + 2u + 1u);
  with_pieces_at({100, 50}, there, svg);
  cv::Mat tiles;
  cv::repeat(there, 2, 2, tiles);
  cv::absdiff(here, tiles(cv::Rect(200, 100, 400, 200)), difference);
  double most = 0;
  cv::minMaxLoc(difference.reshape(1), nullptr, &most);
  EXPECT_LE(most, 2);
  EXPECT_NE(at(here, 1, 100), kBackground) << "of the square at the right end";
}

TEST(Png, RotationTurnsFromXToY) {
  const OneSquare sample(std::numbers::pi_v<float> / 2);
  const cv::Mat picture = drawn_picture(sample.report);
  EXPECT_EQ(at(picture, 200, 65), kRed);  // the left side is now above
  EXPECT_EQ(at(picture, 200, 135), kBlue);
}

TEST(Png, EdgesAreSmoothAndNoWiderThanAPixelOrTwo) {
  const OneSquare sample(0.3f);
  const cv::Mat picture = drawn_picture(sample.report);
  int mixed = 0;
  for (int x = 0; x < picture.cols; ++x) {
    const cv::Vec3b c = at(picture, x, 100);
    mixed += c != kRed && c != kBlue && c != kBackground;
  }
  EXPECT_GE(mixed, 2);
  EXPECT_LE(mixed, 8);  // two outer edges and the one between the halves
}

TEST(Png, SmallPiecesAreAveragedNotSampled) {
  // Stripes of a hundredth of the page, drawn at 20 px, give an even grey without a pattern.
  std::string stripes = kSvgHead;
  for (int x = 0; x < 100; x += 2) {
    stripes += "<rect x=\"" + std::to_string(x) + "\" width=\"1\" height=\"100\" fill=\"black\"/>";
    stripes += "<rect x=\"" + std::to_string(x + 1) + "\" width=\"1\" height=\"100\" fill=\"white\"/>";
  }
  SampleCollage sample;
  test::embed_artwork(sample.report.shapes[0], stripes + "</svg>", 100, 100, 100);
  sample.report.placements.clear();
  sample.place(ShapeId{7}, 80, {60, 50}, 0.7f);  // makes the program draw the artwork large
  sample.place(ShapeId{7}, 10, {160, 50}, 0.4f);
  const cv::Mat picture = drawn_picture(sample.report);
  cv::Scalar mean, deviation;
  cv::meanStdDev(picture(cv::Rect(315, 95, 10, 10)), mean, deviation);
  EXPECT_NEAR(mean[0], 128, 6);
  EXPECT_LT(deviation[0], 20);  // a box filter leaves a few percent of the stripes, sampling leaves 80 and more
}

TEST(Png, OutsideOfTheRegionIsWhiteWithASmoothEdge) {
  SampleCollage sample;
  sample.report.canvas_edge.curves = {{{50.125f, 0}, {150, 0}, {150, 100}, {50.125f, 100}}};
  sample.report.placements.clear();
  const cv::Mat picture = drawn_picture(sample.report);
  EXPECT_EQ(at(picture, 50, 100), cv::Vec3b(255, 255, 255));
  EXPECT_EQ(at(picture, 200, 100), kBackground);
  EXPECT_EQ(at(picture, 99, 100), cv::Vec3b(255, 255, 255));
  EXPECT_NEAR(at(picture, 100, 100)[0], 255 - 0.75 * (255 - kBackground[0]), 2);
  EXPECT_EQ(at(picture, 101, 100), kBackground);
  EXPECT_EQ(at(picture, 299, 100), kBackground);
  EXPECT_EQ(at(picture, 300, 100), cv::Vec3b(255, 255, 255));
}

TEST(Png, WithoutABackgroundAllButThePiecesIsTransparent) {
  OneSquare sample(0.3f);
  const cv::Mat opaque = drawn_picture(sample.report);
  sample.report.canvas_edge.curves = {{{50, 0}, {150, 0}, {150, 100}, {50, 100}}};
  sample.report.output.background = kNoColour;
  const cv::Mat picture = drawn_picture(sample.report);
  ASSERT_EQ(picture.type(), CV_8UC4);
  EXPECT_EQ(picture.at<cv::Vec4b>(10, 10), cv::Vec4b());   // outside of the canvas
  EXPECT_EQ(picture.at<cv::Vec4b>(10, 200), cv::Vec4b());  // and inside
  EXPECT_EQ(picture.at<cv::Vec4b>(100, 170), cv::Vec4b(0, 0, 255, 255));
  int mixed = 0;
  for (int x = 0; x < picture.cols; ++x) {
    const cv::Vec4b c = picture.at<cv::Vec4b>(100, x);
    mixed += c[3] > 0 && c[3] < 255;
    for (int i = 0; i < 3; ++i) {  // straight alpha: laid over the background, it gives the earlier picture
      EXPECT_NEAR((c[i] * c[3] + kBackground[i] * (255 - c[3])) / 255., opaque.at<cv::Vec3b>(100, x)[i], 2) << x;
    }
  }
  EXPECT_GE(mixed, 2);
}

TEST(Png, ALineMayRunAlongTheOutlines) {
  OneSquare sample(0);  // from 80 to 120 px of the canvas, 160 to 240 of the picture
  sample.report.output.outline_px = 5;
  sample.report.output.outline_colour = "#00ff00";
  const cv::Mat picture = drawn_picture(sample.report);
  const cv::Vec3b line(0, 255, 0);
  EXPECT_EQ(at(picture, 153, 100), kBackground);
  EXPECT_EQ(at(picture, 156, 100), line);  // half of its 10 px lie beyond the outline
  EXPECT_EQ(at(picture, 163, 100), line);
  EXPECT_EQ(at(picture, 166, 100), kRed);
  EXPECT_EQ(at(picture, 200, 64), line);
  EXPECT_NE(at(picture, 155, 55), line) << "corners are round";
}

TEST(Png, PiecesMayCastAShadowOnWhatLiesBelowThem) {
  OneSquare sample(0);
  sample.place(ShapeId{7}, 40, {141, 50}, 0);  // this one lies beside the first, which is below it
  sample.report.output.shadow_strength = 0.5;
  sample.report.output.shadow_offset_px[0] = 4;
  sample.report.output.shadow_offset_px[1] = 8;
  sample.report.output.shadow_blur_px = 0.5;
  const cv::Mat picture = drawn_picture(sample.report);
  EXPECT_EQ(at(picture, 157, 100), kBackground);  // to the left of the first
  EXPECT_EQ(at(picture, 200, 163), kBackground);  // 23 px below it
  const cv::Vec3b shaded = at(picture, 200, 149);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(shaded[c], kBackground[c] * 0.5, 2);
  EXPECT_EQ(at(picture, 235, 100), kBlue) << "no piece is darkened, however near to another";
  EXPECT_EQ(at(picture, 246, 100), kRed);
  sample.report.output.background = kNoColour;
  const cv::Mat transparent = drawn_picture(sample.report);
  EXPECT_EQ(transparent.at<cv::Vec4b>(149, 200), cv::Vec4b(0, 0, 0, 128));
  EXPECT_EQ(transparent.at<cv::Vec4b>(100, 157), cv::Vec4b());
}

TEST(Png, ASoftShadowFadesAsAGaussianHoweverCoarselyItIsMade) {
  OneSquare sample(0);
  sample.report.output.width_px = 1600;  // the square's right side is at 960, and the blur has 32 px
  sample.report.output.shadow_strength = 1;
  sample.report.output.shadow_offset_px[0] = sample.report.output.shadow_offset_px[1] = 0;
  sample.report.output.shadow_blur_px = 4;
  sample.report.output.background = kNoColour;
  const cv::Mat picture = drawn_picture(sample.report);
  for (const int beyond : {8, 20, 40, 70, 90}) {
    const double expected = 255 * 0.5 * std::erfc((beyond + 0.5) / 32 / std::numbers::sqrt2);
    EXPECT_NEAR(picture.at<cv::Vec4b>(400, 960 + beyond)[3], expected, 4) << beyond;
  }
}

TEST(Png, WithoutAnyArtworkTheOutlineIsFilled) {
  const SampleCollage sample;
  const cv::Mat picture = drawn_picture(sample.report);
  const cv::Vec3b disc = at(picture, 100, 100);
  EXPECT_NEAR(disc[0], 145, 3);  // L* = 60 without colour
  EXPECT_EQ(disc[0], disc[2]);
  EXPECT_EQ(at(picture, 280, 100), kBackground);  // the hole of the ring
  EXPECT_NE(at(picture, 280, 45), kBackground);
}

TEST(Png, LostOriginalsGiveWayToTheThumbnail) {
  OneSquare sample(0);
  Artwork& artwork = sample.report.shapes[0].artwork;
  artwork.original.clear();
  artwork.path = "/nowhere/lost.svg";
  artwork.sha256 = Sha256{};
  artwork.thumbnail_png = test::encoded(cv::Mat(192, 192, CV_8UC4, cv::Scalar(0, 255, 0, 255)), ".png");
  test::DrawnCollage drawn(sample.report);
  EXPECT_EQ(at(drawn.picture(), 200, 100), cv::Vec3b(0, 255, 0));
  const DrawingNotes notes = drawn.artworks.notes();
  ASSERT_EQ(notes.notes.size(), 1u);
  EXPECT_EQ(notes.notes[0].from, DrawnFrom::thumbnail);
  EXPECT_EQ(drawing_warning(notes), std::string("1 piece drawn from thumbnails: ") + kOriginalMissing);
}

TEST(Png, ABadOriginalCostsItsDrawingAndIsNamed) {
  std::string matrix;
  for (int i = 0; i < 100 * 100; ++i) matrix += "1 ";
  const std::string filter =
      "<filter id=\"f\"><feConvolveMatrix order=\"100\" kernelMatrix=\"" + matrix + "\"/></filter>";
  const std::string aborts_librsvg =
      kSvgHead + filter + "<circle cx=\"30\" cy=\"25\" r=\"20\" filter=\"url(#f)\"/></svg>";
  std::string takes_minutes = kSvgHead;
  for (int i = 0; i < 40; ++i) takes_minutes += "<g filter=\"url(#f)\">";
  takes_minutes += "<rect width=\"100\" height=\"100\"/>";
  for (int i = 0; i < 40; ++i) takes_minutes += "</g>";
  takes_minutes += "<filter id=\"f\"><feTurbulence numOctaves=\"900\" baseFrequency=\"0.1\"/></filter></svg>";
  for (const std::string& original : {std::string("<svg nonsense"), aborts_librsvg, takes_minutes}) {
    SampleCollage sample;
    test::embed_artwork(sample.report.shapes[0], original, 100, 100, 80);
    test::embed_artwork(sample.report.shapes[1], kTwoHalves, 100, 100, 80);
    test::DrawnCollage drawn(sample.report, {.processes = 2, .seconds_per_drawing = 1});
    const cv::Mat picture = drawn.picture();
    EXPECT_NEAR(at(picture, 100, 100)[0], 145, 3) << "the disc in its mean colour";
    EXPECT_EQ(at(picture, 225, 100), kRed) << "the other shape is drawn";
    const DrawingNotes notes = drawn.artworks.notes();
    ASSERT_EQ(notes.notes.size(), 1u);
    EXPECT_EQ(notes.notes[0].shape, "disc");
    EXPECT_EQ(notes.notes[0].from, DrawnFrom::silhouette);
    EXPECT_NE(drawing_text(notes).find("drawn as silhouette     1 piece of disc: "), std::string::npos)
        << drawing_text(notes);
    EXPECT_NE(drawing_json(notes).find("\"pieces_from_originals\":1"), std::string::npos) << drawing_json(notes);
  }
}

TEST(Png, LaterPiecesLieOnEarlierOnesAndPiecesMayCrossTheEdge) {
  OneSquare sample(0);
  sample.place(ShapeId{7}, 40, {110, 50}, std::numbers::pi_v<float>);
  sample.place(ShapeId{7}, 40, {0, 0}, 0);
  sample.place(ShapeId{7}, 40, {900, 900}, 0);
  const cv::Mat picture = drawn_picture(sample.report);
  EXPECT_EQ(at(picture, 210, 100), kBlue);  // turned by half
  EXPECT_EQ(at(picture, 230, 100), kRed);
  EXPECT_EQ(at(picture, 20, 20), kBlue);
}

TEST(Png, TheFileDecodesToThePicture) {
  const test::ScratchFolder folder;
  const OneSquare sample(0.2f);
  test::DrawnCollage drawn(sample.report);
  std::size_t rows = 0;
  PngStream png(folder.path("collage.png"), picture_format(sample.report));
  write_picture(sample.report, drawn.artworks, {&png}, drawn.stop, [&](std::size_t done) { rows = done; });
  EXPECT_EQ(rows, 200u);
  EXPECT_EQ(cv::norm(test::read_image(folder.path("collage.png")), drawn.picture(), cv::NORM_INF), 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path("collage.png.tmp")));
}

/// Reads one of the four-byte numbers after the chunk's name.
std::uint32_t number_in_chunk(const std::string& png, const std::string& chunk, std::size_t index) {
  const auto at = png.find(chunk);
  if (at == std::string::npos) return 0;
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint8_t(png.at(at + 4 + 4 * index + i));
  return value;
}

TEST(Png, TheFileSaysHowLargeItIsOnPaperAndKeepsItsTransparency) {
  const test::ScratchFolder folder;
  OneSquare sample(0.2f);
  const auto written = [&] {
    test::DrawnCollage drawn(sample.report);
    PngStream png(folder.path("collage.png"), picture_format(sample.report));
    write_picture(sample.report, drawn.artworks, {&png}, drawn.stop, [](std::size_t) {});
    std::ifstream file(folder.path("collage.png"), std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  };
  EXPECT_EQ(written().find("pHYs"), std::string::npos);
  sample.report.output.width_mm = 50.8;
  sample.report.output.dpi = 300;
  sample.report.output.background = kNoColour;
  const std::string png = written();
  EXPECT_EQ(number_in_chunk(png, "IHDR", 0), 600u);
  EXPECT_EQ(number_in_chunk(png, "IHDR", 1), 300u);
  EXPECT_EQ(number_in_chunk(png, "pHYs", 0), 11811u);  // px per metre
  EXPECT_EQ(number_in_chunk(png, "pHYs", 1), 11811u);
  const cv::Mat read = test::read_image(folder.path("collage.png"));
  EXPECT_EQ(cv::norm(read, drawn_picture(sample.report), cv::NORM_INF), 0);
  // 600 px on 50.8 mm and 300 px on 25.5 mm, as near as whole numbers can be.
  sample.report.box.width_px = 200;
  sample.report.box.height_px = 100;
  sample.report.box.width_mm = 50.8;
  sample.report.box.height_mm = 25.5;
  const std::string of_canvas = written();
  EXPECT_EQ(number_in_chunk(of_canvas, "pHYs", 0), 11811u);
  EXPECT_EQ(number_in_chunk(of_canvas, "pHYs", 1), 11765u);
}

TEST(Png, TheBytesDependNeitherOnBandsNorOnMemoryNorOnThreads) {
  OneSquare sample(0.2f);
  sample.report.output.width_px = 1500;
  sample.report.canvas_edge.curves = {{{3.3f, 7.1f}, {190.7f, 2.2f}, {120.4f, 98.6f}}};
  sample.report.output.outline_px = 0.7;
  sample.report.output.shadow_strength = 0.6;
  for (int i = 0; i < 12; ++i)
    sample.place(ShapeId{7}, 9.f + 11.f * float(i % 7), {15.f * float(i), 8.f * float(i)}, 0.5f * float(i));
  test::DrawnCollage drawn(sample.report);
  const cv::Mat expected = drawn.picture();
  ASSERT_EQ(expected.size(), cv::Size(1500, 750));
  for (const PictureLimits& limits :
       {PictureLimits{64, 1, 0}, PictureLimits{64, 1 << 20, 300'000},
        PictureLimits{192, std::size_t(1) << 30, std::size_t(1) << 30}, PictureLimits{.band_bytes = 1'000'000}}) {
    EXPECT_EQ(cv::norm(drawn.picture(limits), expected, cv::NORM_INF), 0) << limits.band_rows;
  }
  for (const int cores : {1, 5}) {
    const test::RankBreadth rank(cores);
    EXPECT_EQ(cv::norm(drawn.picture({128, 1, 100'000}), expected, cv::NORM_INF), 0) << cores;
  }
}

/// A drawing that wants to stop at its first progress message.
class ImpatientDrawing : public test::SilentDrawing {
 public:
  std::optional<StopReason> stop_requested() override {
    return stop ? std::optional(StopReason::signal) : std::nullopt;
  }
  std::atomic<bool> stop = false;
};

TEST(Png, FollowsNothingThatOthersPutThere) {
  for (const test::Plant plant : test::kPlants) {
    const test::ScratchFolder folder;
    const test::PlantedFiles planted;
    planted.put(plant, folder.path("collage.png"));
    planted.put(plant, folder.path("collage.png.tmp"));
    const cv::Mat picture(30, 40, CV_8UC3, cv::Scalar(1, 2, 3));
    PngStream png(folder.path("collage.png"), {.size = picture.size()});
    png.write(picture);
    png.finish();
    EXPECT_EQ(cv::norm(test::read_image(folder.path("collage.png")), picture, cv::NORM_INF), 0);
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(folder.path("collage.png.tmp"))));
    planted.expect_untouched();
  }
}

TEST(Png, AStopLeavesNoFile) {
  const test::ScratchFolder folder;
  const OneSquare sample(0);
  ImpatientDrawing observer;
  Drawers drawers({.processes = 1});
  const StopWatcher stop(observer, drawers);
  ShapeArtworks artworks(sample.report, drawers, stop);
  observer.stop = true;
  {
    PngStream png(folder.path("collage.png"), picture_format(sample.report));
    TiffPyramid tiff(folder.path("collage.tiff"), picture_format(sample.report));
    EXPECT_THROW(write_picture(sample.report, artworks, {&png, &tiff}, stop, [](std::size_t) {}), DrawingStopped);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path("")));
}

}  // namespace test_png_output
}  // namespace tessera
