// Drawings deformed as vectors, against the same drawings deformed as pixels, and content that the result may not hold.
#include <gtest/gtest.h>
#include <libxml/parser.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "artwork/artwork_render.h"
#include "artwork/images/alpha.h"
#include "artwork/images/png_uri.h"
#include "artwork/svg/svg_import.h"
#include "artwork/warping/warped_picture.h"
#include "artwork/warping/warped_svg.h"
#include "core/base/error.h"
#include "core/base/processor_time.h"
#include "support/artwork_samples.h"

namespace tessera {
namespace test_warped_svg {

using test::Bytes;
using test::svg;

constexpr int kSide_px = 400;

/// A warp over the page of test::svg, 100 x 50, and a margin.
Warp warp_of_page(Vec2 (*displacement)(Vec2)) {
  Warp warp{.origin = {-10, -10}, .step = 2.5f, .displacement = {49, 29}, .active = {48, 28, 1}};
  for (int j = 0; j < 29; ++j) {
    for (int i = 0; i < 49; ++i) warp.displacement(i, j) = displacement(warp.node(i, j));
  }
  return warp;
}

Warp still() {
  return warp_of_page([](Vec2) { return Vec2{}; });
}

Warp waves() {
  return warp_of_page([](Vec2 p) { return Vec2{1.5f * std::sin(p.y / 8), 1.2f * std::cos(p.x / 9)}; });
}

/// A document that shows the group on a page with a margin of 10 units.
Bytes document(const std::string& group) {
  const std::string text = R"~(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" )~"
                           R"~(width="120" height="70" viewBox="-10 -10 120 70">)~" +
                           group + "</svg>";
  return Bytes(text.begin(), text.end());
}

cv::Mat drawn(const std::string& group) {
  return premultiplied(render_artwork(document(group), "drawn", 3 * kSide_px));
}

/// Means of 3 x 3 px, which depend little on antialiasing.
cv::Mat coarse(const cv::Mat& fine) {
  cv::Mat small;
  cv::resize(fine, small, {}, 1 / 3., 1 / 3., cv::INTER_AREA);
  return small;
}

double difference(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat apart;
  cv::absdiff(a, b, apart);
  const cv::Scalar mean = cv::mean(apart);
  return (mean[0] + mean[1] + mean[2] + mean[3]) / 4;
}

double worst_difference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

/// The deformed picture of the drawing.
cv::Mat deformed(const Bytes& file, const Warp& warp) {
  const float scale = 3 * kSide_px / 120.f;
  const cv::Mat flat = drawn(import_svg(file, "file", "s", {100, 50}));
  return warped_picture(flat, in_frame(warp, scale, {10 * scale, 10 * scale}, false), flat.size());
}

/// The largest error of the mean over some pixels, from 0 to 255.
double error_of(const std::string& body, const Warp& warp) {
  const Bytes file = svg(body);
  return worst_difference(coarse(drawn(warped_svg(file, "file", "s", warp))), coarse(deformed(file, warp)));
}

std::string warped(const std::string& body) { return warped_svg(svg(body), "some/file.svg", "s7", waves()); }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

constexpr char kStar[] =
    R"~(<path d="M50 3L60 40L95 20L70 47L20 45L5 10L40 30Z M45 32h10v5h-10z" fill-rule="evenodd" )~"
    R"~(fill="#2040a0"/>)~";

constexpr char kText[] = R"~(<text x="5" y="40" font-size="30">Tess</text>)~";
constexpr char kDashes[] =
    R"~(<ellipse cx="50" cy="25" rx="30" ry="20" fill="none" stroke="red" stroke-width="3" stroke-dasharray="7 3" )~"
    R"~(transform="rotate(7) scale(1 .8)"/>)~";
constexpr char kTurned[] =
    R"~(<g transform="translate(30 5) rotate(20)"><rect width="40" height="25" rx="5" fill="#063"/></g>)~";
constexpr char kSymbols[] =
    R"~(<symbol id="a" viewBox="0 0 9 9"><circle cx="4" cy="4" r="4"/></symbol>)~"
    R"~(<use xlink:href="#a" width="30" height="30"/><use xlink:href="#a" x="40" width="45" height="45"/>)~";
constexpr char kLayer[] = R"~(<style>.b{fill:#b02}</style><g class="b" opacity=".5"><path d="M5 5H70V40Z"/>)~"
                          R"~(<circle cx="50" cy="25" r="20"/></g>)~";

TEST(WarpedSvg, WithoutDisplacementIsTheDrawing) {
  for (const std::string body : {kStar, kText, kDashes, kTurned, kSymbols, kLayer}) {
    EXPECT_LE(error_of(body, still()), 12) << body;
  }
}

TEST(WarpedSvg, PathsAreWhereTheirPictureIs) {
  for (const std::string body : {kStar, kText, kTurned, kSymbols, kLayer}) {
    EXPECT_LE(error_of(body, waves()), 40) << body;  // of 255, at edges
    EXPECT_LT(difference(coarse(drawn(warped(body))), coarse(deformed(svg(body), waves()))), 0.3) << body;
  }
}

TEST(WarpedSvg, ClipsAndMasksAreDeformedAsWell) {
  EXPECT_LE(error_of(R"~(<clipPath id="c"><path clip-rule="evenodd" d="M10 5H90V45H10Z M30 15H60V35H30Z"/></clipPath>)~"
                     R"~(<g clip-path="url(#c)"><rect width="100" height="50" fill="green"/></g>)~",
                     waves()),
            40);
  EXPECT_LE(error_of(R"~(<mask id="m"><circle cx="50" cy="25" r="22" fill="#aaa"/></mask>)~"
                     R"~(<g mask="url(#m)"><rect width="100" height="50" fill="green"/></g>)~",
                     waves()),
            40);
}

TEST(WarpedSvg, BitmapsAndWhatIsDrawnAsPixelsAreDeformedAsPixels) {
  cv::Mat picture(50, 80, CV_8UC4);
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 80; ++x) {
      picture.at<cv::Vec4b>(y, x) = cv::Vec4b(std::uint8_t(3 * x), std::uint8_t(5 * y), 90, 255);
    }
  }
  const std::string place = R"~(x="20" y="-5" width="40" height="40" transform="rotate(15)" )~";
  const std::string image = "<image " + place + "xlink:href=\"" + png_uri(picture) + "\"/>";
  EXPECT_LE(error_of(image, waves()), 40);
  const std::string blurred =
      R"~(<filter id="f"><feGaussianBlur stdDeviation="3"/></filter><circle cx="50" cy="25" r="12" filter="url(#f)"/>)~";
  EXPECT_LE(error_of(blurred, waves()), 12);
  EXPECT_TRUE(contains(warped(blurred), "data:image/png;base64,"));
}

TEST(WarpedSvg, GradientsGoWithWhatTheyFill) {
  const std::string gradient =
      R"~(<linearGradient id="g"><stop stop-color="black"/><stop offset="1" stop-color="white"/></linearGradient>)~"
      R"~(<rect x="10" y="10" width="50" height="30" fill="url(#g)"/>)~";
  const Warp moved = warp_of_page([](Vec2) { return Vec2{6, 3}; });
  EXPECT_LE(error_of(gradient, moved), 40);
  EXPECT_LT(
      difference(coarse(drawn(warped_svg(svg(gradient), "f", "s", moved))), coarse(deformed(svg(gradient), moved))),
      0.3);
}

TEST(WarpedSvg, LayersAreBlendedAsTheyWere) {
  EXPECT_LE(error_of(R"~(<rect x="10" y="10" width="50" height="30" fill="#8cf"/>)~"
                     R"~(<g style="mix-blend-mode:multiply"><circle cx="55" cy="25" r="15" fill="#fc4"/></g>)~",
                     waves()),
            40);
}

TEST(WarpedSvg, StrokesKeepTheirWidth) {
  const Warp wider = warp_of_page([](Vec2 p) { return Vec2{0, p.y}; });  // twice as high
  const cv::Mat drawing =
      drawn(warped_svg(svg(R"~(<path d="M-5 10H105" stroke="black" stroke-width="4"/>)~"), "f", "s", wider));
  const cv::Mat column = drawing.col(drawing.cols / 2);
  EXPECT_NEAR(cv::sum(column)[3] / 255, 4 * 10, 1);  // 10 px a unit
}

TEST(WarpedSvg, NothingIsShownFromBeyondThePage) {
  const Warp moved = warp_of_page([](Vec2) { return Vec2{6, 3}; });
  const cv::Mat drawing =
      drawn(warped_svg(svg(R"~(<rect x="-50" y="-50" width="500" height="500"/>)~"), "f", "s", moved));
  const cv::Rect page(160, 130, 1000, 500);
  EXPECT_NEAR(cv::sum(drawing)[3] / 255, page.area(), page.area() * 1e-3);
  EXPECT_EQ(cv::countNonZero(drawing.reshape(1)(cv::Rect(0, 0, drawing.cols * 4, 128))), 0);
}

/// Only the look of the drawing is left of the file.
TEST(WarpedSvg, NothingOfTheFileComesIn) {
  const std::string g = warped(
      R"~(<script>evil()</script><g id="evil" onclick="evil()"><rect id="r" class="evil" width="9" height="9"/></g>)~"
      R"~(<image xlink:href="http://evil/x.png" width="9" height="9"/><a xlink:href="javascript:evil()"><circle r="9"/></a>)~"
      R"~(<foreignObject><body xmlns="http://www.w3.org/1999/xhtml">evil</body></foreignObject><text y="20">evil</text>)~"
      R"~(<image xlink:href="file:///etc/passwd" width="9" height="9"/><style>@import url(evil.css); rect{fill:red}</style>)~");
  for (const char* part : {"evil", "script", "href", "onclick", "<text", "style", "<use", "http", "file"}) {
    EXPECT_FALSE(contains(g, part)) << part << "\n" << g;
  }
  EXPECT_TRUE(contains(g, "#ff0000")) << g;
}

TEST(WarpedSvg, IsOneGroupWhoseIdsBeginWithTheScope) {
  const std::string g = warped(
      R"~(<linearGradient id="g"><stop/><stop offset="1" stop-color="red"/></linearGradient>)~"
      R"~(<mask id="m"><circle cx="50" cy="25" r="22" fill="url(#g)"/></mask><clipPath id="c"><circle r="30"/></clipPath>)~"
      R"~(<pattern id="p" width="9" height="9" patternUnits="userSpaceOnUse"><circle cx="4" cy="4" r="3"/></pattern>)~"
      R"~(<g mask="url(#m)"><rect width="80" height="50" fill="url(#g)"/></g><circle cx="50" cy="30" r="9" fill="url(#p)"/>)~"
      R"~(<g clip-path="url(#c)"><rect width="80" height="50" fill="url(#g)"/></g>)~");
  EXPECT_TRUE(g.starts_with("<g id=\"s7\"")) << g;
  for (const std::string start : {"id=\"", "url(#"}) {
    for (std::size_t at = g.find(start); at != std::string::npos; at = g.find(start, at + 1)) {
      const std::string id = g.substr(at + start.size(), 3);
      EXPECT_TRUE(id == "s7-" || id == "s7\"") << g.substr(at, 30);
    }
  }
  for (const char* part : {"<linearGradient", "<mask", "<clipPath", "<pattern"}) EXPECT_TRUE(contains(g, part)) << part;
  const Bytes whole = document(g);
  xmlDoc* doc = xmlReadMemory(reinterpret_cast<const char*>(whole.data()), int(whole.size()), nullptr, nullptr,
                              XML_PARSE_NOERROR);
  EXPECT_NE(doc, nullptr);
  xmlFreeDoc(doc);
}

TEST(WarpedSvg, TheSameDrawingGivesTheSameBytes) { EXPECT_EQ(warped(kStar), warped(kStar)); }

std::string mistake(const Bytes& file, const Warp& warp = waves()) {
  try {
    warped_svg(file, "some/file.svg", "s", warp);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no mistake found";
}

TEST(WarpedSvg, WhatIsNoSvgIsAnError) {
  for (const Bytes& file : {Bytes{}, Bytes(1000, 'x'), Bytes(1000, '<'), test::encoded(test::disc_with_alpha(), ".png"),
                            svg("", R"~(width="0" height="0")~"), svg("", R"~(width="1e9" height="1e9")~")}) {
    EXPECT_TRUE(mistake(file).starts_with("some/file.svg: ")) << mistake(file);
  }
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

/// Each layer shows the layer before it ten times.
std::string layers_of_layers(int levels) {
  std::string body = R"~(<defs><g id="l0" opacity=".5"><circle r="5"/><rect width="9" height="3"/></g>)~";
  for (int i = 1; i < levels; ++i) {
    body += "<g id=\"l" + std::to_string(i) + "\" opacity=\".5\">" +
            repeated("<use xlink:href=\"#l" + std::to_string(i - 1) + "\"/>", 10) + "</g>";
  }
  return body + "</defs><use xlink:href=\"#l" + std::to_string(levels - 1) + "\"/>";
}

/// Expects a drawing or a reason that names the file, within a short time.
void expect_bounded(const std::string& body, const Warp& warp = waves()) {
  const double start_s = processor_time_s();
  try {
    EXPECT_LE(warped_svg(svg(body), "some/file.svg", "s", warp).size(), std::size_t(64) << 20) << body.substr(0, 200);
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("some/file.svg: ")) << error.what();
  }
  EXPECT_LT(processor_time_s() - start_s, 60) << body.substr(0, 200);
}

TEST(WarpedSvg, WhatIsAbsurdIsDrawnOrRefused) {
  for (const char* transform :
       {"scale(1e300)", "scale(1e-300)", "matrix(nan 0 0 1 0 0)", "scale(0)", "translate(1e30 -1e30)",
        "matrix(1 1 1 1 0 0)", "scale(1e9) translate(-50 -25)", "rotate(1e300)"}) {
    expect_bounded("<g transform=\"" + std::string(transform) + "\">" + kStar + kDashes + kText + kLayer + "</g>");
  }
  for (const char* size : {"1e-9", "1e9", "0", "-5", "nan"}) {
    const std::string tile = "<pattern id=\"p\" patternUnits=\"userSpaceOnUse\" width=\"" + std::string(size) +
                             "\" height=\"" + size + "\"><circle r=\"1\"/></pattern>";
    expect_bounded(tile + R"~(<rect width="100" height="50" fill="url(#p)"/>)~");
  }
  expect_bounded(R"~(<pattern id="p" width="1" height="1"><rect width="9" height="9" fill="url(#p)"/></pattern>)~"
                 R"~(<rect width="100" height="50" fill="url(#p)"/>)~");
  expect_bounded(R"~(<g id="a"><use xlink:href="#b"/></g><g id="b"><use xlink:href="#a"/></g>)~");
  expect_bounded(R"~(<path d="M0 0L1e300 1e300L-1e300 5Z M0 0C1e9 1e9 -1e9 1e9 50 50" stroke="red"/>)~");
  expect_bounded(R"~(<path d="M0 0H100" stroke="red" stroke-width="1e300" stroke-dasharray="1e-9 1e-9"/>)~");
}

TEST(WarpedSvg, WhatIsTooMuchIsRefused) {
  expect_bounded(layers_of_layers(4));
  const std::string many = repeated(R"~(<path d="M0 0H9V9"/>)~", 101'000);
  EXPECT_NE(mistake(svg(many)).find("too many elements"), std::string::npos);
  const std::string zigzag = "<path d=\"M0 0" + repeated("L100 50L0 50L100 0", 100'000) + "\"/>";
  EXPECT_NE(mistake(svg(zigzag)).find("too many steps"), std::string::npos);
}

TEST(WarpedSvg, AnyWarpIsDrawnOrRefused) {
  for (const float far : {1e3f, 1e6f}) {
    Warp torn = waves();
    torn.displacement(20, 10) = {far, -far};
    expect_bounded(
        std::string(kStar) + kDashes + R"~(<filter id="f"><feFlood/></filter><circle r="30" filter="url(#f)"/>)~",
        torn);
  }
  Warp folded = warp_of_page([](Vec2 p) { return p * -3; });
  expect_bounded(std::string(kStar) + kText, folded);
  Warp fine = waves();
  fine.step = 1e-6f;
  expect_bounded(std::string(kStar) + R"~(<filter id="f"><feFlood/></filter><circle r="30" filter="url(#f)"/>)~", fine);
  Warp coarse{.origin = {-1e6f, -1e6f}, .step = 1e6f, .displacement = {3, 3}, .active = {2, 2, 1}};
  expect_bounded(std::string(kStar) + R"~(<filter id="f"><feFlood/></filter><circle r="30" filter="url(#f)"/>)~",
                 coarse);
}

}  // namespace test_warped_svg
}  // namespace tessera
