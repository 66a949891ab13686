// Pieces of an SVG: which outlines form a piece, and the messages about the others. For what is drawn at all see test_svg_outlines.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "artwork/outlines/flat_path.h"
#include "products/nesting/drawings/svg_drawings.h"
#include "products/nesting/nest_input.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_svg_drawings {

using Texts = std::vector<std::string>;

std::string document(const std::string& content,
                     const std::string& page = "width='100mm' height='100mm' viewBox='0 0 100 100'") {
  return "<svg xmlns='http://www.w3.org/2000/svg' " + page + ">" + content + "</svg>";
}

SvgDrawings svg(const std::string& content, const Texts& left_out = {}) {
  const std::string text = document(content);
  return svg_drawings(svg_outlines({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "a.svg"), "a.svg",
                      left_out);
}

std::string refusal(const std::string& content) {
  return test::message_of([&] { svg(content); });
}

Texts names_of(const SvgDrawings& found) {
  Texts names;
  for (const NestDrawing& drawing : found.drawings) names.push_back(drawing.name);
  return names;
}

double area_of(const NestRing& ring) { return std::abs(signed_area(ring)); }

const std::string kLines = "<g fill='none' stroke='#000'>";

TEST(SvgDrawings, HolesTravelAlongAndPartsAreParted) {
  const SvgDrawings found = svg("<path id='a' fill-rule='evenodd' d='M0 0h30v30h-30z m5 5h5v5h-5z M40 0h9v9h-9z'/>");
  ASSERT_EQ(names_of(found), (Texts{"a-1", "a-2"}));
  EXPECT_EQ(found.drawings[0].holes.size(), 1u);
  EXPECT_TRUE(found.drawings[1].holes.empty());
}

TEST(SvgDrawings, AContourInsideAFillIsNoHole) {
  const std::string outer = "M0 0h30v30h-30z", same = "M5 5h20v20h-20z", back = "M5 5v20h20v-20z",
                    inmost = "M10 10h9v9h-9z";
  const auto holes = [](const std::string& path) {
    const SvgDrawings found = svg(path);
    EXPECT_EQ(found.drawings.size(), 1u) << path;
    return found.drawings.at(0).holes.size();
  };
  EXPECT_EQ(holes("<path d='" + outer + same + "'/>"), 0u) << "by the nonzero rule it is filled on both sides";
  EXPECT_EQ(svg("<path d='" + outer + same + "'/>").notes, Texts{"left out 1 contour with fill on both sides"});
  EXPECT_EQ(holes("<path d='" + outer + back + "'/>"), 1u);
  EXPECT_EQ(holes("<path d='" + outer + back + inmost + "'/>"), 2u) << "an island in the hole";
  EXPECT_EQ(holes("<path d='" + outer + same + inmost + "'/>"), 0u);
  EXPECT_EQ(holes("<path fill-rule='evenodd' d='" + outer + same + "'/>"), 1u);
  EXPECT_EQ(holes("<path fill='none' stroke='#000' d='" + outer + same + "'/>"), 1u) << "lines are cut";
  EXPECT_EQ(holes("<path d='" + outer + "'/><path d='" + same + "'/>"), 1u) << "of two elements each is cut";
  EXPECT_EQ(svg("<path d='" + outer + "M50 0h9v9h-9z'/>").drawings.size(), 2u);
}

TEST(SvgDrawings, HolesMayBeElementsOfTheirOwn) {
  const SvgDrawings found =
      svg("<circle id='hole' cx='50' cy='50' r='20'/><g id='part'><rect id='plate' width='100' height='100'/>"
          "<circle cx='50' cy='50' r='5'/></g><rect id='beside' x='100' width='30' height='30'/>"
          "<rect id='across' x='90' y='95' width='9' height='9'/>");
  ASSERT_EQ(names_of(found), (Texts{"plate", "beside", "across"}));
  EXPECT_EQ(found.drawings[0].holes.size(), 2u);
  EXPECT_TRUE(found.drawings[1].holes.empty());
}

TEST(SvgDrawings, PolygonsAreAHundredthOfAMillimetreFromTheirCurves) {
  const SvgDrawings found = svg("<circle id='c' cx='50' cy='50' r='40'/><rect x='48' y='48' width='4' height='4'/>");
  ASSERT_EQ(found.drawings.size(), 1u);
  const NestRing& ring = found.drawings[0].outline;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const NestPoint middle = (ring[i] + ring[(i + 1) % ring.size()]) * 0.5 - NestPoint{50, 50};
    EXPECT_NEAR(norm(middle), 40, 0.01 + 3e-4 * 40);  // the curves themselves have an error of 0.03 %
  }
  EXPECT_EQ(found.drawings[0].curve(0).size(), 6u) << "M, four C and Z";
  EXPECT_TRUE(found.drawings[0].curve(1).empty()) << "a rectangle is its polygon";
}

TEST(SvgDrawings, LinesWhoseEndsMeetAreOneContour) {
  for (const std::string sides :
       {"<path id='s' d='M0 0H20'/><path d='M20 0V20'/><path d='M20 20H0'/><path d='M0 20V0'/>",
        "<polyline id='s' points='0,0 20,0'/><polyline points='20,20 20,0'/><polyline points='20,20 0,20'/>"
        "<polyline points='0,20 0,0'/>",
        "<line id='s' x2='20'/><line x1='20' x2='20.03' y2='20'/><line x1='20' y1='20.02' y2='20'/><line y1='20'/>",
        "<line id='s' x2='20'/><line x2='20'/><path d='M20 0V20H0V0'/>"}) {
    const SvgDrawings found = svg(kLines + sides + "</g>");
    ASSERT_EQ(names_of(found), Texts{"s"}) << sides;
    EXPECT_NEAR(area_of(found.drawings[0].outline), 400, 1);
    ASSERT_EQ(found.notes.size(), 1u);
    EXPECT_TRUE(found.notes[0].starts_with("joined ")) << found.notes[0];
    EXPECT_TRUE(found.notes[0].ends_with(" open paths to 1 contour: ends less than 0.05 mm apart meet"));
  }
}

TEST(SvgDrawings, LinesBesideAContourDoItNoHarm) {
  const SvgDrawings tail = svg(kLines +
                               "<path id='t' d='M-20 0H0'/><path id='s' d='M0 0H50'/><path d='M50 0V50'/>"
                               "<path d='M50 50H0'/><path d='M0 50V0'/></g>");
  ASSERT_EQ(names_of(tail), Texts{"s"});
  EXPECT_NEAR(area_of(tail.drawings[0].outline), 2500, 0.01);
  EXPECT_EQ(tail.notes, (Texts{"joined 4 open paths to 1 contour: ends less than 0.05 mm apart meet",
                               "left out 1 chain of lines that does not close: t"}));
  std::string circle;
  for (int i = 0; i < 1'000; ++i) {
    const auto at = [](int k) {
      const double t = 2 * std::acos(-1.0) * k / 1'000;
      return std::to_string(50 + 3 * std::cos(t)) + " " + std::to_string(50 + 3 * std::sin(t));
    };
    circle += "<path d='M" + at(i) + "L" + at(i + 1) + "'/>";
  }
  const SvgDrawings fine = svg(kLines + circle + "</g>");
  ASSERT_EQ(fine.drawings.size(), 1u) << "lines that are shorter than the reach";
  EXPECT_NEAR(area_of(fine.drawings[0].outline), 9 * std::acos(-1.0), 0.01);
}

TEST(SvgDrawings, JoinedLinesKeepTheirCurves) {
  const SvgDrawings found =
      svg(kLines + "<path id='s' d='M0 0H20'/><path d='M0 20C30 30 30 -10 20 0'/><path d='M0 20V0'/></g>");
  ASSERT_EQ(found.drawings.size(), 1u);
  const PathSteps& curve = found.drawings[0].curve(0);
  ASSERT_EQ(curve.size(), 5u);
  EXPECT_EQ(curve[2].command, 'C');
  EXPECT_NEAR(curve[2].points[0].y, -10, 0.01) << "it is gone the other way";
  EXPECT_NEAR(curve[2].points[1].y, 30, 0.01);
  EXPECT_EQ(curve[3].points[0], curve[0].points[0]);
  EXPECT_EQ(curve[4].command, 'Z');
  const std::vector<FlatSubpath> flat = flat_path(curve, 0.01);
  ASSERT_EQ(flat.size(), 1u);
  EXPECT_NEAR(double(flat[0].points.size()), double(found.drawings[0].outline.size()), 1);
}

TEST(SvgDrawings, OutlinesThatAreThereTwiceCountOnce) {
  const SvgDrawings found = svg("<rect id='fill' width='20' height='10'/>" + kLines +
                                "<rect id='line' width='20' height='10'/><path id='back' d='M0 0V10H20V0z'/>"
                                "<rect id='beside' x='0.01' width='20' height='10'/></g>");
  EXPECT_EQ(names_of(found), (Texts{"fill", "beside"}));
  EXPECT_EQ(found.notes, Texts{"left out 2 outlines that are there twice"});
}

TEST(SvgDrawings, OpenPathsThatAreFilledAreWhatIsFilled) {
  const SvgDrawings found = svg("<path id='f' d='M0 0H20V20'/><path id='g' d='M50 0C50 30 90 30 90 0'/>" + kLines +
                                "<path d='M0 50H9'/></g>");
  EXPECT_EQ(names_of(found), (Texts{"f", "g"}));
  EXPECT_NEAR(area_of(found.drawings[0].outline), 200, 0.01);
  EXPECT_EQ(found.notes, Texts{"left out 1 chain of lines that does not close: path2"});
}

TEST(SvgDrawings, NothingVanishesWithoutAWord) {
  const SvgDrawings found =
      svg("<rect id='a' width='30' height='30'/><polyline id='b' points='60,0 70,0 70,10 60,0'/>" + kLines +
          "<polyline points='0,50 10,50 10,60'/><line x1='50' y1='50' x2='60' y2='60'/></g><text y='9'>x</text>"
          "<rect id='hid' display='none' width='9' height='9'/><rect id='f' x='1e8' width='9' height='9'/>");
  EXPECT_EQ(names_of(found), (Texts{"a", "b"}));
  EXPECT_EQ(
      found.notes,
      (Texts{"left out 2 chains of lines that do not close: polyline2, line3",
             "left out 1 element that is not drawn (hidden, transparent, empty, damaged, or with neither fill "
             "nor stroke): hid",
             "left out 1 element that is no outline: text or image; a drawing program makes paths of text, and traces "
             "images",
             "left out 1 element with a coordinate that is no number or too large, allowed: 1e6 mm either way: f"}));
}

TEST(SvgDrawings, MasksThatAreTakenOffAreNamed) {
  const SvgDrawings found =
      svg("<mask id='m'><rect width='9' height='9' fill='white'/></mask><g mask='url(#m)'><rect id='a' width='30' "
          "height='30'/><rect id='b' x='50' width='30' height='30'/></g><rect id='c' y='50' width='30' height='30'/>");
  EXPECT_EQ(names_of(found), (Texts{"a", "b", "c"}));
  EXPECT_EQ(
      found.notes,
      Texts{"left out the mask of 2 elements, whose whole outline is cut (--leave-out NAME leaves one out): a, b"});
}

TEST(SvgDrawings, ABadOutlineBesideGoodOnesIsLeftOut) {
  const SvgDrawings found =
      svg("<rect id='good' width='30' height='30'/><rect x='5' y='5' width='5' height='5'/>"
          "<path id='bow' d='M40 0L90 50V0L40 50z'/><circle cx='80' cy='25' r='3'/><rect id='other' y='60' width='9' "
          "height='9'/><path id='two' d='M0 0L4 4z'/>");
  ASSERT_EQ(names_of(found), (Texts{"good", "other"})) << "the circle lies in the bow, and is none of the pieces";
  EXPECT_EQ(found.drawings[0].holes.size(), 1u);
  EXPECT_EQ(found.notes,
            Texts{"left out 2 contours: bow: found a contour that crosses itself; two: found a contour of 2 "
                  "points, allowed: 3 or more"});
  EXPECT_EQ(refusal("<path id='bow' d='M0 0L40 40V0L0 40z'/>"), "a.svg: bow: found a contour that crosses itself");
  EXPECT_EQ(refusal("<path id='a' d='M0 0L40 40V0L0 40z'/><path id='b' d='M0 0L4 4z'/>"),
            "a.svg: none of 2 contours is of use: a: found a contour that crosses itself; b: found a contour of 2 "
            "points, allowed: 3 or more");
}

TEST(SvgDrawings, ABedRoundEverythingIsToldAndMayBeLeftOut) {
  const std::string bed = kLines + "<rect id='bed' width='300' height='200'/></g>";
  const std::string parts = "<circle id='a' cx='50' cy='50' r='20'/><circle id='b' cx='150' cy='50' r='30'/>";
  EXPECT_EQ(
      svg(bed + parts).notes,
      Texts{"bed is a rectangle of 300.0 x 200.0 mm round everything else, which is cut as its holes; where it is "
            "only the bed, --leave-out bed nests what is in it"});
  EXPECT_EQ(names_of(svg(bed + parts)), Texts{"bed"});
  EXPECT_EQ(names_of(svg(bed + parts, {"bed"})), (Texts{"a", "b"}));
  EXPECT_EQ(svg(bed + parts, {"bed"}).notes, Texts{});
  EXPECT_EQ(svg(bed).notes, Texts{}) << "a lone rectangle is a part";
  EXPECT_EQ(svg("<path d='M0 0h90v90l-80 5z'/><circle cx='50' cy='50' r='9'/>").notes, Texts{});
}

TEST(SvgDrawings, BoundsHostileOnes) {
  std::string zigzag = "M0 0";
  for (int i = 0; i < 300'000; ++i) zigzag += i % 2 == 0 ? "l1 1" : "l1 -1";
  EXPECT_EQ(refusal("<path d='" + zigzag + "z'/>"),
            "a.svg: found more than 200000 points in a file; allowed: 200000 or fewer");
  std::string many;
  for (int i = 0; i < 4'001; ++i) many += "M" + std::to_string(i) + " 0h.5v.5z";
  EXPECT_EQ(refusal("<path d='" + many + "'/>"),
            "a.svg: found more than 4000 contours in a file; allowed: 4000 or fewer");
  EXPECT_TRUE(refusal("<rect id='" + std::string(2'000, 'n') + "' width='9' height='9'/>")
                  .starts_with("a.svg: id: found a name of 2000 bytes, \"nnnnnnnnnnnnnnnnnnnn...\", allowed: 1000"));
}

TEST(NestInput, ReadsSvgsThroughADrawer) {
  const test::ScratchFolder folder;
  const std::string inkscape = folder.write(
      "i.svg", document("<rect id='r' width='90' height='45'/>",
                        "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' inkscape:version='0.91' "
                        "width='90' height='90'"));
  EXPECT_EQ(
      read_nest_input(inkscape).notes,
      (Texts{inkscape + ": written by Inkscape 0.91, which had 90 px an inch: its shapes take 25.4 x 12.7 mm then, "
                        "and 23.8 x 11.9 mm at CSS's 96, as they are read here; --dpi 90 or --dpi 96 chooses one",
             inkscape + " says no unit: 1 unit is taken as 1/96 inch, its page is 23.8 x 23.8 mm; width and height "
                        "in mm in the SVG set it, --dpi says how many px an inch has"}));
  const NestInput at_90 = read_nest_input(inkscape, {.px_per_inch = 90, .left_out = {}});
  EXPECT_EQ(at_90.notes, Texts{});
  EXPECT_NEAR(box_of(at_90.sources.at(0).drawing.outline).width(), 25.4, 0.001);
  EXPECT_EQ(test::message_of([&] { read_nest_input(inkscape, {.px_per_inch = 90, .left_out = {"q"}}); }),
            "--leave-out q: fits no outline of an SVG; allowed: the id of an element that draws one, as r");
  const std::string dxf = folder.write("d.dxf", "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n40\n9\n0\nENDSEC\n0\nEOF\n");
  EXPECT_EQ(test::message_of([&] { read_nest_input(dxf, {.px_per_inch = 90, .left_out = {}}); }),
            "--dpi: " + dxf + " has no SVG with an outline; allowed: with an SVG");
  const std::string nothing = folder.write("n.svg", document("<text y='9'>x</text>"));
  EXPECT_EQ(test::message_of([&] { read_nest_input(nothing); }),
            nothing + ": found no closed shape; open lines enclose nothing; " + nothing +
                ": left out 1 element that is no outline: text or image; a drawing program makes paths of text, and "
                "traces images");
}

}  // namespace test_svg_drawings
}  // namespace tessera
