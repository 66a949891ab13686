// How large the pictures become, in px and on paper.
#include "io/job/picture_size.h"

#include <gtest/gtest.h>

#include "support/input_error.h"

namespace tessera::io {
namespace {

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

TEST(PictureSize, has_limits_in_px_either_way) {
  EXPECT_NO_THROW(check_picture_size({.width_px = 6000}, make_rectangle_canvas(16, 160)));
  EXPECT_EQ(mistake({.width_px = 6000}, make_rectangle_canvas(16, 161)),
            "output.width_px: found 6000, which makes collage.png 6000 x 60375 px large; allowed for this canvas: 5962 "
            "or less");
  EXPECT_EQ(mistake({.width_mm = 1000, .dpi = 2400}, kCanvas),
            "output.width_mm: found 1000.000 at an output.dpi of 2400.000, which makes collage.png 94488 x 62992 px large; "
            "allowed for this canvas: 635.0 mm or less");
  EXPECT_EQ(mistake({.width_mm = 1, .dpi = 600}, kCanvas),
            "output.width_mm: found 1.000 at an output.dpi of 600.000, which makes collage.png 24 px wide; allowed: 64 px or "
            "more");
}

}  // namespace
}  // namespace tessera::io
