// The SVG of a collage as the PDF contains it, drawn here as pixels.
#include "artwork/svg/printed_svg.h"

#include <gtest/gtest.h>

#include <cmath>

#include "artwork/images/cairo_objects.h"
#include "support/input_error.h"

namespace tessera {
namespace test_printed_svg {

std::span<const std::uint8_t> bytes(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

cv::Mat drawn(const std::string& svg, int width, int height) {
  const PrintedSvg printed(bytes(svg), "collage.svg");
  cv::Mat image(height, width, CV_8UC4, cv::Scalar::all(0));
  const CairoSurface surface(
      cairo_image_surface_create_for_data(image.data, CAIRO_FORMAT_ARGB32, width, height, int(image.step)));
  const CairoContext cairo(cairo_create(surface.get()));
  printed.draw(cairo.get(), width);
  cairo_surface_flush(surface.get());
  return image;
}

/// A page of 100 x 20, whose first fifth is red and the rest blue, by a gradient over the box of a bar.
std::string collage(const std::string& transform) {
  return R"~(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink")~"
         R"~( width="400" height="200" viewBox="0 0 200 100"><defs><g id="a0"><svg width="100" height="20">)~"
         R"~(<linearGradient id="a0-g">)~"
         R"~(<stop offset=".2" stop-color="#f00"/><stop offset=".2" stop-color="#00f"/></linearGradient>)~"
         R"~(<rect width="100" height="20" fill="url(#a0-g)" fill-opacity=".5"/></svg></g>)~"
         R"~(<clipPath id="c0"><path d="M0 0L100 0L100.000 15.000L0 15Z"/></clipPath></defs>)~"
         R"~(<g id="layer-canvas"><rect width="100%" height="100%" fill="#0f0"/></g>)~"
         R"~(<g id="layer-pieces"><g id="piece-0-bar" transform=")~" +
         transform + R"~("><title>bar</title><use xlink:href="#a0" clip-path="url(#c0)"/></g></g></svg>)~";
}

const cv::Vec4b kGreen(0, 255, 0, 255);

void expect_near(const cv::Vec4b& found, const cv::Vec4b& expected) {
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(found[i], expected[i], 2) << found << expected;
}

TEST(PrintedSvg, PiecesAreStretchedWithTheirPage) {
  std::string svg = collage("matrix(1 0 0 1 20 10)");
  svg.replace(svg.find("width=\"400\" height=\"200\""), 24,
              "width=\"400\" height=\"400\" preserveAspectRatio=\"none\"");
  const cv::Mat image = drawn(svg, 200, 200);
  expect_near(image.at<cv::Vec4b>(45, 100), {128, 127, 0, 255});  // at 22 in the document
  expect_near(image.at<cv::Vec4b>(55, 100), kGreen);              // beyond the clip, at 27 in the document
  expect_near(image.at<cv::Vec4b>(195, 5), kGreen);
}

TEST(PrintedSvg, GradientsOfPiecesThatAreTurnedFollowTheirObject) {
  // Twice as large, turned by a third of a right angle, moved by (20, 10).
  const double c = std::sqrt(3.), s = 1;
  const cv::Mat image = drawn(collage("matrix(1.7320508 1.0000000 -1.0000000 1.7320508 20.000 10.000)"), 200, 100);
  const auto at = [&](double x, double y) {
    return image.at<cv::Vec4b>(int(10 + x * s + y * c), int(20 + x * c - y * s));
  };
  for (const double x : {5., 18.}) expect_near(at(x, 7), {0, 127, 128, 255});  // red over green, half each
  for (const double x : {22., 70.}) expect_near(at(x, 7), {128, 127, 0, 255});
  expect_near(at(30, 17), kGreen);  // clipped
  expect_near(image.at<cv::Vec4b>(95, 5), kGreen);
}

/// Blue, a quarter opaque, over a green canvas and a red piece.
TEST(PrintedSvg, TheOverlayLiesAboveThePieces) {
  std::string svg = collage("matrix(1 0 0 1 20 10)");
  svg.insert(svg.rfind("</svg>"),
             R"(<g id="layer-overlay" opacity="0.25"><rect width="50%" height="100%" fill="#00f"/></g>)");
  const cv::Mat image = drawn(svg, 400, 200);
  expect_near(image.at<cv::Vec4b>(40, 60), {64, 96, 96, 255});  // the piece (half red, half green) below the overlay
  expect_near(image.at<cv::Vec4b>(180, 60), {64, 191, 0, 255});
  expect_near(image.at<cv::Vec4b>(40, 220), {128, 127, 0, 255});  // to the right of the overlay
  expect_near(image.at<cv::Vec4b>(180, 220), kGreen);
}

TEST(PrintedSvg, MayBeAnySvg) {
  const cv::Mat image = drawn(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="8" height="4"><rect width="4" height="4"/></svg>)", 80, 40);
  EXPECT_EQ(image.at<cv::Vec4b>(20, 20), cv::Vec4b(0, 0, 0, 255));
  EXPECT_EQ(image.at<cv::Vec4b>(20, 60), cv::Vec4b());
  EXPECT_EQ(test::message_of([] { PrintedSvg(bytes("x"), "a.svg"); }), "a.svg: not a readable SVG file");
  EXPECT_EQ(test::message_of([] { PrintedSvg(bytes(collage("scale(2)")), "a.svg"); }),
            "piece-0-bar: transform: found \"scale(2)\", allowed: a matrix");
}

}  // namespace test_printed_svg
}  // namespace tessera
