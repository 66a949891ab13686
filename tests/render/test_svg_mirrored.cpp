// Mirrored pieces in collage.svg and collage.png.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/geometry/rasterise.h"
#include "core/shape/mirrored_shape.h"
#include "support/svg_samples.h"

namespace tessera {
namespace test_svg_mirrored {

using namespace test;

/// A flag, which no turn brings onto its mirror image. Its artwork is its outline in red.
Shape flag_shape() {
  Outline flag{{{{0, 0}, {10, 0}, {10, 3}, {2, 3}, {2, 12}, {0, 12}}}};
  Shape shape = test::make_test_shape("flag", flag);
  shape.mean_lab = {20, 0, 0};
  std::string points;
  for (const Vec2 p : shape.outline.curves[0])
    points += std::to_string(40 + 20 * p.x) + "," + std::to_string(50 + 20 * p.y) + " ";
  const std::string head = std::string(kXmlns) + R"~(width="80" height="100"><polygon fill="red" points=")~";
  test::embed_artwork(shape, head + points + R"~("/></svg>)~", 80, 100, 20);
  return shape;
}

Shape mirrored_flag() { return mirror_image(flag_shape(), PadParameters{}.levels); }

/// The flag as library shape 7, its mirror image as shape 3, on a white background.
struct Flags : SampleCollage {
  Flags() {
    report.output.background = "#ffffff";
    report.shapes = {};
    report.shapes.add(ShapeId{7}, flag_shape());
    report.shapes.add(ShapeId{3}, mirrored_flag());
    report.placements.clear();
    place(ShapeId{3}, 50, {60, 50}, 0.6f);
    place(ShapeId{7}, 50, {140, 50}, -2.f);
  }
};

/// Compares the drawn piece with a fill of `outline` in its pose: the share of pixels in only one of them, among those in either.
double disagreement(const cv::Mat& picture, const Outline& outline, const Similarity& canvas_from_shape,
                    cv::Rect part) {
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
    if (!original_there) {  // only the mirror image is there, as for a shape that stands only mirrored
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
  sample.report.output.outline_px = 2;
  sample.report.output.shadow_strength = 0.5;
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

}  // namespace test_svg_mirrored
}  // namespace tessera
