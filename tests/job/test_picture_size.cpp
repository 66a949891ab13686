// The size of the pictures, in px and on paper.
#include "job/picture_size.h"

#include <gtest/gtest.h>

#include "support/input_error.h"

namespace tessera {
namespace test_picture_size {

const Canvas kCanvas = make_rectangle_canvas(300, 200);

std::string mistake(const OutputSpec& output, const Canvas& canvas) {
  return test::message_of([&] { check_picture_size(output, canvas); });
}

TEST(PictureSize, is_as_wide_as_the_job_says_with_the_canvas_aspect) {
  EXPECT_EQ(picture_size_px({.width_px = 601}, kCanvas), cv::Size(601, 401));
  EXPECT_EQ(picture_size_px({.width_px = 64}, make_rectangle_canvas(2000, 16)), cv::Size(64, 1));
}

TEST(PictureSize, on_paper_follows_from_the_resolution) {
  EXPECT_EQ(picture_size_px({.width_px = 601, .width_mm = 254, .dpi = 300}, kCanvas), cv::Size(3000, 2000));
  EXPECT_EQ(picture_size_px({.width_px = 601, .width_mm = 0, .dpi = 150}, kCanvas), cv::Size(601, 401));
}

TEST(PictureSize, on_paper_is_that_of_the_canvas) {
  CanvasSpec spec{.width_px = 300, .height_px = 300, .file = "mask.svg"};  // the page is lower than this box
  EXPECT_EQ(on_paper({}, spec, kCanvas).width_mm, 0);
  spec.width_mm = spec.height_mm = 60;
  EXPECT_EQ(on_paper({}, spec, kCanvas).width_mm, 60);
  EXPECT_EQ(on_paper({}, spec, make_rectangle_canvas(200, 300)).width_mm, 40);
  EXPECT_EQ(on_paper({.width_mm = 7}, spec, kCanvas).width_mm, 7);
}

TEST(PictureSize, on_paper_stays_what_was_asked) {
  // 210 x 297 mm as 1414 x 2000 px; at that scale the px are 209.979 mm wide.
  CanvasSpec spec{.width_px = 1414, .height_px = 2000, .file = ""};
  spec.width_mm = 210;
  spec.height_mm = 297;
  const Canvas canvas = make_rectangle_canvas(1414, 2000);
  const OutputSpec output = on_paper({}, spec, canvas);
  EXPECT_EQ(output.width_mm, 210);
  EXPECT_EQ(page_size_mm(output, spec, canvas), cv::Size2d(210, 297));
  EXPECT_NEAR(page_size_mm({.width_mm = 105}, spec, canvas).height, 148.5, 1e-9);
  EXPECT_NEAR(page_size_px(spec, canvas).width, 1414.1414, 1e-4);
  EXPECT_NEAR(page_size_px(spec, canvas).height, 2000, 1e-9);
  // A page within the box shares one of its sides.
  EXPECT_EQ(
      page_size_mm(on_paper({}, spec, make_rectangle_canvas(1414, 1000)), spec, make_rectangle_canvas(1414, 1000)),
      cv::Size2d(210, 148.5));
  // The canvas is the page if there is no size on paper, or if copies must meet.
  EXPECT_EQ(page_size_mm({}, {}, kCanvas), cv::Size2d(0, 0));
  EXPECT_EQ(page_size_mm({.width_mm = 60}, {}, kCanvas), cv::Size2d(60, 40));
  EXPECT_EQ(page_size_px({}, kCanvas), cv::Size2d(300, 200));
  EXPECT_EQ(page_size_px(spec, make_seamless_canvas(1414, 2000, true, false)), cv::Size2d(1414, 2000));
}

TEST(PictureSize, has_limits_in_px_either_way) {
  EXPECT_NO_THROW(check_picture_size({.width_px = 6000}, make_rectangle_canvas(16, 160)));
  EXPECT_EQ(mistake({.width_px = 6000}, make_rectangle_canvas(16, 161)),
            "output.width_px: found 6000, which makes collage.png 6000 x 60375 px large; allowed for this canvas: 5962 "
            "or less");
  EXPECT_EQ(
      mistake({.width_mm = 1000, .dpi = 2400}, kCanvas),
      "output.width_mm: found 1000.000 at an output.dpi of 2400.000, which makes collage.png 94488 x 62992 px large; "
      "allowed for this canvas: 635.0 mm or less");
  EXPECT_EQ(
      mistake({.width_mm = 1, .dpi = 600}, kCanvas),
      "output.width_mm: found 1.000 at an output.dpi of 600.000, which makes collage.png 24 px wide; allowed: 64 px or "
      "more");
}

TEST(PictureSize, of_canvases_that_go_on_downwards_has_a_whole_height) {
  const OutputSpec output{.width_px = 1000, .background = "#000000"};
  EXPECT_NO_THROW(check_picture_size(output, make_seamless_canvas(1200, 600, true, true)));
  EXPECT_NO_THROW(check_picture_size(output, make_seamless_canvas(1200, 500, true, false)));
  EXPECT_EQ(
      test::message_of([&] { check_picture_size(output, make_seamless_canvas(1200, 500, false, true)); }),
      "output.width_px: found 1000, which makes collage.png 416.67 px high; allowed for a canvas that is seamless "
      "from top to bottom: a width that is a multiple of 12 px");
}

}  // namespace test_picture_size
}  // namespace tessera
