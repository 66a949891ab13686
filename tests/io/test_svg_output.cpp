// collage.svg: drawn by another renderer it is the picture that collage.png is.
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "artwork_samples.h"
#include "core/geometry/rasterise.h"
#include "core/shape/mirrored_shape.h"
#include "drawn_collage.h"
#include "io/artwork/sha256.h"
#include "io/artwork/artwork_render.h"
#include "io/job/canvas_file.h"
#include "sample_collage.h"
#include "scratch_folder.h"

namespace tessera::io {
namespace {

using test::drawn_picture;
using test::drawn_svg;
using test::SampleCollage;

/// What librsvg makes of it; it has no transparent parts.
cv::Mat drawn(const std::string& svg, int width_px) {
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size());
  cv::Mat bgr;
  cv::cvtColor(render_artwork(bytes, "collage.svg", width_px), bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

double mean_difference(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference;
  cv::absdiff(a, b, difference);
  const cv::Scalar mean = cv::mean(difference);
  return (mean[0] + mean[1] + mean[2]) / 3;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::string face(const std::string& colour, const std::string& head) {
  return head + R"~(<style>.a{fill:)~" + colour + R"~(}</style><defs><linearGradient id="g"><stop stop-color=")~" + colour +
         R"~("/><stop offset="1" stop-color="white"/></linearGradient></defs>)~" +
         R"~(<circle class="a" cx="40" cy="30" r="28"/><rect x="30" y="20" width="20" height="10" fill="url(#g)"/></svg>)~";
}

constexpr char kXmlns[] = R"~(<svg xmlns="http://www.w3.org/2000/svg" )~";

struct TwoFaces : SampleCollage {
  TwoFaces() {
    // The same ids and classes in both, one page in mm with a view box, one in px without.
    test::embed_artwork(report.shapes[0], face("red", std::string(kXmlns) + R"~(width="160mm" height="120mm" viewBox="0 0 80 60">)~"), 80, 60, 50);
    test::embed_artwork(report.shapes[1], face("blue", std::string(kXmlns) + R"~(width="80" height="60">)~"), 80, 60, 50);
    place(ShapeId{7}, 30, {100, 20}, 1.2f);
    place(ShapeId{7}, 25, {100, 80}, -2.f);
  }
};

TEST(SvgOutput, AgreesWithThePng) {
  const TwoFaces sample;
  const cv::Mat svg = drawn(drawn_svg(sample.report), 400);
  const cv::Mat png = drawn_picture(sample.report);
  ASSERT_EQ(svg.size(), png.size());
  EXPECT_LT(mean_difference(svg, png), 1.2);
  EXPECT_GT(svg.at<cv::Vec3b>(60, 100)[2], 200);   // the red one kept its colours
  EXPECT_LT(svg.at<cv::Vec3b>(60, 100)[0], 50);
  EXPECT_GT(svg.at<cv::Vec3b>(60, 280)[0], 200);   // and the blue one
}

TEST(SvgOutput, EachArtworkIsDefinedOnceAndPlacedOften) {
  const TwoFaces sample;
  const std::string svg = drawn_svg(sample.report);
  EXPECT_EQ(count(svg, "<circle"), 2u);
  EXPECT_EQ(count(svg, "<use "), 4u);
  EXPECT_EQ(count(svg, "xlink:href=\"#a0\""), 3u);
  EXPECT_EQ(count(svg, "viewBox=\"0 0 200 100\""), 1u);
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
  EXPECT_EQ(ids.size(), 12u);  // two artworks, an id of each, two clips, two layers, four pieces
}

TEST(SvgOutput, InkscapeShowsLayersAndWhatThePiecesAre) {
  TwoFaces sample;
  sample.report.shapes[0].name = "bear & \"cub\" No. 3/\xc3\xa4\x01";
  const std::string svg = drawn_svg(sample.report);
  EXPECT_EQ(count(svg, "inkscape:groupmode=\"layer\""), 2u);
  const auto canvas = svg.find("<g id=\"layer-canvas\" inkscape:groupmode=\"layer\" inkscape:label=\"Canvas\">");
  const auto pieces = svg.find("<g id=\"layer-pieces\" inkscape:groupmode=\"layer\" inkscape:label=\"Pieces\">");
  const auto background = svg.find(sample.job.output.background);
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
  sample.job.tables["shapes"] = {{{"names", {{}, {}, {"disc"}}}, {"group", {{}, "round <ones>"}}}};
  const std::string svg = drawn_svg(sample.report);
  const auto group = svg.find("<g id=\"layer-group-0\" inkscape:groupmode=\"layer\" inkscape:label=\"round &lt;ones&gt;\">");
  const auto others = svg.find("<g id=\"layer-pieces\"");
  ASSERT_NE(group, std::string::npos) << svg;
  ASSERT_NE(others, std::string::npos);
  EXPECT_LT(group, svg.find("id=\"piece-0-disc\"")) << "in the order of their first pieces";
  EXPECT_LT(svg.find("id=\"piece-3-disc\""), others);
  EXPECT_LT(others, svg.find("id=\"piece-1-ring\""));
  EXPECT_LT(mean_difference(drawn(svg, 400), drawn_picture(sample.report)), 1.2);
}

/// A flag: no turn brings it onto its mirror image. Its artwork is just its outline, in red.
Shape flag_shape() {
  Outline flag{{{{0, 0}, {10, 0}, {10, 3}, {2, 3}, {2, 12}, {0, 12}}}};
  Shape shape = test::make_test_shape("flag", flag);
  shape.mean_lab = {20, 0, 0};
  std::string points;
  for (const Vec2 p : shape.outline.curves[0])
    points += std::to_string(40 + 20 * p.x) + "," + std::to_string(50 + 20 * p.y) + " ";
  test::embed_artwork(shape, std::string(kXmlns) + R"~(width="80" height="100"><polygon fill="red" points=")~" + points +
                                 R"~("/></svg>)~", 80, 100, 20);
  return shape;
}

Shape mirrored_flag() { return mirror_image(flag_shape(), PadParameters{}.levels); }

/// The flag as library shape 7, its mirror image as 3; the background is white.
struct Flags : SampleCollage {
  Flags() {
    job.output.background = "#ffffff";
    report.shapes = {};
    report.shapes.add(ShapeId{7}, flag_shape());
    report.shapes.add(ShapeId{3}, mirrored_flag());
    report.placements.clear();
    place(ShapeId{3}, 50, {60, 50}, 0.6f);
    place(ShapeId{7}, 50, {140, 50}, -2.f);
  }
};

/// The share of the pixels in which the two differ, of those that are in either: what is drawn of a piece, and a fill of
/// `outline` at its place.
double disagreement(const cv::Mat& picture, const Outline& outline, const Similarity& canvas_from_shape, cv::Rect part) {
  cv::Mat filled(picture.size(), CV_8UC1, cv::Scalar(0));
  for (const Span& span : fill_spans(outline, scaled(canvas_from_shape, 2), {0, 0, picture.cols, picture.rows})) {
    filled(cv::Rect(span.x0, span.y, span.x1 - span.x0, 1)) = 255;
  }
  cv::Mat blue;
  cv::extractChannel(picture, blue, 0);
  const cv::Mat drawn_part = blue(part) < 128;
  const cv::Mat filled_part = filled(part) > 0;
  return double(cv::countNonZero(drawn_part != filled_part)) / cv::countNonZero(drawn_part | filled_part);
}

TEST(SvgOutput, MirroredArtworkLiesInItsOutline) {
  Flags sample;
  const Outline as_drawn = sample.report.shapes[0].outline;
  const Similarity left = sample.report.placements[0].canvas_from_shape;
  const Similarity right = sample.report.placements[1].canvas_from_shape;
  const cv::Rect left_half(0, 0, 200, 200), right_half(200, 0, 200, 200);
  for (const bool original_there : {true, false}) {
    if (!original_there) {  // a mirror image alone, as of a shape that stands mirrored only
      sample.report.shapes = {};
      sample.report.shapes.add(ShapeId{3}, mirrored_flag());
      sample.report.placements.pop_back();
    }
    for (const cv::Mat& picture : {drawn_picture(sample.report), drawn(drawn_svg(sample.report), 400)}) {
      const Outline& own = sample.report.shapes[sample.report.shapes.size() - 1].outline;
      EXPECT_LT(disagreement(picture, own, left, left_half), 0.04);
      EXPECT_GT(disagreement(picture, flag_shape().outline, left, left_half), 0.3) << "as drawn it lies elsewhere";
      if (!original_there) continue;
      EXPECT_LT(disagreement(picture, as_drawn, right, right_half), 0.04);
    }
  }
}

TEST(SvgOutput, MirroredArtworkIsDefinedOnceWithItsOriginal) {
  Flags sample;
  sample.job.output.outline_px = 2;
  sample.job.output.shadow_strength = 0.5;
  const std::string svg = drawn_svg(sample.report);
  EXPECT_EQ(count(svg, "<polygon"), 1u);
  EXPECT_EQ(count(svg, "<clipPath"), 1u);
  EXPECT_EQ(count(svg, "id=\"o"), 1u);
  EXPECT_EQ(count(svg, "xlink:href=\"#a0\""), 2u);
  EXPECT_LT(mean_difference(drawn(svg, 400), drawn_picture(sample.report)), 1.6) << "lines and shadows too";
}

TEST(SvgOutput, MirroredSilhouettesLieInTheirOutline) {
  Flags sample;
  for (const std::size_t slot : {0, 1}) sample.report.shapes[slot].artwork.original.clear();
  const Similarity left = sample.report.placements[0].canvas_from_shape;
  const auto expect_in_outline = [&] {
    for (const cv::Mat& picture : {drawn_picture(sample.report), drawn(drawn_svg(sample.report), 400)}) {
      EXPECT_LT(disagreement(picture, sample.report.shapes[1].outline, left, {0, 0, 200, 200}), 0.04);
    }
  };
  expect_in_outline();
  sample.report.colours = {"#200000", "#002000"};
  expect_in_outline();
}

TEST(SvgOutput, NotesCountMirroredPiecesWithTheirDrawing) {
  Flags sample;
  for (const std::size_t slot : {0, 1}) sample.report.shapes[slot].artwork.original.clear();
  test::DrawnCollage drawn(sample.report);
  drawn.picture();
  const DrawingNotes notes = drawn.artworks.notes();
  ASSERT_EQ(notes.notes.size(), 1u);
  EXPECT_EQ(notes.notes[0].pieces, 2u);
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
  page(cv::Rect(2, 2, 296, 196)) = cv::Scalar(0, 0, 255, 255);  // the disc with all that is around it
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
  sample.job.output.clip = kNoClip;
  for (const cv::Mat& picture : {drawn_picture(sample.report), drawn(drawn_svg(sample.report), 400)}) {
    EXPECT_LT(picture.at<cv::Vec3b>(100, outside)[0], 50) << "outside: what the artwork has there";
  }
}

TEST(SvgOutput, BitmapsAndLostOriginalsAreEmbeddedAsPictures) {
  SampleCollage sample;
  const test::Bytes png = test::encoded(test::disc_with_alpha(), ".png");
  for (const std::size_t slot : {0, 1}) test::embed_artwork(sample.report.shapes[slot], std::string(png.begin(), png.end()), 300, 200, 106);
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
  sample.job.output.background = kNoColour;
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
  sample.job.output.width_mm = 210;
  EXPECT_EQ(count(drawn_svg(sample.report), " width=\"210.000mm\" height=\"105.000mm\" viewBox=\"0 0 200 100\""), 1u);
}

TEST(SvgOutput, OutlinesAndShadowsAreThoseOfThePng) {
  TwoFaces sample;
  EXPECT_EQ(count(drawn_svg(sample.report), "filter"), 0u);
  EXPECT_EQ(count(drawn_svg(sample.report), "id=\"o"), 0u);
  const cv::Mat plain = drawn_picture(sample.report);
  OutputSpec& output = sample.job.output;
  output.outline_px = 3;
  output.outline_colour = "#108040";
  EXPECT_LT(mean_difference(drawn(drawn_svg(sample.report), 400), drawn_picture(sample.report)), 1.2);
  EXPECT_EQ(count(drawn_svg(sample.report), "filter"), 0u);
  output.outline_px = 0;
  output.shadow_strength = 0.7;
  output.shadow_offset_px[0] = -3;
  output.shadow_offset_px[1] = 6;
  output.shadow_blur_px = 3;
  EXPECT_GT(mean_difference(plain, drawn_picture(sample.report)), 10);  // there is much to be the same
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

/// A page of 100 x 50 on the canvas of 200 x 100: a bar of letters below both pieces.
struct WithKeepOut : SampleCollage {
  explicit WithKeepOut(const std::string& body) {
    job.canvas.keep_out = folder.write("letters.svg", std::string(kXmlns) + "width=\"100\" height=\"50\">" + body + "</svg>");
    Drawers drawers(canvas_drawer_settings(job.canvas));
    report.keep_out = draw_keep_out(job, canvas, drawers);
  }
  test::ScratchFolder folder;
};

constexpr char kBar[] = R"~(<g id="clip"><rect x="20" y="42" width="60" height="6" fill="#2040c0"/></g>)~";

TEST(SvgOutput, LettersAreALayerBelowThePieces) {
  const WithKeepOut collage(kBar);
  const std::string svg = drawn_svg(collage.report);
  const std::size_t letters = svg.find("<g id=\"layer-keep-out\"");
  ASSERT_NE(letters, std::string::npos);
  EXPECT_LT(svg.find("layer-canvas"), letters);
  EXPECT_LT(letters, svg.find("layer-pieces"));
  EXPECT_EQ(svg.find("clip-keep-out"), std::string::npos) << "a page that is clear elsewhere is not clipped";
  const cv::Mat picture = drawn_picture(collage.report);
  EXPECT_EQ(picture.at<cv::Vec3b>(180, 200), cv::Vec3b(0xc0, 0x40, 0x20));
  EXPECT_EQ(picture.at<cv::Vec3b>(180, 60), cv::Vec3b(0xc0, 0xe0, 0xff)) << "the canvas beside it";
  EXPECT_LT(mean_difference(picture, drawn(svg, 400)), 0.3);
}

TEST(SvgOutput, ThePageBehindLettersIsNotDrawn) {
  const WithKeepOut collage(std::string("<rect width=\"100\" height=\"50\" fill=\"white\"/>") + kBar);
  const std::string svg = drawn_svg(collage.report);
  EXPECT_NE(svg.find("clip-path=\"url(#clip-keep-out)\""), std::string::npos);
  EXPECT_EQ(count(svg, "id=\"clip-keep-out\""), 1u);
  const cv::Mat picture = drawn_picture(collage.report);
  EXPECT_EQ(picture.at<cv::Vec3b>(180, 200), cv::Vec3b(0xc0, 0x40, 0x20));
  EXPECT_EQ(picture.at<cv::Vec3b>(180, 60), cv::Vec3b(0xc0, 0xe0, 0xff));
  EXPECT_LT(mean_difference(picture, drawn(svg, 400)), 0.3);
}

TEST(SvgOutput, LettersDoNotDependOnTheBands) {
  const WithKeepOut collage(kBar);
  test::DrawnCollage drawn_collage(collage.report);
  const cv::Mat bands = drawn_collage.picture({.band_rows = 64});
  cv::Mat difference;
  cv::absdiff(bands, drawn_picture(collage.report), difference);
  EXPECT_EQ(cv::countNonZero(difference.reshape(1)), 0);
}

TEST(SvgOutput, LettersMayBeAnImage) {
  SampleCollage collage;
  test::ScratchFolder folder;
  cv::Mat image(50, 100, CV_8UC4, cv::Scalar::all(0));
  cv::rectangle(image, {20, 42, 60, 6}, cv::Scalar(0xc0, 0x40, 0x20, 255), cv::FILLED);
  collage.job.canvas.keep_out = folder.path("letters.png");
  ASSERT_TRUE(cv::imwrite(collage.job.canvas.keep_out, image));
  Drawers drawers(canvas_drawer_settings(collage.job.canvas));
  collage.report.keep_out = draw_keep_out(collage.job, collage.canvas, drawers);
  const cv::Mat picture = drawn_picture(collage.report);
  EXPECT_EQ(picture.at<cv::Vec3b>(180, 200), cv::Vec3b(0xc0, 0x40, 0x20));
  EXPECT_LT(mean_difference(picture, drawn(drawn_svg(collage.report), 400)), 0.5);
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
  sample.job.output.background = kNoColour;
  EXPECT_EQ(drawn_svg(sample.report).find("#205080"), std::string::npos);
}

}  // namespace
}  // namespace tessera::io
