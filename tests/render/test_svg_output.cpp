// collage.svg, drawn by another renderer, gives the same picture as collage.png.
#include <gtest/gtest.h>

#include <set>

#include "artwork/images/sha256.h"
#include "support/artwork_samples.h"
#include "support/scratch_folder.h"
#include "support/svg_samples.h"

namespace tessera {
namespace test_svg_output {

using namespace test;

TEST(SvgOutput, AgreesWithThePng) {
  const TwoFaces sample;
  const cv::Mat svg = drawn(drawn_svg(sample.report), 400);
  const cv::Mat png = drawn_picture(sample.report);
  ASSERT_EQ(svg.size(), png.size());
  EXPECT_LT(mean_difference(svg, png), 1.2);
  EXPECT_GT(svg.at<cv::Vec3b>(60, 100)[2], 200);  // the red one kept its colours
  EXPECT_LT(svg.at<cv::Vec3b>(60, 100)[0], 50);
  EXPECT_GT(svg.at<cv::Vec3b>(60, 280)[0], 200);  // and the blue one
}

TEST(SvgOutput, EachArtworkIsDefinedOnceAndPlacedOften) {
  const TwoFaces sample;
  const std::string svg = drawn_svg(sample.report);
  EXPECT_EQ(count(svg, "<circle"), 2u);
  EXPECT_EQ(count(svg, "<use "), 4u);
  EXPECT_EQ(count(svg, "xlink:href=\"#a0\""), 3u);
  EXPECT_EQ(count(svg, "viewBox=\"0 0 200 100\""), 1u);
}

/// A copy would lose content that the drawing's sheet loads (svg_style.h).
TEST(SvgOutput, ADrawingThatCannotBeCopiedIsAPicture) {
  TwoFaces sample;
  const std::string head =
      std::string(kXmlns) + R"~(width="80" height="60"><style>@import "data:text/css,.a{fill:lime}";</style>)~";
  embed_artwork(sample.report.shapes[0], head + R"~(<circle class="a" cx="40" cy="30" r="28"/></svg>)~", 80, 60, 50);
  const std::string svg = drawn_svg(sample.report);
  EXPECT_EQ(count(svg, "<image id=\"a0\""), 1u);
  EXPECT_LT(mean_difference(drawn(svg, 400), drawn_picture(sample.report)), 1.2);
  EXPECT_EQ(drawn(svg, 400).at<cv::Vec3b>(60, 100), cv::Vec3b(0, 255, 0));
}

TEST(SvgOutput, IdsAreUnique) {
  const TwoFaces sample;
  const std::string svg = drawn_svg(sample.report);
  std::set<std::string> ids;
  const std::string mark = " id=\"";
  for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + 1)) {
    const std::size_t begin = at + mark.size();
    const std::string id = svg.substr(begin, svg.find('"', begin) - begin);
    EXPECT_TRUE(ids.insert(id).second) << id;
  }
  EXPECT_EQ(ids.size(), 12u);  // two artworks with an id inside each, two clips, two layers, four pieces
}

TEST(SvgOutput, InkscapeShowsLayersAndWhatThePiecesAre) {
  TwoFaces sample;
  sample.report.shapes[0].name = "bear & \"cub\" No. 3/\xc3\xa4\x01";
  const std::string svg = drawn_svg(sample.report);
  EXPECT_EQ(count(svg, "inkscape:groupmode=\"layer\""), 2u);
  const auto canvas = svg.find("<g id=\"layer-canvas\" inkscape:groupmode=\"layer\" inkscape:label=\"Canvas\">");
  const auto pieces = svg.find("<g id=\"layer-pieces\" inkscape:groupmode=\"layer\" inkscape:label=\"Pieces\">");
  const auto background = svg.find(sample.report.output.background);
  ASSERT_NE(canvas, std::string::npos);
  ASSERT_NE(pieces, std::string::npos);
  EXPECT_LT(canvas, background);
  EXPECT_LT(background, pieces);
  EXPECT_LT(pieces, svg.find("<use "));
  EXPECT_EQ(count(svg, "id=\"piece-1-ring\""), 1u);
  EXPECT_EQ(count(svg, "id=\"piece-0-bear____cub__No__3____\""), 1u);
  EXPECT_EQ(count(svg, "id=\"piece-3-bear____cub__No__3____\""), 1u);
  EXPECT_EQ(count(svg, "<title>bear &amp; &quot;cub&quot; No. 3/\xc3\xa4_</title>"), 3u);
  EXPECT_EQ(drawn(svg, 400).size(), cv::Size(400, 200));
}

TEST(SvgOutput, GroupsAreLayers) {
  TwoFaces sample;
  for (const Placement& placement : sample.report.placements)
    sample.report.groups.push_back(placement.shape == ShapeId{7} ? "round <ones>" : "");
  const std::string svg = drawn_svg(sample.report);
  const auto group =
      svg.find("<g id=\"layer-group-0\" inkscape:groupmode=\"layer\" inkscape:label=\"round &lt;ones&gt;\">");
  const auto others = svg.find("<g id=\"layer-pieces\"");
  ASSERT_NE(group, std::string::npos) << svg;
  ASSERT_NE(others, std::string::npos);
  EXPECT_LT(group, svg.find("id=\"piece-0-disc\"")) << "in the order of their first pieces";
  EXPECT_LT(svg.find("id=\"piece-3-disc\""), others);
  EXPECT_LT(others, svg.find("id=\"piece-1-ring\""));
  EXPECT_LT(mean_difference(drawn(svg, 400), drawn_picture(sample.report)), 1.2);
}

TEST(SvgOutput, ReadsTheOriginalFromItsPlace) {
  const test::ScratchFolder folder;
  TwoFaces sample;
  Artwork& artwork = sample.report.shapes[0].artwork;
  artwork.path = folder.write("face.svg", std::string(artwork.original.begin(), artwork.original.end()));
  artwork.sha256 = sha256_of(artwork.original);
  const std::string embedded = drawn_svg(sample.report);
  artwork.original.clear();
  EXPECT_EQ(drawn_svg(sample.report), embedded);
}

TEST(SvgOutput, ArtworkDoesNotStickOutOfItsOutline) {
  SampleCollage sample;
  cv::Mat page(200, 300, CV_8UC4, cv::Scalar::all(0));
  page(cv::Rect(2, 2, 296, 196)) = cv::Scalar(0, 0, 255, 255);  // the disc and everything around it
  const test::Bytes png = test::encoded(page, ".png");
  test::embed_artwork(sample.report.shapes[0], std::string(png.begin(), png.end()), 300, 200, 106);
  sample.report.placements = {sample.report.placements[1]};
  sample.report.placements[0].shape = ShapeId{7};
  const int outside = 280 + int(2 * 60 * (0.5642 + 0.06));  // a disc of area 1 has this radius
  for (const cv::Mat& picture : {drawn_picture(sample.report), drawn(drawn_svg(sample.report), 400)}) {
    EXPECT_GT(picture.at<cv::Vec3b>(100, 280)[2], 200) << "inside";
    EXPECT_LT(picture.at<cv::Vec3b>(100, 280)[0], 50) << "inside";
    EXPECT_GT(picture.at<cv::Vec3b>(100, outside)[0], 150) << "outside: the background";
  }
  sample.report.output.clip = kNoClip;
  for (const cv::Mat& picture : {drawn_picture(sample.report), drawn(drawn_svg(sample.report), 400)}) {
    EXPECT_LT(picture.at<cv::Vec3b>(100, outside)[0], 50) << "outside: what the artwork has there";
  }
}

TEST(SvgOutput, BitmapsAndLostOriginalsAreEmbeddedAsPictures) {
  SampleCollage sample;
  const test::Bytes png = test::encoded(test::disc_with_alpha(), ".png");
  for (const std::size_t slot : {0, 1}) {
    test::embed_artwork(sample.report.shapes[slot], std::string(png.begin(), png.end()), 300, 200, 106);
  }
  Artwork& lost = sample.report.shapes[1].artwork;
  lost.original.clear();
  lost.path = "/nowhere/lost.png";
  lost.thumbnail_png = png;
  const std::string svg = drawn_svg(sample.report);
  EXPECT_EQ(count(svg, "data:image/png;base64,"), 2u);
  EXPECT_LT(mean_difference(drawn(svg, 400), drawn_picture(sample.report)), 1.2);
}

TEST(SvgOutput, ShapesWithoutArtworkAreSilhouettes) {
  const SampleCollage sample;
  EXPECT_LT(mean_difference(drawn(drawn_svg(sample.report), 400), drawn_picture(sample.report)), 1.2);
}

TEST(SvgOutput, WithoutABackgroundNothingLiesUnderThePieces) {
  SampleCollage sample;
  sample.report.canvas_edge.curves = {{{50, 10}, {150, 10}, {150, 90}}};
  sample.report.output.background = kNoColour;
  const std::string svg = drawn_svg(sample.report);
  EXPECT_EQ(count(svg, "<rect"), 0u);
  EXPECT_EQ(count(svg, "layer-canvas"), 0u);
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size());
  const cv::Mat vectors = render_artwork(bytes, "collage.svg", 400);
  const cv::Mat pixels = drawn_picture(sample.report);
  EXPECT_EQ(vectors.at<cv::Vec4b>(100, 200)[3], 0);
  cv::Mat alpha[2];
  cv::extractChannel(vectors, alpha[0], 3);
  cv::extractChannel(pixels, alpha[1], 3);
  EXPECT_LT(mean_difference(alpha[0], alpha[1]) * 3, 1.2);
}

TEST(SvgOutput, IsAsLargeAsThePictureOrAsItIsOnPaper) {
  SampleCollage sample;
  EXPECT_EQ(count(drawn_svg(sample.report), " width=\"400\" height=\"200\" viewBox=\"0 0 200 100\""), 1u);
  sample.report.output.width_mm = 210;
  EXPECT_EQ(count(drawn_svg(sample.report), " width=\"210.000mm\" height=\"105.000mm\" viewBox=\"0 0 200 100\""), 1u);
}

TEST(SvgOutput, IsAsLargeOnPaperAsItsCanvasIsAskedFor) {
  SampleCollage sample;
  sample.report.output.width_mm = 210;
  sample.report.box.width_px = 200;
  sample.report.box.height_px = 100;
  sample.report.box.width_mm = 210;
  sample.report.box.height_mm = 105.4;  // gives 100.381 px: mm of a piece are mm of the page
  EXPECT_EQ(count(drawn_svg(sample.report), " width=\"210.000mm\" height=\"105.400mm\" viewBox=\"0 0 200 100.381\""),
            1u);
  EXPECT_EQ(count(drawn_svg(sample.report), "preserveAspectRatio=\"none\""), 0u);
  // Copies must meet, so the px of the canvas fill the page.
  sample.canvas = make_seamless_canvas(200, 100, true, false);
  EXPECT_EQ(
      count(drawn_svg(sample.report), " height=\"105.400mm\" viewBox=\"0 0 200 100\" preserveAspectRatio=\"none\""),
      1u);
}

TEST(SvgOutput, OutlinesAndShadowsAreThoseOfThePng) {
  TwoFaces sample;
  EXPECT_EQ(count(drawn_svg(sample.report), "filter"), 0u);
  EXPECT_EQ(count(drawn_svg(sample.report), "id=\"o"), 0u);
  const cv::Mat plain = drawn_picture(sample.report);
  OutputSpec& output = sample.report.output;
  output.outline_px = 3;
  output.outline_colour = "#108040";
  EXPECT_LT(mean_difference(drawn(drawn_svg(sample.report), 400), drawn_picture(sample.report)), 1.2);
  EXPECT_EQ(count(drawn_svg(sample.report), "filter"), 0u);
  output.outline_px = 0;
  output.shadow_strength = 0.7;
  output.shadow_offset_px[0] = -3;
  output.shadow_offset_px[1] = 6;
  output.shadow_blur_px = 3;
  EXPECT_GT(mean_difference(plain, drawn_picture(sample.report)), 10);  // there is much to compare
  EXPECT_LT(mean_difference(drawn(drawn_svg(sample.report), 400), drawn_picture(sample.report)), 1.6);
  const std::string svg = drawn_svg(sample.report);
  EXPECT_LT(svg.find("layer-canvas"), svg.find("layer-shadow"));
  EXPECT_LT(svg.find("layer-shadow"), svg.find("layer-pieces"));
}

TEST(SvgOutput, AMaskedCanvasIsAPath) {
  SampleCollage sample;
  Grid<float> mask(400, 200, 0.f);
  for (int y = 20; y < 180; ++y) std::fill(mask.row(y) + 100, mask.row(y) + 300, 1.f);
  sample.canvas = make_mask_canvas(mask);
  sample.report.canvas_edge.curves = {{{50, 10}, {150, 10}, {150, 90}, {50, 90}}, {{60, 20}, {90, 20}, {90.3f, 41}}};
  EXPECT_LT(mean_difference(drawn(drawn_svg(sample.report), 400), drawn_picture(sample.report)), 1.2);
}

TEST(SvgOutput, GroundsOfRegionsAreCutOffAtTheEdge) {
  SampleCollage sample;
  sample.report.canvas_edge.curves = {{{50, 10}, {150, 10}, {140, 90}, {50, 90}}};
  sample.report.canvas_edge.grounds = {{{{{-4, -4}, {204, -4}, {204, 45}, {-4, 42}}}, "#205080"},
                                       {{{{-4, 40}, {204, 43}, {204, 104}, {-4, 104}}}, ""}};
  const cv::Mat picture = drawn_picture(sample.report);
  EXPECT_LT(mean_difference(drawn(drawn_svg(sample.report), 400), picture), 1.2);
  EXPECT_EQ(picture.at<cv::Vec3b>(30, 120), cv::Vec3b(0x80, 0x50, 0x20));
  EXPECT_EQ(picture.at<cv::Vec3b>(170, 120), cv::Vec3b(0xc0, 0xe0, 0xff)) << "the background of the canvas";
  EXPECT_EQ(picture.at<cv::Vec3b>(30, 20), cv::Vec3b(255, 255, 255)) << "outside";
  sample.report.output.background = kNoColour;
  EXPECT_EQ(drawn_svg(sample.report).find("#205080"), std::string::npos);
}

}  // namespace test_svg_output
}  // namespace tessera
