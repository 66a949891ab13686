// Foreign SVGs inside another document: no part of them runs, loads or clashes.
#include <gtest/gtest.h>

#include "artwork/svg/svg_import.h"
#include "core/base/error.h"
#include "core/base/processor_time.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_svg_import {

constexpr char kHead[] =
    R"~(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 10 20")~";

std::string import(const std::string& file) {
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
  return import_svg(bytes, "some/file.svg", "a4", {10, 20});
}

std::string import_body(const std::string& body, const std::string& attributes = "") {
  return import(std::string(kHead) + attributes + ">" + body + "</svg>");
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(SvgImport, KeepsTheDrawingOnItsPage) {
  const std::string g =
      import_body(R"~(<path d="M0 0L5 5" fill="red"/>)~", R"~( width="1cm" height="2cm" version="1.0")~");
  EXPECT_TRUE(g.starts_with(R"~(<g id="a4"><svg width="10.000000" height="20.000000" viewBox="0 0 10 20">)~")) << g;
  EXPECT_TRUE(contains(g, R"~(<path d="M0 0L5 5" fill="red"/>)~")) << g;
}

TEST(SvgImport, ScriptsHandlersAnimationsAndForeignContentAreDropped) {
  const std::string g =
      import_body(R"~(<script>alert(1)</script><g onclick="evil()" ONLOAD="evil()"><rect width="1" height="1"/></g>)~"
                  R"~(<foreignObject><body xmlns="http://www.w3.org/1999/xhtml">evil</body></foreignObject>)~"
                  R"~(<animate attributeName="href" to="evil"/><set attributeName="onclick" to="evil"/>)~"
                  R"~(<h:script xmlns:h="http://www.w3.org/1999/xhtml">evil</h:script><metadata>evil</metadata>)~"
                  R"~(<a xlink:href="javascript:evil()"><circle r="1"/></a><iframe src="evil"/>)~",
                  R"~( onload="evil()")~");
  for (const char* part : {"evil", "script", "alert", "foreignObject", "onclick", "onload", "ONLOAD", "<a "}) {
    EXPECT_FALSE(contains(g, part)) << part << "\n" << g;
  }
  EXPECT_TRUE(contains(g, R"~(<g><rect width="1" height="1"/></g>)~")) << g;
  EXPECT_TRUE(contains(g, R"~(<g><circle r="1"/></g>)~")) << g;
}

TEST(SvgImport, ReferencesLeaveTheDocumentNowhere) {
  const std::string g = import_body(
      R"~(<image xlink:href="http://evil/x.png"/><image href="file:///etc/passwd"/><use xlink:href="evil.svg#x"/>)~"
      R"~(<image xlink:href="data:image/svg+xml;base64,PHN2Zz4="/>)~"
      R"~(<image xlink:href="data:image/png;base64,PHN2Zz4="/>)~"
      R"~(<rect fill="url(http://evil/#x)"/><rect style="fill:url( 'evil.svg#x' );stroke:red"/>)~"
      R"~(<rect filter="u\72l(evil)" mask="image-set('evil' 1x)"/><feImage xlink:href="//evil/x"/>)~");
  EXPECT_FALSE(contains(g, "evil")) << g;
  EXPECT_FALSE(contains(g, "file:")) << g;
  EXPECT_FALSE(contains(g, "data:")) << g;
  EXPECT_TRUE(contains(g, R"~(<rect style="stroke:red"/>)~")) << g;
}

TEST(SvgImport, EmbeddedBitmapsStayWhateverTheyCallThemselves) {
  EXPECT_TRUE(contains(import_body(R"~(<image xlink:href="data:;base64,iVBORw0K Ggo&#10;AAAA"/>)~"),
                       R"~(xlink:href="data:image/png;base64,iVBORw0KGgoAAAA")~"));
  EXPECT_TRUE(
      contains(import_body(R"~(<image href="data:image/jpg;base64,/9j/4AAQ"/>)~"), "data:image/jpeg;base64,/9j/4AAQ"));
}

TEST(SvgImport, IdsAndReferencesGetThePrefix) {
  const std::string g =
      import_body(R"~(<linearGradient id="x"/><linearGradient id="y" xlink:href="#x"/><rect fill="url(#y)"/>)~"
                  R"~(<rect style="stroke:url('#y');fill:url(#x) red"/><use href="#r"/><text>#x</text>)~",
                  R"~( id="root")~");
  for (const char* part : {R"~(<linearGradient id="a4-x"/>)~", R"~(<linearGradient id="a4-y" xlink:href="#a4-x"/>)~",
                           R"~(<rect fill="url(#a4-y)"/>)~", R"~(style="stroke:url(#a4-y);fill:url(#a4-x) red")~",
                           R"~(<use xlink:href="#a4-r"/>)~", R"~(<text>#x</text>)~", R"~(id="a4-root")~"}) {
    EXPECT_TRUE(contains(g, part)) << part << "\n" << g;
  }
}

TEST(SvgImport, EntitiesOfTheFileAreReplacedAndOthersNotRead) {
  const test::ScratchFolder folder;
  const std::string secret = folder.write("secret.txt", "SECRET");
  EXPECT_TRUE(contains(import(R"~(<!DOCTYPE svg [<!ENTITY ns "http://www.w3.org/2000/svg"><!ENTITY c "blue">]>)~"
                              R"~(<svg xmlns="&ns;"><rect fill="&c;"/></svg>)~"),
                       R"~(<rect fill="blue"/>)~"));
  const std::string head = R"~(<!DOCTYPE svg [<!ENTITY )~";
  const std::string tail = R"~(]><svg xmlns="http://www.w3.org/2000/svg"><text>&e;</text></svg>)~";
  for (const std::string& entity : {"e SYSTEM \"" + secret + "\">", "e SYSTEM \"file://" + secret + "\">",
                                    "% p SYSTEM \"" + secret + "\"> %p; <!ENTITY e \"x\">"}) {
    std::string g;
    try {
      g = import(head + entity + tail);
    } catch (const InputError&) {
    }
    EXPECT_FALSE(contains(g, "SECRET")) << entity;
  }
}

TEST(SvgImport, AnEntityBombIsRefusedQuickly) {
  std::string bomb = R"~(<!DOCTYPE svg [<!ENTITY l0 "lollollollollollollollollollol">)~";
  for (int i = 1; i < 12; ++i) {
    bomb += "<!ENTITY l" + std::to_string(i) + " \"";
    for (int k = 0; k < 10; ++k) bomb += "&l" + std::to_string(i - 1) + ";";
    bomb += "\">";
  }
  const double start_s = processor_time_s();
  EXPECT_THROW(import(bomb + R"~(]><svg xmlns="http://www.w3.org/2000/svg"><text>&l11;</text></svg>)~"), InputError);
  EXPECT_LT(processor_time_s() - start_s, 3);
}

TEST(SvgImport, DeepNestingIsRefused) {
  std::string deep = kHead + std::string(">");
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  EXPECT_THROW(import(deep), InputError);
}

TEST(SvgImport, WhatIsNoSvgIsAnError) {
  for (const char* file : {"", "hello", "<svg", "<html/>", R"~(<svg xmlns="http://other"/>)~", "\x1f\x8b broken"}) {
    EXPECT_THROW(import(file), InputError) << file;
  }
  EXPECT_TRUE(contains(import("<svg><rect/></svg>"), "<rect/>"));  // old files omit the name space
}

TEST(SvgImport, AnyPrefixAndEncodingOfTheFile) {
  EXPECT_TRUE(contains(import(R"~(<s:svg xmlns:s="http://www.w3.org/2000/svg"><s:text>&lt;&amp;</s:text></s:svg>)~"),
                       "<text>&lt;&amp;</text>"));
  EXPECT_TRUE(contains(import("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>"
                              "<svg xmlns=\"http://www.w3.org/2000/svg\"><text>\xe9</text></svg>"),
                       "<text>\xc3\xa9</text>"));
}

TEST(SvgImport, StyleSheetsBecomeStyleAttributesAndLoadNothing) {
  const std::string g = import_body(
      "<style><![CDATA[@import url(evil.css); @font-face{src:url(evil)} .st0,#r > path{fill:url(#x)}"
      "rect{fill:url(http://evil)} @media print{*{fill:evil}} circle{stroke:blue}]]></style>"
      "<g id=\"r\"><path d=\"M0 0\"/><path class=\"st0\" style=\"stroke:red\"/></g><rect/><circle/>");
  for (const char* part : {"evil", "@", "<style", "class=", "<rect style"}) {
    EXPECT_FALSE(contains(g, part)) << part << "\n" << g;
  }
  EXPECT_TRUE(contains(g, R"~(<path d="M0 0" style="fill:url(#a4-x)"/>)~")) << g;
  EXPECT_TRUE(contains(g, R"~(<path style="fill:url(#a4-x);stroke:red"/>)~")) << g;
  EXPECT_TRUE(contains(g, R"~(<circle style="stroke:blue"/>)~")) << g;
}

/// A nested <svg> may be larger than its page and draw beyond it, but the outermost one never does.
TEST(SvgImport, NothingIsDrawnBeyondThePage) {
  const std::string g = import_body("<style>svg{width:900px;height:900px;overflow:visible;fill:red}</style>",
                                    R"~( x="-9" overflow="visible" style="overflow:visible;y:-9px")~");
  EXPECT_TRUE(contains(g, R"~(<svg width="10.000000" height="20.000000" viewBox="0 0 10 20" style="fill:red"/>)~"))
      << g;
}

TEST(SvgImport, ASheetFromADataAddressIsNotLost) {
  for (const char* sheet : {"@import 'data:text/css,rect{fill:red}';", "g{} @IMPORT url( DATA:text/css,x );"}) {
    EXPECT_THROW(import_body(std::string("<style>") + sheet + "</style>"), InputError) << sheet;
  }
  EXPECT_THROW(import("<?xml-stylesheet href='data:text/css,rect{fill:red}'?><svg/>"), InputError);
  EXPECT_NO_THROW(import("<?xml-stylesheet href='evil.css'?><svg/>"));
}

}  // namespace test_svg_import
}  // namespace tessera
