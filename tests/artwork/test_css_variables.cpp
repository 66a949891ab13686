// var() in drawings. librsvg does not support it.
#include <gtest/gtest.h>

#include "artwork/artwork_render.h"
#include "artwork/css/css_variables.h"
#include "artwork/svg/svg_import.h"
#include "core/base/error.h"
#include "core/base/processor_time.h"
#include "support/artwork_samples.h"
#include "support/input_error.h"

namespace tessera {
namespace test_css_variables {

using test::Bytes;
using test::svg;

/// The colour of the middle as "rrggbb", or "none" where nothing is drawn.
std::string colour_of(const Bytes& bytes) {
  const cv::Mat image = render_artwork(bytes, "a.svg", 64, Background::kept);
  const cv::Vec4b p = image.at<cv::Vec4b>(32, 32);
  if (p[3] == 0) return "none";
  char text[8];
  std::snprintf(text, sizeof text, "%02x%02x%02x", p[2], p[1], p[0]);
  return text;
}

/// The colour of the drawing alone and, if that differs, also inside another document.
std::string drawn(const std::string& content) {
  const Bytes bytes = svg(content, "width='100' height='100'");
  const std::string alone = colour_of(bytes);
  const std::string text =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
      "width='100' height='100'>" +
      import_svg(bytes, "a.svg", "s", {100, 100}) + "</svg>";
  const std::string imported = colour_of(Bytes(text.begin(), text.end()));
  return alone == imported ? alone : alone + " and " + imported;
}

const std::string kRect = " width='100' height='100'/>";

TEST(CssVariables, AreResolvedInAttributesStylesAndSheets) {
  EXPECT_EQ(drawn("<rect style='fill:var(--b, #cc3333)'" + kRect), "cc3333");
  EXPECT_EQ(drawn("<rect fill='var(--b,#cc3333)'" + kRect), "cc3333");
  EXPECT_EQ(drawn("<style>:root{--b:#3333cc}</style><rect fill='var(--b, #cc3333)'" + kRect), "3333cc");
  EXPECT_EQ(drawn("<style>:root{--b:#3333cc} rect{fill:VAR( --b )}</style><rect" + kRect), "3333cc");
  EXPECT_EQ(drawn("<g style='--b:#3333cc'><g style='--b:#33cc33'><rect style='fill:var(--b)'" + kRect + "</g></g>"),
            "33cc33");
  EXPECT_EQ(drawn("<g style='--b:#33cc33'><rect style='fill:red'" + kRect + "</g><rect fill='var(--b, blue)'" + kRect),
            "0000ff")
      << "a variable counts in its own group";
  EXPECT_EQ(drawn("<style>rect{fill:rgb(var(--rgb))} :root{--rgb:1,2,3}</style><rect" + kRect), "010203");
}

TEST(CssVariables, MayStandForEachOther) {
  EXPECT_EQ(drawn("<g style='--a:var(--b);--b:var(--c, #123456)'><rect style='fill:var(--a)'" + kRect + "</g>"),
            "123456");
  EXPECT_EQ(drawn("<g style='--a:var(--b);--b:var(--a)'><rect style='fill:var(--a, lime)'" + kRect + "</g>"), "00ff00");
  EXPECT_EQ(drawn("<g style='--a:var(--b)'><g style='--b:red'><rect style='fill:var(--a, lime)'" + kRect + "</g></g>"),
            "00ff00")
      << "what a variable stands for is settled where it is declared";
}

TEST(CssVariables, InACycleHaveNoValue) {
  EXPECT_EQ(drawn("<g style='--a:var(--b,blue);--b:var(--a,green)'><rect style='fill:var(--a, lime)'" + kRect + "</g>"),
            "00ff00");
  EXPECT_EQ(drawn("<g style='--a:red'><rect style='--a:initial;fill:var(--a, lime)'" + kRect + "</g>"), "00ff00");
  EXPECT_EQ(drawn("<g style='--a:red'><rect style='--a:inherit;fill:var(--a, lime)'" + kRect + "</g>"), "ff0000");
}

TEST(CssVariables, StandInPropertiesAlone) {
  EXPECT_EQ(drawn("<rect id='a var(--b)' fill='red'" + kRect), "ff0000");
  EXPECT_EQ(drawn("<rect style='fill:var(--m, lime); /* x'" + kRect), "00ff00");
  EXPECT_EQ(drawn("<style>rect{fill:var(--b, red) ! important}</style><rect style='fill:lime'" + kRect), "ff0000");
  EXPECT_EQ(drawn("<rect style='fill:lime;opacity:0;opacity:var(--zz)'" + kRect), "00ff00");
}

TEST(CssVariables, WithoutAValueThePropertyIsInherited) {
  EXPECT_EQ(drawn("<g fill='#3333cc'><rect style='fill:var(--zz)'" + kRect + "</g>"), "3333cc");
  EXPECT_EQ(drawn("<rect fill='var(--zz)'" + kRect), "000000") << "as a browser: black";
  EXPECT_EQ(drawn("<rect fill='var(--zz, none)'" + kRect), "none");
  EXPECT_EQ(drawn("<rect style='opacity:var(--zz);fill:lime'" + kRect), "00ff00");
}

TEST(CssVariables, TheDeclarationThatCountsIsResolved) {
  EXPECT_EQ(drawn("<style>rect{fill:var(--b, red)} #r{fill:lime}</style><rect id='r'" + kRect), "00ff00");
  EXPECT_EQ(drawn("<style>#r{fill:var(--b, red)} rect{fill:lime}</style><rect id='r'" + kRect), "ff0000");
  EXPECT_EQ(drawn("<style>rect{fill:var(--b, red)!important}</style><rect style='fill:lime'" + kRect), "ff0000");
  EXPECT_EQ(drawn("<style>rect{fill:lime!important}</style><rect style='fill:var(--b, red)'" + kRect), "00ff00");
  EXPECT_EQ(drawn("<style>rect{fill:lime}</style><rect fill='var(--b, red)'" + kRect), "00ff00");
}

TEST(CssVariables, OtherDrawingsStayAsTheyAre) {
  const Bytes bytes = svg("<rect style='fill:red;--a:blue'" + kRect);
  EXPECT_EQ(with_css_variables(bytes, "a.svg"), std::nullopt);
  EXPECT_EQ(with_css_variables(svg("<title>var(--a)</title><style>@import url('data:text/css,');</style>"), "a.svg"),
            std::nullopt)
      << "no property has it";
}

TEST(CssVariables, HostileOnesEndSoon) {
  const double begin_s = processor_time_s();
  std::string doubling = "<g style='", empty = doubling;
  for (int i = 0; i < 60; ++i) {
    const std::string next = "var(--v" + std::to_string(i + 1) + ")", name = "--v" + std::to_string(i) + ":";
    doubling += name + next + " " + next + ";";
    empty += name + next + next + ";";
  }
  const std::string rest = "'><rect style='fill:var(--v0, lime)'" + kRect + "</g>";
  EXPECT_EQ(drawn(doubling + "--v60:x" + rest), "00ff00");
  EXPECT_EQ(test::message_of([&] { drawn(empty + "--v60:;" + rest); }),
            "a.svg: found more than 1000000 var() in its styles; allowed: 1000000 or fewer");
  EXPECT_LT(processor_time_s() - begin_s, 30);
}

}  // namespace test_css_variables
}  // namespace tessera
