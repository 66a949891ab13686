// Style sheets of a drawing: in another document it looks as it does alone.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <opencv2/core.hpp>

#include "artwork/artwork_render.h"
#include "artwork/css/css_declarations.h"
#include "artwork/css/css_tokens.h"
#include "artwork/svg/svg_import.h"
#include "core/base/error.h"
#include "core/base/processor_time.h"
#include "style_sheets.h"
#include "support/artwork_samples.h"

namespace tessera {
namespace test_svg_style {

using test::Bytes;
using test::kOwnSheets;
using test::styled_body;
using test::svg;

std::string declarations(const std::string& style) {
  std::string text;
  for (const CssDeclaration& declaration : local_css_declarations(css_tokens(style), "p-")) {
    text += (text.empty() ? "" : ";") + declaration.name + ":" + declaration.value;
  }
  return text;
}

TEST(SvgStyle, DeclarationsAreSplitOutsideOfQuotesAndBrackets) {
  EXPECT_EQ(declarations("font-family:'a;b' ; fill : red;;-inkscape-x:1; bad"), "font-family:'a;b';fill:red");
  EXPECT_EQ(declarations("/* fill:red; */stroke:/**/blue"), "stroke:blue");
  EXPECT_EQ(declarations("fill:red}*{stroke:url(evil)"), "");
  EXPECT_EQ(declarations("fill:red !important"), "fill:red !important");
}

/// An open bracket or quote must not affect the text after it.
TEST(SvgStyle, BracketsAndQuotesAreClosed) {
  EXPECT_EQ(declarations("fill:rgb(1,2,3"), "fill:rgb(1,2,3)");
  EXPECT_EQ(declarations("fill:rgb((1"), "fill:rgb((1))");
  for (const char* open : {"font-family:'x", "font-family:\"x\n;fill:red\"", "fill:url(x", "fill:url('#x'", "fill:[x]",
                           "fill:{x}", "fill:)", "fill:rgb(1))"}) {
    EXPECT_EQ(declarations(open), "") << open;
  }
  EXPECT_EQ(declarations("font-family:'x\\'"), "");
}

TEST(SvgStyle, ValuesReferToTheirOwnDocumentAlone) {
  EXPECT_EQ(declarations("fill:url(#a)"), "fill:url(#p-a)");
  EXPECT_EQ(declarations("fill:url( '#a' )"), "fill:url(#p-a)");
  EXPECT_EQ(declarations("fill:u\\72l(#a)"), "fill:url(#p-a)");
  EXPECT_EQ(declarations("fill:url(\\23 a\\29 b)"), "fill:url(\"#p-a)b\")");
  EXPECT_EQ(declarations("fill:url(\"#a' b\")"), "fill:url(\"#p-a' b\")");
  EXPECT_EQ(declarations("font-family:'a\\27 b'"), "font-family:'a\\27 b'");
  for (const char* elsewhere :
       {"url(x.svg#a)", "url( x#a)", "url()", "url(#)", "url(//x#a)", "image('x')", "image-set('x' 1x)", "src('x')",
        "element(#a)", "var(--x)", "attr(href)", "-x-url(x)", "expression(x)", "paint(x)", "url(#a x)", "url('#a' x)",
        "i\\6dage('x')", "red\\28 x", "U\\52 L(x)"}) {
    const std::string kept = declarations(std::string("fill:") + elsewhere);
    EXPECT_TRUE(kept.empty() || kept == "fill:red\\28 x") << kept;
  }
}

/// A comment divides a value that would be an address without it. In a copy without comments it would become one.
TEST(SvgStyle, ValuesDividedByCommentsReferToNothing) {
  const std::vector<std::string> values = {"url/**/('http://evil/x.svg#a')",
                                           "url/**/('#other')",
                                           "url/**/(#other)",
                                           "u\\72l/**/('#other')",
                                           "ur/**/l('#other')",
                                           "ur/**/l(#other)",
                                           "image-set/**/('http://evil/x' 1x)",
                                           "image-set/*/*/('http://evil/x' 1x)",
                                           "rgb(1,url/**/('http://evil/x'))",
                                           "red url/**//**/('http://evil/x')"};
  for (const std::string& value : values) {
    EXPECT_EQ(declarations("fill:" + value), "") << value;
    EXPECT_EQ(local_css_value(value, "p-"), std::nullopt) << value;
    for (const std::string& body : {"<rect style=\"fill:" + value + "\"/>", "<rect fill=\"" + value + "\"/>",
                                    "<style>rect{fill:" + value + "}</style><rect/>"}) {
      const std::string copy = import_svg(svg(body), "file", "s", {100, 50});
      EXPECT_NE(copy.find("<rect/>"), std::string::npos) << copy;
    }
  }
}

TEST(SvgStyle, NoCommentBeginsInACopy) {
  const std::string kept = declarations("stroke:red//**/*;a:'*/;fill:url(http://evil/x.svg)'");
  EXPECT_EQ(kept, "stroke:red/**///**/*;a:'*/;fill:url(http://evil/x.svg)'");
  EXPECT_EQ(declarations("stroke-dasharray:5/**/3"), "stroke-dasharray:5/**/3");
  EXPECT_EQ(local_css_value("translate(5/**/3)", "p-"), "translate(5/**/3)");
}

/// Characters that XML does not allow would damage the document around the copy.
TEST(SvgStyle, ACopyIsXmlWhateverIsEscaped) {
  for (const char* value :
       {"'\\fffe '", "'\\ffff x'", "'\\1 '", "a\\c b", "url(\\23 a\\c b)", "url('#a\\b b')", "'\\d800 '"}) {
    const std::string body =
        std::string("<rect style=\"font-family:") + value + ";fill:lime\" width=\"100\" height=\"50\"/>";
    const cv::Mat drawn = render_artwork(svg(import_svg(svg(body), "file", "s", {100, 50})), "copy", 100);
    EXPECT_EQ(drawn.at<cv::Vec4b>(10, 10), cv::Vec4b(0, 255, 0, 255)) << value;
  }
}

cv::Mat alone(const Bytes& file) { return render_artwork(file, "file", 200); }

cv::Mat copied(const Bytes& file) { return render_artwork(svg(import_svg(file, "file", "s", {100, 50})), "copy", 200); }

TEST(SvgStyle, ACopyLooksAsTheDrawingDoesAlone) {
  for (const char* sheet : kOwnSheets) {
    const Bytes file = svg(styled_body(sheet));
    EXPECT_EQ(cv::norm(alone(file), copied(file), cv::NORM_INF), 0) << sheet;
  }
}

TEST(SvgStyle, SheetsStandAnywhereAndOldFilesForgetTheNameSpace) {
  const std::string old =
      "<svg width=\"100\" height=\"50\"><style>rect.a{fill:red}</style><rect class=\"a\" width=\"40\" "
      "height=\"40\"/><style>rect{fill:blue;stroke:lime}</style></svg>";
  const Bytes file(old.begin(), old.end());
  EXPECT_EQ(cv::norm(alone(file), copied(file), cv::NORM_INF), 0);
  EXPECT_EQ(copied(file).at<cv::Vec4b>(10, 10), cv::Vec4b(0, 0, 255, 255));
}

/// No result could be taken for a sheet by a renderer, and the document stays well-formed.
RC_GTEST_PROP(SvgStyle, NoTextBecomesASheet, ()) {
  const auto parts =
      *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(std::vector<std::string>{"*",
                                                                                                "~",
                                                                                                "+",
                                                                                                ">",
                                                                                                " ",
                                                                                                "\n",
                                                                                                "{",
                                                                                                "}",
                                                                                                "(",
                                                                                                ")",
                                                                                                "[",
                                                                                                "]",
                                                                                                "'",
                                                                                                "\"",
                                                                                                "\\",
                                                                                                "\\7e ",
                                                                                                "/*",
                                                                                                "*/",
                                                                                                "&lt;!--",
                                                                                                "-->",
                                                                                                "@media",
                                                                                                "@import",
                                                                                                "rect",
                                                                                                ".a",
                                                                                                "#r",
                                                                                                ":not(",
                                                                                                ":nth-child(",
                                                                                                "2n+1",
                                                                                                "fill",
                                                                                                ":",
                                                                                                "red",
                                                                                                ";",
                                                                                                "!important",
                                                                                                "url(",
                                                                                                "url(#x)",
                                                                                                "data:",
                                                                                                ",",
                                                                                                "|",
                                                                                                "=",
                                                                                                "1e3",
                                                                                                "&#7;",
                                                                                                "\xc3\xa4",
                                                                                                "</style><style>"}));
  std::string sheet;
  for (const std::string& part : parts) sheet += part == "&#7;" ? "" : part;
  std::string copy;
  try {
    copy = import_svg(svg(styled_body(sheet)), "file", "s", {100, 50});
  } catch (const InputError&) {
    return;  // this sheet comes from a data: address
  }
  RC_ASSERT(copy.find("<style") == std::string::npos);
  RC_ASSERT(copy.find("data:") == std::string::npos);
  RC_ASSERT(copied(svg(styled_body(sheet))).size() == cv::Size(200, 100));
}

/// A careless reader would scan each of these sheets again and again. For the time of matching see test_css_effort.cpp.
TEST(SvgStyle, LongSheetsAreReadOnce) {
  for (const char* part : {"(", "[", "{", "a{", "@a", "@a{", "'\n", "\\", "/*", "url(", ":not(", "a,", "a ", "[a",
                           "a{b:(", "a{b:url(", "a{b:c;", "&lt;!--"}) {
    std::string sheet;
    for (int i = 0; i < 100000; ++i) sheet += part;
    const double start_s = processor_time_s();
    import_svg(svg("<style>" + sheet + "</style>"), "file", "s", {100, 50});
    EXPECT_LT(processor_time_s() - start_s, 3) << part;
  }
}

}  // namespace test_svg_style
}  // namespace tessera
