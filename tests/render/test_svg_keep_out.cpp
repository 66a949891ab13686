// Letters as keep-out zones, drawn as a layer of collage.svg and collage.png.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "job/canvas/canvas_file.h"
#include "support/images.h"
#include "support/scratch_folder.h"
#include "support/svg_samples.h"

namespace tessera {
namespace test_svg_keep_out {

using namespace test;

/// A page of 100 x 50 on the canvas of 200 x 100, with a bar as letters below both pieces.
struct WithKeepOut : SampleCollage {
  explicit WithKeepOut(const std::string& body) {
    const std::string head = std::string(kXmlns) + "width=\"100\" height=\"50\">";
    job.canvas.keep_out = folder.write("letters.svg", head + body + "</svg>");
    Drawers drawers(canvas_drawer_settings(job.canvas));
    report.keep_out = draw_keep_out(job.canvas.keep_out, report.output, canvas, drawers);
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
  ASSERT_TRUE(test::write_image(collage.job.canvas.keep_out, image));
  Drawers drawers(canvas_drawer_settings(collage.job.canvas));
  collage.report.keep_out = draw_keep_out(collage.job.canvas.keep_out, collage.report.output, collage.canvas, drawers);
  const cv::Mat picture = drawn_picture(collage.report);
  EXPECT_EQ(picture.at<cv::Vec3b>(180, 200), cv::Vec3b(0xc0, 0x40, 0x20));
  EXPECT_LT(mean_difference(picture, drawn(drawn_svg(collage.report), 400)), 0.5);
}

}  // namespace test_svg_keep_out
}  // namespace tessera
