// The outlines to cut equal what a browser draws of the SVG.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "artwork/outlines/flat_path.h"
#include "artwork/outlines/svg_outlines.h"
#include "core/base/error.h"
#include "core/base/processor_time.h"
#include "support/input_error.h"

namespace tessera {
namespace test_svg_outlines {

const std::string kPage = "width='100mm' height='100mm' viewBox='0 0 100 100'";

SvgOutlines read(const std::string& text, double px_per_inch = kCssPxPerInch) {
  return svg_outlines({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "a.svg", px_per_inch);
}

std::string svg(const std::string& content, const std::string& page = kPage, const std::string& before = "") {
  return before + "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' " + page + ">" +
         content + "</svg>";
}

std::vector<std::string> names_of(const SvgOutlines& found) {
  std::vector<std::string> names;
  for (const SvgOutline& outline : found.outlines) names.push_back(outline.name);
  return names;
}

/// The id, corner and size of each outline in 0.01 mm: "r 0 0 50 50".
std::vector<std::string> boxes_of(const SvgOutlines& found) {
  const auto text = [](double mm) {
    const double hundredths = std::round(100 * mm) / 100;
    std::string number = std::to_string(hundredths == 0 ? 0. : hundredths);
    number.erase(number.find_last_not_of('0') + 1);
    return number.ends_with('.') ? number.substr(0, number.size() - 1) : number;
  };
  std::vector<std::string> boxes;
  for (const SvgOutline& outline : found.outlines) {
    const cv::Rect2d box = box_of(outline.steps);
    boxes.push_back(outline.name + " " + text(box.x) + " " + text(box.y) + " " + text(box.width) + " " +
                    text(box.height));
  }
  return boxes;
}

using Texts = std::vector<std::string>;

double area_of(const SvgOutline& outline) {
  double area = 0;
  for (const FlatSubpath& subpath : flat_path(outline.steps, 0.001)) {
    for (std::size_t i = 0; i < subpath.points.size(); ++i) {
      const cv::Point2d p = subpath.points[i], q = subpath.points[(i + 1) % subpath.points.size()];
      area += (p.x * q.y - p.y * q.x) / 2;
    }
  }
  return std::abs(area);
}

TEST(SvgOutlines, AllShapesAreReadInMm) {
  const SvgOutlines found =
      read(svg("<rect id='r' width='20' height='10'/><circle id='c' cx='50' cy='50' r='10'/>"
               "<ellipse id='e' cx='9' cy='9' rx='4' ry='8'/><polygon id='p' points='0,30 10,30 0,40'/>"
               "<path id='a' d='M80 80a10 10 0 0 1 10 10h-10z'/><rect x='60' width='20' height='10' rx='5'/>"));
  const double pi = std::acos(-1.0);
  const std::vector<std::pair<std::string, double>> want = {
      {"r", 200}, {"c", 100 * pi}, {"e", 32 * pi}, {"p", 50}, {"a", 25 * pi}, {"rect1", 200 - (100 - 25 * pi)}};
  ASSERT_EQ(found.outlines.size(), want.size());
  for (std::size_t i = 0; i < want.size(); ++i) {
    EXPECT_EQ(found.outlines[i].name, want[i].first);
    EXPECT_TRUE(found.outlines[i].filled);
    // Four Bézier curves form a circle with an error of 0.03 % of its radius.
    EXPECT_NEAR(area_of(found.outlines[i]), want[i].second, 3e-4 * want[i].second) << want[i].first;
  }
  const auto curves = std::count_if(found.outlines[1].steps.begin(), found.outlines[1].steps.end(),
                                    [](const PathStep& step) { return step.command == 'C'; });
  EXPECT_EQ(curves, 4) << "curves stay curves";
  EXPECT_TRUE(found.says_unit);
  EXPECT_NEAR(found.page_mm.width, 100, 1e-9);
}

TEST(SvgOutlines, CoordinatesAreExactToAThousandthOfAMillimetre) {
  for (const double at : {0.0, 333.3337, 98'765.4321, -4321.1234}) {
    const std::string x = std::to_string(at);
    const SvgOutlines found = read(svg("<path d='M" + x + " 7.7777h1v1z'/>"));
    ASSERT_EQ(found.outlines.size(), 1u) << "what lies beside the page is cut, too";
    EXPECT_NEAR(found.outlines[0].steps[0].points[0].x, at, 0.001);
    EXPECT_NEAR(found.outlines[0].steps[0].points[0].y, 7.7777, 0.001);
  }
}

/// A part exactly as wide as its sheet must fit.
TEST(SvgOutlines, DecimalsAreExact) {
  for (const double size : {33.4, 0.1, 2.3333, 480.123}) {
    const std::string side = std::to_string(size);
    const SvgOutlines found = read(svg("<rect width='" + side + "' height='" + side +
                                       "'/><path fill='none' stroke='red' d='M0 0h" + side + "'/>"));
    for (const SvgOutline& outline : found.outlines) EXPECT_NEAR(box_of(outline.steps).width, std::stod(side), 1e-12);
  }
}

TEST(SvgOutlines, WhatIsNotDrawnIsNotCut) {
  const SvgOutlines found =
      read(svg("<style>.off{display:none} .unseen{visibility:hidden}</style>"
               "<g class='off'><rect width='9' height='9'/></g><rect class='unseen' width='9' height='9'/>"
               "<rect visibility='hidden' width='9' height='9'/><g opacity='0'><rect width='9' height='9'/></g>"
               "<rect style='opacity:0' width='9' height='9'/><rect fill-opacity='0' width='9' height='9'/>"
               "<rect fill='none' width='9' height='9'/><rect width='0' height='9'/>"
               "<rect fill='none' stroke='red' stroke-width='0' width='9' height='9'/>"
               "<defs><rect width='9' height='9'/></defs><symbol><rect width='9' height='9'/></symbol>"
               "<clipPath><rect width='9' height='9'/></clipPath><rect id='half' opacity='0.5' width='9' height='9'/>"
               "<switch><rect requiredExtensions='x' width='9' height='9'/><rect id='first' width='9' height='9'/>"
               "<rect width='9' height='9'/></switch>"));
  EXPECT_EQ(names_of(found), (Texts{"half", "first"}));
  EXPECT_EQ(found.undrawn_elements.size(), 9u);
}

TEST(SvgOutlines, OfASwitchTheFirstThatSuitsAllIsCut) {
  const std::string deep =
      "<foreignObject requiredExtensions='http://ns.adobe.com/AdobeIllustrator/10.0/'><g/></foreignObject>"
      "<rect systemLanguage='de' width='9' height='9'/><g><g><rect id='r' width='9' height='9'/></g></g>"
      "<rect width='9' height='9'/>";
  EXPECT_EQ(names_of(read(svg("<switch>" + deep + "</switch>"))), Texts{"r"});
  EXPECT_EQ(names_of(read(svg(
                "<switch><title>x</title><i:pgf xmlns:i='http://x/'/><rect id='r' width='9' height='9'/></switch>"))),
            Texts{"r"});
  EXPECT_EQ(names_of(read(svg("<switch><rect id='r' systemLanguage='en' width='9' height='9'/></switch>"))),
            Texts{"r"});
  EXPECT_EQ(names_of(read(svg("<g><switch transform='scale(2)'><switch>" + deep + "</switch></switch></g>"))),
            Texts{"r"});
}

TEST(SvgOutlines, FiltersMasksMarkersAndDashesAreNotLookedAt) {
  const SvgOutlines found =
      read(svg("<defs><filter id='f'><feGaussianBlur stdDeviation='3'/></filter><mask id='m'/>"
               "<marker id='k' markerWidth='9' markerHeight='9'><circle r='4'/></marker></defs>"
               "<rect id='a' filter='url(#f)' width='9' height='9'/><rect id='b' mask='url(#m)' width='9' height='9'/>"
               "<path id='c' marker-start='url(#k)' d='M50 50h9v9z'/>"
               "<rect id='d' style='mix-blend-mode:multiply' x='200' width='9' height='9'/>"
               "<rect id='e' fill='none' stroke='red' stroke-dasharray='1 1' width='9' height='9'/>"));
  EXPECT_EQ(boxes_of(found), (Texts{"a 0 0 9 9", "b 0 0 9 9", "c 50 50 9 9", "d 200 0 9 9", "e 0 0 9 9"}));
}

const std::string kMask = "<mask id='m'><rect width='3' height='3' fill='white'/></mask>";

TEST(SvgOutlines, MasksAreTakenOffAndNamed) {
  const std::string rect = "<rect width='9' height='9' ";
  const Texts masked = {
      rect + "id='a' mask='url(#m)'/>",
      rect + "id='a' style='mask:url(#m)'/>",
      rect + "id='a' style='mask:url(&quot;#m&quot;)!important;fill:red'/>",
      "<style>#a{mask:url(#m)!important}</style>" + rect + "id='a' mask='none' style='mask:none'/>",
      "<style>g .k{mask:url(#m)}</style><g><rect id='a' class='k' width='9' height='9'/></g>",
      "<g mask='url(#m)'><g>" + rect + "id='a'/></g></g>",
      "<defs><g id='shown'>" + rect + "mask='url(#m)'/></g></defs><use id='a' xlink:href='#shown'/>",
      "<defs><g id='inner'>" + rect +
          "mask='url(#m)'/></g><g id='outer'><use href='#inner'/></g></defs>"
          "<use id='a' href='#outer'/>",
      "<style>#a{mask:bogus!important}</style>" + rect + "id='a' mask='url(#m)'/>",
      "<g id='cycle' mask='url(#m)'><use href='#cycle'/></g>" + rect + "id='a' mask='url(#m)'/>",
  };
  for (const std::string& content : masked) {
    const SvgOutlines found = read(svg(kMask + content));
    EXPECT_EQ(boxes_of(found), Texts{"a 0 0 9 9"}) << content;
    EXPECT_EQ(found.masked_elements, Texts{"a"}) << content;
  }
}

TEST(SvgOutlines, WhatHasNoMaskIsNotSaidToHaveOne) {
  const std::string rect = "<rect id='a' width='9' height='9' ";
  const Texts plain = {
      rect + "mask='none'/>",
      rect + "mask='url(#gone)'/>",
      rect + "mask='url(#n)'/><mask xmlns='urn:x' id='n'/>",
      "<defs><g id='s'><rect width='9' height='9'/></g><g id='s' mask='url(#m)'/></defs><use id='a' xlink:href='#s'/>",
      rect + "mask='url(#b)'/><defs><g id='b'/></defs>",
      "<style>#a{mask:none}</style>" + rect + "mask='url(#m)'/>",
      "<style>rect{mask:none!important}</style>" + rect + "style='mask:url(#m)'/>",
      "<defs>" + rect + "mask='url(#m)'/></defs><rect id='c' width='9' height='9'/>",
      rect + "/><g mask='url(#m)' display='none'><circle id='hidden' r='4'/></g>",
  };
  for (const std::string& content : plain) {
    const SvgOutlines found = read(svg(kMask + content));
    EXPECT_EQ(found.masked_elements, Texts{}) << content;
    EXPECT_EQ(found.outlines.size(), 1u) << content;
  }
}

TEST(SvgOutlines, MasksThatAreNotFoundAreTakenOffAllTheSame) {
  const std::string rect = "<rect id='a' width='9' height='9' ";
  const Texts hidden = {
      rect + "style='m\\61 sk:url(#m)'/>",
      "<style>@import url(data:text/css,x);</style>" + rect + "mask='url(#m)'/>",
  };
  for (const std::string& content : hidden)
    EXPECT_EQ(boxes_of(read(svg(kMask + content))), Texts{"a 0 0 9 9"}) << content;
}

TEST(SvgOutlines, MasksOfManyUsesTakeTimeByTheirNumber) {
  std::string many = "<defs>" + kMask;
  for (int i = 0; i < 20'000; ++i) many += "<g id='x' mask='url(#m)'/><use href='#x'/>";
  const double started_s = processor_time_s();
  EXPECT_EQ(names_of(read(svg(many + "</defs><rect id='a' width='9' height='9'/>"))), Texts{"a"});
  EXPECT_LT(processor_time_s() - started_s, 20);
}

TEST(SvgOutlines, PatternsFillToTheEdgeWhateverTheyShow) {
  const std::string pattern = "width='1' height='1' patternContentUnits='objectBoundingBox'>";
  const SvgOutlines found = read(svg(
      "<pattern id='p' " + pattern + "<image width='1' height='1' xlink:href='gone.png'/></pattern>" +
      "<pattern id='q' xlink:href='#p'/><pattern id='u' " + pattern + "<use xlink:href='#i'/></pattern>" +
      "<defs><image id='i' width='1' height='1' xlink:href='data:image/png;base64,AAAA'/></defs>" +
      "<rect id='a' fill='url(#p)' width='9' height='9'/><rect id='b' fill='url(#q)' width='9' height='9'/>" +
      "<rect id='c' fill='url(#u)' width='9' height='9'/><rect id='d' fill='url(#none) none' width='9' height='9'/>"));
  EXPECT_EQ(boxes_of(found), (Texts{"a 0 0 9 9", "b 0 0 9 9", "c 0 0 9 9"}));
}

TEST(SvgOutlines, ContoursThatCrossAreOne) {
  const auto area = [](const std::string& path) {
    const SvgOutlines found = read(svg("<path id='a' " + path + "/>"));
    return found.outlines.size() == 1 ? std::round(100 * area_of(found.outlines[0])) / 100 : -1.;
  };
  const auto contours = [](const std::string& path) {
    const SvgOutlines found = read(svg("<path id='a' " + path + "/>"));
    return found.outlines.empty() ? 0u : flat_path(found.outlines[0].steps, 0.01).size();
  };
  const std::string tee = "d='M10 10h40v10h-40zM25 10h10v40h-10z'";
  EXPECT_EQ(contours(tee), 1u);
  EXPECT_EQ(area(tee), 700);
  EXPECT_EQ(contours("d='M0 0h30v30h-30zM20 20h30v30h-30z' fill-rule='evenodd'"), 2u)
      << "what is filled twice is a hole";
  EXPECT_EQ(contours("d='M0 0h30v30h-30zM30 0h30v30h-30z'"), 1u) << "side by side";
  // These outlines stay as they are, with their curves.
  const SvgOutlines ring = read(svg("<path id='a' d='M10 10C10 40 40 40 40 10zM20 15h10v5h-10z'/>"));
  EXPECT_TRUE(std::any_of(ring.outlines[0].steps.begin(), ring.outlines[0].steps.end(),
                          [](const PathStep& step) { return step.command == 'C'; }));
  EXPECT_EQ(contours("d='M0 0h30v30h-30zM50 50h30v30h-30z'"), 2u);
}

TEST(SvgOutlines, FillsGoBeforeStrokes) {
  const SvgOutlines found = read(svg(
      "<rect id='both' stroke='red' stroke-width='4' width='9' height='9'/>"
      "<rect id='line' fill='none' stroke='red' stroke-width='4' x='20' width='9' height='9'/>"
      "<path id='after' style='paint-order:stroke' stroke='red' d='M50 50h9v9z'/>"
      "<g id='two'><use xlink:href='#both' y='40'/></g><g fill='none' stroke='blue'><path id='open' d='M0 0h5'/></g>"));
  EXPECT_EQ(boxes_of(found),
            (Texts{"both 0 0 9 9", "line 20 0 9 9", "after 50 50 9 9", "use1 0 40 9 9", "open 0 0 5 0"}));
  const std::vector<bool> filled = {true, false, true, true, false};
  for (std::size_t i = 0; i < filled.size(); ++i) EXPECT_EQ(found.outlines[i].filled, filled[i]) << i;
}

TEST(SvgOutlines, ViewportsTransformsAndUnitsAreThoseOfABrowser) {
  const std::string rect = "<rect id='r' width='10' height='10'/>";
  const auto box = [](const std::string& content, const std::string& page = kPage) {
    const Texts boxes = boxes_of(read(svg(content, page)));
    return boxes.empty() ? "none" : boxes[0];
  };
  EXPECT_EQ(box("<svg width='50' height='50' viewBox='0 0 10 10'>" + rect + "</svg>"), "r 0 0 50 50");
  EXPECT_EQ(box("<svg x='10' y='20' width='50' height='20' viewBox='0 0 10 10'>" + rect + "</svg>"), "r 25 20 20 20");
  EXPECT_EQ(box(rect, "width='200mm' height='100mm' viewBox='0 0 50 50' preserveAspectRatio='xMinYMin slice'"),
            "r 0 0 40 40");
  EXPECT_EQ(box(rect, "width='200mm' height='100mm' viewBox='0 0 50 50' preserveAspectRatio='none'"), "r 0 0 40 20");
  EXPECT_EQ(box("<g style='transform:scale(0.5)'>" + rect + "</g>"), "r 0 0 5 5");
  EXPECT_EQ(box("<g transform='translate(10,20) rotate(90)'>" + rect + "</g>"), "r 0 20 10 10");
  EXPECT_EQ(box(rect, "width='200MM' height='200MM' viewBox='0 0 100 100'"), "r 0 0 20 20");
  EXPECT_EQ(box("<rect id='r' width='1in' height='1cm'/>", ""), "r 0 0 25.4 10");
  EXPECT_EQ(box("<rect id='r' width='96' height='48px'/>", ""), "r 0 0 25.4 12.7");
  EXPECT_EQ(box("<rect id='r' width='50%' height='10%'/>"), "r 0 0 50 10");
  EXPECT_EQ(box(rect, "width='100%' height='100%' viewBox='0 0 96 96'"), "r 0 0 2.65 2.65");
  EXPECT_EQ(box("<symbol id='s' viewBox='0 0 1 1'><rect width='1' height='1'/></symbol>"
                "<use id='u' xlink:href='#s' x='5' width='30' height='30'/>"),
            "u 5 0 30 30");
  EXPECT_EQ(box("<style>rect{transform:scale(2)}</style>" + rect), "r 0 0 20 20");
}

TEST(SvgOutlines, UnitsAndPagesAreTold) {
  EXPECT_FALSE(read(svg("<rect width='9' height='9'/>", "")).says_unit);
  EXPECT_TRUE(read(svg("<rect width='9' height='9'/>", "")).page_mm.empty());
  EXPECT_FALSE(read(svg("", "width='100%' viewBox='0 0 96 48'")).says_unit);
  EXPECT_NEAR(read(svg("", "width='100%' viewBox='0 0 96 48'")).page_mm.height, 12.7, 1e-9);
  EXPECT_FALSE(read(svg("", "width='96' height='96'")).says_unit);
  EXPECT_TRUE(read(svg("", "width='96px' height='96px'")).says_unit);
  EXPECT_TRUE(read(svg("", "width='9in' viewBox='0 0 9 9'")).says_unit);
}

TEST(SvgOutlines, ProgramsWithPxOfTheirOwnAreTold) {
  const auto inkscape = [](const std::string& version, const std::string& page) {
    return read(svg("<rect width='90' height='45'/>",
                    "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "
                    "inkscape:version='" +
                        version + "' " + page));
  };
  EXPECT_EQ(inkscape("0.48.4 r9939", "width='90px' height='90px'").program, "Inkscape 0.48.4");
  EXPECT_EQ(inkscape("0.48.4 r9939", "width='90px' height='90px'").program_px_per_inch, 90);
  EXPECT_EQ(inkscape("0.91 r13725", "width='90' height='90' viewBox='0 0 90 90'").program_px_per_inch, 90);
  EXPECT_EQ(inkscape("0.91 r13725", "width='210mm' height='297mm'").program_px_per_inch, 90) << "units are px";
  EXPECT_EQ(inkscape("0.91 r13725", "width='210mm' height='297mm' viewBox='0 0 9 9'").program_px_per_inch, 0);
  EXPECT_EQ(inkscape("0.92.3", "width='90px' height='90px'").program_px_per_inch, 0);
  EXPECT_EQ(inkscape("1.2 (dc2aeda)", "width='90px' height='90px'").program, "Inkscape 1.2");
  const std::string comment =
      "<?xml version='1.0'?><!-- Generator: Adobe Illustrator 19.0.0, SVG Export Plug-In . SVG Version: 6.00 -->";
  const SvgOutlines illustrator =
      read(svg("<rect id='r' width='72' height='48'/>", "width='72px' height='72px' viewBox='0 0 72 72'", comment));
  EXPECT_EQ(illustrator.program, "Adobe Illustrator 19.0.0");
  EXPECT_EQ(illustrator.program_px_per_inch, 72);
  EXPECT_EQ(boxes_of(illustrator), Texts{"r 0 0 19.05 12.7"});
  EXPECT_EQ(read(svg("<rect id='r' width='72' height='36'/>", "viewBox='0 0 72 72'")).program_px_per_inch, 0);
}

TEST(SvgOutlines, OneSideAndTheViewBoxSayTheOtherSide) {
  const std::string rect = "<rect id='r' width='50' height='20'/>", box = " viewBox='0 0 100 50'";
  for (const char* page : {"width='100mm'", "width='100mm' height='auto'", "width='100mm' height='100%'",
                           "height='50mm'", "width='10cm'", "height='141.732pt'"}) {
    const SvgOutlines found = read(svg(rect, page + box));
    EXPECT_EQ(boxes_of(found), Texts{"r 0 0 50 20"}) << page;
    EXPECT_TRUE(found.says_unit) << page;
  }
}

TEST(SvgOutlines, PxMayHaveAnotherSize) {
  EXPECT_EQ(boxes_of(read(svg("<rect id='r' width='90' height='45'/>", "width='90' height='90'"), 90)),
            Texts{"r 0 0 25.4 12.7"});
  EXPECT_EQ(boxes_of(read(svg("<rect id='r' width='1in' height='1'/>", "width='2in' height='2in'"), 72)),
            Texts{"r 0 0 25.4 0.35"});
  EXPECT_EQ(boxes_of(read(svg("<rect id='r' width='9' height='9'/>"), 72)), Texts{"r 0 0 9 9"});
}

TEST(SvgOutlines, ClipsCutOutlines) {
  const std::string clips =
      "<clipPath id='q'><path d='M0 0h10v10h-10z'/></clipPath><clipPath id='all'><rect width='90' height='90'/>"
      "</clipPath><clipPath id='own' clipPathUnits='objectBoundingBox'><circle cx='.5' cy='.5' r='.5'/></clipPath>"
      "<clipPath id='ring'><path clip-rule='evenodd' d='M0 0h20v20h-20zM5 5h10v10h-10z'/></clipPath>";
  const auto found = [&](const std::string& content) { return read(svg("<defs>" + clips + "</defs>" + content)); };
  const SvgOutlines quarter = found("<circle id='r' r='10' clip-path='url(#q)'/>");
  EXPECT_EQ(boxes_of(quarter), Texts{"r 0 0 10 10"});
  EXPECT_NEAR(area_of(quarter.outlines[0]), 25 * std::acos(-1.0), 0.11);
  EXPECT_EQ(boxes_of(found("<g clip-path='url(#q)'><rect id='r' x='5' y='-5' width='50' height='50'/></g>")),
            Texts{"r 5 0 5 10"});
  const SvgOutlines whole = found("<circle id='r' cx='20' cy='20' r='10' clip-path='url(#all)'/>");
  EXPECT_EQ(whole.outlines[0].steps[1].command, 'C') << "what no clip cuts keeps its curves";
  EXPECT_NEAR(area_of(found("<rect clip-path='url(#own)' x='60' width='20' height='20'/>").outlines[0]),
              100 * std::acos(-1.0), 0.45);
  const SvgOutlines ring = found("<rect id='r' width='20' height='20' clip-path='url(#ring)'/>");
  EXPECT_EQ(flat_path(ring.outlines[0].steps, 0.01).size(), 2u) << "an outline and a hole, and no seams between them";
  EXPECT_TRUE(ring.outlines[0].even_odd);
  EXPECT_EQ(boxes_of(found("<path id='r' fill='none' stroke='red' clip-path='url(#q)' d='M-5 5H50'/>")),
            Texts{"r 0 5 10 0"});
  EXPECT_TRUE(found("<rect x='40' clip-path='url(#q)' width='9' height='9'/>").outlines.empty());
  EXPECT_EQ(boxes_of(found("<svg width='20' height='20'><rect id='r' x='10' width='50' height='5'/></svg>")),
            Texts{"r 10 0 10 5"})
      << "a nested viewport is a window";
}

TEST(SvgOutlines, NamesAreIdsOrKindAndNumber) {
  const SvgOutlines found =
      read(svg("<style>#a{fill:none;stroke:red}</style><rect width='9' height='9'/><g><path id='a' d='M0 0h9v9z'/>"
               "<circle id='leaf-1' r='3'/></g><path id='a' d='M50 0h9v9z'/><use xlink:href='#a' y='50'/>"));
  EXPECT_EQ(boxes_of(found), (Texts{"rect1 0 0 9 9", "a 0 0 9 9", "leaf-1 -3 -3 6 6", "a 50 0 9 9", "use3 0 50 9 9"}));
}

TEST(SvgOutlines, IdsThatOtherElementsHaveDoNoHarm) {
  const std::string small = "<rect id='a' width='10' height='10'/>",
                    large = "<rect id='a' x='25' width='50' height='30'/>";
  for (const std::string before : {"<linearGradient id='a'/>", "<clipPath id='a'/>",
                                   "<defs><rect id='a' width='9' height='9'/></defs>", "<style id='a'/>"})
    EXPECT_EQ(boxes_of(read(svg(before + large))), Texts{"a 25 0 50 30"}) << before;
  EXPECT_EQ(boxes_of(read(svg("<g id='a'><rect width='10' height='10'/></g>" + large))),
            (Texts{"rect1 0 0 10 10", "a 25 0 50 30"}));
  EXPECT_EQ(boxes_of(read(svg("<style>#a{display:none}</style>" + small + large))), Texts{});
  const SvgOutlines lines = read(svg("<style>#a{fill:none;stroke:red}</style>" + small + large));
  ASSERT_EQ(lines.outlines.size(), 2u);
  EXPECT_FALSE(lines.outlines[0].filled || lines.outlines[1].filled) << "the style of its id stays";
  EXPECT_EQ(
      boxes_of(read(svg("<rect id='a#b' width='10' height='10'/><rect id='a var(b)' x='50' width='9' height='9'/>"))),
      (Texts{"a#b 0 0 10 10", "a var(b) 50 0 9 9"}));
}

TEST(SvgOutlines, TextsAndImagesAreCountedWhereTheyAreDrawn) {
  const SvgOutlines found =
      read(svg("<text y='20'>x</text><g display='none'><text y='20'>x</text></g>"
               "<g id='t'><text y='50'>x</text></g><use xlink:href='#t'/><rect id='r' width='9' height='9'/>"));
  EXPECT_EQ(found.unread_elements, 2);
  EXPECT_EQ(names_of(found), Texts{"r"});
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(SvgOutlines, ManyHiddenPicturesTakeTimeByTheirNumber) {
  const double started_s = processor_time_s();
  const std::string many = repeated("<image display='none' width='9' height='9'/>", 9'999);
  EXPECT_EQ(read(svg(many + "<rect id='r' width='9' height='9'/>")).unread_elements, 0);
  EXPECT_LT(processor_time_s() - started_s, 6) << "0.6 s, not 12";
}

TEST(SvgOutlines, PicturesAreCountedUnlessTheyAreHidden) {
  const std::string image = "<image width='9' height='9' xlink:href='data:image/png;base64,AAAA'",
                    object = "<foreignObject width='9' height='9'";
  const std::string rect = "<rect id='r' width='9' height='9'/>";
  for (const std::string& one : {image, object}) {
    const auto count = [&](const std::string& before, const std::string& attributes, const std::string& after = "") {
      const SvgOutlines found = read(svg(before + one + attributes + "/>" + after + rect));
      EXPECT_EQ(names_of(found), Texts{"r"});
      return found.unread_elements;
    };
    EXPECT_EQ(count("", ""), 1);
    EXPECT_EQ(count("<g opacity='0.5' visibility='hidden'>", " visibility='visible'", "</g>"), 1);
    EXPECT_EQ(count("<style>.a{display:none!important}</style>", " class='a' style='display:inline'"), 0);
    EXPECT_EQ(count("", " display='none' style='display:bogus'"), 0) << "librsvg ignores what it does not know";
    EXPECT_EQ(count("<style>@import url(data:text/css,)</style>", " style='display:none'"), 0) << "sheets do not count";
    EXPECT_EQ(count("<style>" + repeated("g ", 500) + "image{fill:red}</style>", ""), 1) << "a sheet beyond the limits";
    for (const std::string hides : {" display='none'", " visibility='hidden'", " opacity='0'", " class='a'",
                                    " style='opacity:0%'", " visibility='collapse'"}) {
      const std::string style = "<style>.a{display:none!important}</style>";
      EXPECT_EQ(count(style, hides), 0) << hides;
      EXPECT_EQ(count(style + "<g" + hides + ">", "", "</g>"), 0) << hides;
    }
    EXPECT_EQ(count("<defs>", "", "</defs>"), 0);
  }
  EXPECT_EQ(read(svg("<image xlink:href='gone.png'/><foreignObject/>" + rect)).unread_elements, 1) << "auto size";
  EXPECT_EQ(read(svg("<image width='0' height='9' xlink:href='gone.png'/>" + rect)).unread_elements, 0);
  EXPECT_EQ(read(svg("<image style='width:0' width='9' xlink:href='gone.png'/>" + rect)).unread_elements, 0);
  EXPECT_EQ(read(svg("<foreignObject style='width:9px;height:9px'/>" + rect)).unread_elements, 1) << "a size by CSS";
  const SvgOutlines used = read(
      svg("<defs><g id='g'>" + rect + "<image xlink:href='gone.png'/></g></defs>" + "<use id='u' xlink:href='#g'/>"));
  EXPECT_EQ(used.unread_elements, 1) << "what a <use> shows";
  EXPECT_EQ(names_of(used), Texts{"u"});
  EXPECT_EQ(read(svg(image + "/>")).unread_elements, 1) << "beside no outline";
}

TEST(SvgOutlines, EntitiesAndEncodingsAreRead) {
  const SvgOutlines entity = read(svg("<rect id='r' style='&st;' width='10' height='10'/>", kPage,
                                      "<!DOCTYPE svg [<!ENTITY st 'fill:red'><!ENTITY n 'e'>]>"));
  EXPECT_EQ(boxes_of(entity), Texts{"r 0 0 10 10"});
  const std::string ascii = svg("<rect id='r' width='10' height='10'/>");
  std::string wide = "\xff\xfe";
  for (const char c : ascii) wide += {c, '\0'};
  EXPECT_EQ(boxes_of(read(wide)), Texts{"r 0 0 10 10"});
}

TEST(SvgOutlines, WhatIsTooFarAwayIsLeftOut) {
  for (const std::string far : {"<rect id='f' x='2e7' width='9' height='9'/>", "<path id='f' d='M0 0L1e9 0L1e9 1e9z'/>",
                                "<circle id='f' r='1e30'/>", "<path id='f' d='M0 0H1100000V5z'/>"}) {
    const SvgOutlines found = read(svg(far + "<rect id='r' width='10' height='10'/>"));
    EXPECT_EQ(boxes_of(found), Texts{"r 0 0 10 10"}) << far;
    EXPECT_EQ(found.far_elements, Texts{"f"}) << far;
  }
  EXPECT_EQ(boxes_of(read(svg("<rect id='r' x='999000' y='-999000' width='9' height='9'/>"))),
            Texts{"r 999000 -999000 9 9"});
}

TEST(SvgOutlines, RefusesWhatIsNoSvg) {
  EXPECT_EQ(test::message_of([] { read("no"); }), "a.svg: not an SVG file");
  EXPECT_TRUE(test::message_of([] { read(svg("<rect")); }).starts_with("a.svg: not a readable SVG file: line 1: "));
  EXPECT_EQ(test::message_of([] { read(svg("", "viewBox='0 0 0 9'")); }), "a.svg: the page has no area");
  std::string entities = "<!DOCTYPE svg [<!ENTITY e0 '<rect width=\"9\" height=\"9\"/>'>";
  for (int i = 1; i <= 12; ++i) {
    entities += "<!ENTITY e" + std::to_string(i) + " '";
    for (int k = 0; k < 240; ++k) entities += "<g>";
    entities += "&e" + std::to_string(i - 1) + ";";
    for (int k = 0; k < 240; ++k) entities += "</g>";
    entities += "'>";
  }
  EXPECT_EQ(test::message_of([&] { read(svg("&e12;", kPage, entities + "]>")); }),
            "a.svg: found more than 256 levels of elements in each other; allowed: 256 or fewer");
  std::string many;
  for (std::size_t i = 0; i <= kMostOutlineElements; ++i) many += "<g/><path/>";
  EXPECT_EQ(test::message_of([&] { read(svg(many)); }),
            "a.svg: found more than 10000 elements that are drawn; allowed: 10000 or fewer");
}

}  // namespace test_svg_outlines
}  // namespace tessera
