// DXFs of foreign origin: the outlines to cut, the entities that are left out and reported, and refused files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "products/nesting/drawings/dxf_drawings.h"
#include "products/nesting/nest_input.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_dxf_drawings {

using Names = std::vector<std::string>;

double area_of(const NestRing& ring) { return std::abs(signed_area(ring)); }

std::string section(const std::string& name, const std::string& content) {
  return "0\nSECTION\n2\n" + name + "\n" + content + "0\nENDSEC\n";
}

std::string dxf(const std::string& entities, const std::string& header = "") {
  return section("HEADER", header) + section("ENTITIES", entities) + "0\nEOF\n";
}

DxfDrawings read(const std::string& text) { return dxf_drawings(text, "a.dxf", "a"); }

std::string refused(const std::string& text) {
  return test::message_of([&] { read(text); });
}

/// Returns "10\n1\n" for code 10 and value 1.
std::string pair(int code, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%d\n%.17g\n", code, value);
  return text;
}

std::string point(int code, NestPoint p) { return pair(code, p.x) + pair(code + 10, p.y); }

std::string line(double x0, double y0, double x1, double y1) {
  return "0\nLINE\n8\n0\n" + point(10, {x0, y0}) + point(11, {x1, y1});
}

/// A closed LWPOLYLINE. `more` holds further pairs of the entity.
std::string polygon(const NestRing& ring, const std::string& more = "") {
  std::string text = "0\nLWPOLYLINE\n" + more + "70\n1\n";
  for (const NestPoint p : ring) text += point(10, p);
  return text;
}

std::string square(double x, double y, double side, const std::string& more = "") {
  return polygon({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, more);
}

std::string block(const std::string& name, const std::string& entities, NestPoint base = {}) {
  return "0\nBLOCK\n8\n0\n2\n" + name + "\n70\n0\n" + point(10, base) + entities + "0\nENDBLK\n8\n0\n";
}

std::string insert(const std::string& name, NestPoint at, const std::string& more = "") {
  return "0\nINSERT\n8\n0\n2\n" + name + "\n" + point(10, at) + more;
}

std::string with_blocks(const std::string& blocks, const std::string& entities) {
  return section("BLOCKS", blocks) + section("ENTITIES", entities) + "0\nEOF\n";
}

std::string layer(const std::string& name, int flags, int colour) {
  return "0\nLAYER\n2\n" + name + "\n70\n" + std::to_string(flags) + "\n62\n" + std::to_string(colour) + "\n";
}

std::string with_layers(const std::string& layers, const std::string& blocks, const std::string& entities) {
  return section("TABLES", "0\nTABLE\n2\nLAYER\n70\n9\n" + layers + "0\nENDTAB\n") + with_blocks(blocks, entities);
}

std::string spline(int degree, const std::vector<double>& knots, const NestRing& points,
                   const std::vector<double>& weights = {}) {
  std::string text = "0\nSPLINE\n70\n8\n71\n" + std::to_string(degree) + "\n";
  for (const double knot : knots) text += pair(40, knot);
  for (const double weight : weights) text += pair(41, weight);
  for (const NestPoint p : points) text += point(10, p) + "30\n0\n";
  return text;
}

/// The outline of the only piece with y up, from its original first point in its original direction.
NestRing only_outline(const DxfDrawings& found) {
  EXPECT_EQ(found.drawings.size(), 1u);
  NestRing ring = found.drawings.empty() ? NestRing{} : found.drawings[0].outline;
  for (NestPoint& p : ring) p.y = -p.y;
  return ring;
}

/// The boxes of the pieces with y up, as "0..20 0..10".
Names boxes(const DxfDrawings& found) {
  Names texts;
  for (const NestDrawing& drawing : found.drawings) {
    const NestBox box = box_of(drawing.outline);
    char text[99];
    std::snprintf(text, sizeof text, "%g..%g %g..%g", std::round(box.low.x * 1e6) / 1e6 + 0.0,
                  std::round(box.high.x * 1e6) / 1e6 + 0.0, std::round(-box.high.y * 1e6) / 1e6 + 0.0,
                  std::round(-box.low.y * 1e6) / 1e6 + 0.0);
    texts.push_back(text);
  }
  return texts;
}

TEST(DxfDrawings, JoinsLinesAndArcs) {
  const DxfDrawings found =
      dxf_drawings(dxf(line(0, 0, 10, 0) + line(0, 10, 0, 0) + line(10, 10, 0, 10) +
                       "0\nARC\n10\n10\n20\n5\n40\n5\n50\n270\n51\n90\n" + line(40, 40, 50, 50) + "0\nTEXT\n1\nx\n"),
                   "a.dxf", "a");
  ASSERT_EQ(found.drawings.size(), 1u);
  EXPECT_EQ(found.drawings[0].name, "a");
  EXPECT_NEAR(area_of(found.drawings[0].outline), 100 + 12.5 * std::acos(-1.0), 0.2);
  EXPECT_EQ(found.notes, (Names{"left out 1 entity of a kind that is not read: TEXT",
                                "left out 1 chain of lines that does not close"}));
}

TEST(DxfDrawings, LinesThatAreThereTwiceDoNoHarm) {
  const std::string box = line(0, 0, 10, 0) + line(10, 0, 10, 10) + line(10, 10, 0, 10) + line(0, 10, 0, 0);
  const std::string circle = "0\nCIRCLE\n10\n50\n20\n50\n40\n5\n";
  const DxfDrawings twice =
      dxf_drawings(dxf(box + line(0, 0, 10, 0) + line(10, 10, 10, 0) + circle + circle), "a.dxf", "a");
  ASSERT_EQ(twice.drawings.size(), 2u);
  EXPECT_NEAR(area_of(twice.drawings[0].outline), 100, 1e-9);
  EXPECT_EQ(twice.notes, Names{});
  // Two lines go out and back, and are not quite the same.
  const DxfDrawings thin = dxf_drawings(dxf(line(30, 0, 40, 0) + line(40, 0, 30, 0.001) + box), "a.dxf", "a");
  EXPECT_EQ(thin.drawings.size(), 1u);
  EXPECT_EQ(thin.notes, Names{"left out 1 chain of lines that does not close"});
}

TEST(DxfDrawings, ReadsPolylinesCirclesAndUnits) {
  const std::string light =
      "0\nLWPOLYLINE\r\n90\n4\n70\n1\n10\n0\n20\n0\n10\n2\n20\n0\n42\n1\n10\n2\n20\n2\n10\n0\n20\n2\n";
  const std::string heavy =
      "0\nPOLYLINE\n66\n1\n70\n1\n10\n0\n20\n0\n0\nVERTEX\n10\n10\n20\n10\n0\nVERTEX\n10\n11\n20\n10\n"
      "0\nVERTEX\n10\n10\n20\n11\n0\nSEQEND\n";
  const std::string hole = "0\nCIRCLE\n10\n1\n20\n1\n40\n0.5\n";
  const DxfDrawings found = dxf_drawings(dxf(light + heavy + hole, "9\n$INSUNITS\n70\n5\n"), "a.dxf", "a");
  ASSERT_EQ(found.drawings.size(), 2u);
  EXPECT_NEAR(area_of(found.drawings[0].outline), 100 * (4 + std::acos(-1.0) / 2), 0.5);
  ASSERT_EQ(found.drawings[0].holes.size(), 1u);
  EXPECT_NEAR(area_of(found.drawings[0].holes[0]), 25 * std::acos(-1.0), 0.3);
  EXPECT_NEAR(area_of(found.drawings[1].outline), 50, 1e-6);
}

TEST(DxfDrawings, KnowsEveryUnit) {
  const auto header = [](const std::string& unit) { return "9\n$INSUNITS\n70\n" + unit + "\n"; };
  const std::string box = line(0, 0, 3, 0) + line(3, 0, 3, 1) + line(3, 1, 0, 1) + line(0, 1, 0, 0);
  for (const auto& [unit, mm] : std::vector<std::pair<std::string, double>>{
           {"0", 1}, {"1", 25.4}, {"2", 304.8}, {"4", 1}, {"5", 10}, {"6", 1000}, {"10", 914.4}, {"14", 100}}) {
    const DxfDrawings found = dxf_drawings(dxf(box, header(unit)), "a.dxf", "a");
    EXPECT_NEAR(area_of(found.drawings.at(0).outline), 3 * mm * mm, 1e-9 * mm * mm) << unit;
  }
  for (const std::string unit : {"21", "-1", "1.5"}) {
    EXPECT_EQ(test::message_of([&] { dxf_drawings(dxf(box, header(unit)), "a.dxf", "a"); }),
              "a.dxf: line 8: $INSUNITS: found " + unit + ", allowed: a whole number from 0 to 20");
  }
}

TEST(DxfDrawings, RefusesDamage) {
  const auto refused = [](const std::string& text) {
    return test::message_of([&] { dxf_drawings(text, "a.dxf", "a"); });
  };
  EXPECT_EQ(refused(""), "a.dxf: not an ASCII DXF file");
  EXPECT_EQ(refused("AutoCAD Binary DXF\r\n"), "a.dxf: a binary DXF; save it as ASCII DXF");
  EXPECT_EQ(refused("AC1027\0\0"), "a.dxf: a DWG; save it as ASCII DXF");
  EXPECT_EQ(refused(dxf("0\nCIRCLE\n10\nnan\n20\n1\n40\n1\n")),
            "a.dxf: line 14: found \"nan\", allowed: a number from -1e12 to 1e12");
  EXPECT_EQ(refused(dxf("0\nCIRCLE\n10\n1\n20\n1\n40\n10,75\n")),
            "a.dxf: line 18: found \"10,75\", allowed: a number from -1e12 to 1e12");
  EXPECT_EQ(refused(dxf("0\nCIRCLE\n10\n1\n20\n1\n40\n1e300\n")),
            "a.dxf: line 18: found \"1e300\", allowed: a number from -1e12 to 1e12");
  EXPECT_EQ(refused("0\nSECTION\n2\nENTITIES\n0"), "a.dxf: line 5: ends within a pair of lines");
  EXPECT_EQ(refused(dxf(line(0, 0, 4, 4) + line(4, 4, 4, 0) + line(4, 0, 0, 4) + line(0, 4, 0, 0))),
            "a.dxf: contour 1 at (0, 0): found a contour that crosses itself");
  EXPECT_EQ(refused(dxf("0\nCIRCLE\n10\n0\n20\n0\n40\n1e11\n")),
            "a.dxf: contour 1 at (-1e+11, -1e+11): found a coordinate that is no number or too large, allowed: 1e6 mm "
            "either way");
  std::string many;
  for (int i = 0; i < 30'000; ++i) many += line(0, 0, 0, 0);
  EXPECT_EQ(refused(dxf(many)), "a.dxf: found 30000 lines and arcs, allowed: 20000");
}

TEST(DxfDrawings, VerticesOfFittedPolylines) {
  // A spline-fit POLYLINE of R12. Its control points (16) are not part of the line, its fitted points (8) are.
  std::string fitted = "0\nPOLYLINE\n66\n1\n70\n5\n75\n6\n";
  for (const NestPoint p : NestRing{{0, 0}, {100, 100}, {100, 0}, {0, 100}})
    fitted += "0\nVERTEX\n" + point(10, p) + "70\n16\n";
  for (const NestPoint p : NestRing{{10, 10}, {90, 10}, {90, 90}, {10, 90}})
    fitted += "0\nVERTEX\n" + point(10, p) + "70\n8\n";
  const DxfDrawings found = read(dxf(fitted + "0\nVERTEX\n10\n500\n20\n500\n70\n16\n0\nSEQEND\n8\nFROZEN\n"));
  EXPECT_EQ(boxes(found), Names{"10..90 10..90"});
  EXPECT_NEAR(area_of(only_outline(found)), 6400, 1e-9);
  // A curve-fit POLYLINE: the original vertices (2) and those added by fitting (1), with bulges, form the line.
  std::string curve = "0\nPOLYLINE\n66\n1\n70\n3\n";
  for (const auto& [x, flags] : std::vector<std::pair<double, int>>{{0, 2}, {20, 1}})
    curve += "0\nVERTEX\n" + point(10, {x, 0}) + "42\n1\n70\n" + std::to_string(flags) + "\n";
  EXPECT_NEAR(area_of(only_outline(read(dxf(curve + "0\nSEQEND\n")))), 100 * std::numbers::pi, 0.5);
}

TEST(DxfDrawings, MeshesAndTiltedPlanesAreLeftOut) {
  const DxfDrawings found =
      read(dxf(square(0, 0, 9) + "0\nPOLYLINE\n70\n16\n71\n2\n72\n2\n0\nVERTEX\n10\n0\n0\nSEQEND\n" +
               "0\nCIRCLE\n10\n50\n20\n50\n40\n5\n210\n1\n220\n0\n230\n0\n"));
  EXPECT_EQ(boxes(found), Names{"0..9 0..9"});
  EXPECT_EQ(found.notes,
            Names{"left out 2 entities of kinds that are not read: POLYLINE that is a mesh, entity in a tilted plane"});
}

TEST(DxfDrawings, WhatIsNotSeenIsNotCut) {
  const std::string layers = layer("ON", 0, 7) + layer("Off", 0, -7) + layer("FROZEN", 1, 7) + layer("LOCKED", 4, 7);
  const DxfDrawings found =
      read(with_layers(layers, "",
                       square(0, 0, 10, "8\nON\n") + square(20, 0, 11, "8\nOFF\n") + square(40, 0, 12, "8\nfrozen\n") +
                           square(60, 0, 13, "8\nON\n60\n1\n") + square(80, 0, 14, "8\nLOCKED\n60\n0\n") +
                           square(100, 0, 15, "67\n1\n")));
  EXPECT_EQ(boxes(found), (Names{"0..10 0..10", "80..94 0..14"}));
  EXPECT_EQ(found.notes, (Names{"left out 2 entities on layers that are off or frozen: OFF, frozen",
                                "left out 1 invisible entity", "left out 1 entity of a layout on paper"}));
}

TEST(DxfDrawings, LayersOfBlocks) {
  // On layer 0 an entity of a block takes the layer of its reference.
  // A frozen layer hides a whole reference. A layer that is off hides only the entities on it.
  const std::string layers = layer("OFF", 0, -7) + layer("FROZEN", 1, 7);
  const std::string blocks = block("B", square(0, 0, 1, "8\n0\n") + square(2, 0, 3, "8\nOWN\n"));
  const DxfDrawings found =
      read(with_layers(layers, blocks,
                       insert("B", {0, 0}) + insert("B", {100, 0}, "8\nOFF\n") + insert("B", {200, 0}, "8\nFROZEN\n") +
                           insert("B", {300, 0}, "60\n1\n")));
  EXPECT_EQ(boxes(found), (Names{"0..1 0..1", "2..5 0..3", "102..105 0..3"}));
  EXPECT_EQ(found.notes, (Names{"left out 2 entities on layers that are off or frozen: OFF, FROZEN",
                                "left out 1 invisible entity"}));
}

TEST(DxfDrawings, BlocksAreScaledMirroredTurnedAndRepeated) {
  const std::string triangle = polygon({{0, 0}, {20, 0}, {0, 10}});
  const std::string blocks =
      block("A", triangle) + block("Off", triangle, {20, 0}) + block("NEST", insert("a", {1, 2}, "41\n3\n42\n3\n"));
  const auto boxes_of = [&](const std::string& entities) { return boxes(read(with_blocks(blocks, entities))); };
  EXPECT_EQ(boxes_of(insert("A", {5, 6})), Names{"5..25 6..16"});
  EXPECT_EQ(boxes_of(insert("A", {50, 0}, "41\n-1\n")), Names{"30..50 0..10"});
  EXPECT_EQ(boxes_of(insert("A", {0, 0}, "41\n2\n42\n0.5\n")), Names{"0..40 0..5"});
  EXPECT_EQ(boxes_of(insert("A", {0, 0}, "50\n90\n")), Names{"-10..0 0..20"});
  EXPECT_EQ(boxes_of(insert("A", {0, 0}, "41\n2\n50\n90\n")), Names{"-10..0 0..40"});  // scaled first, then turned
  EXPECT_EQ(boxes_of(insert("OFF", {0, 0}, "50\n180\n")), Names{"0..20 -10..0"});      // turned about its base point
  EXPECT_EQ(boxes_of(insert("NEST", {100, 0}, "50\n90\n")), Names{"68..98 1..61"});
  EXPECT_EQ(boxes_of(insert("A", {3, 0}, "230\n-1\n")), Names{"-23..-3 0..10"});  // its plane is seen from below
  EXPECT_EQ(boxes_of(insert("A", {0, 0}, "70\n2\n71\n3\n44\n30\n45\n40\n41\n0.5\n")),
            (Names{"0..10 0..10", "30..40 0..10", "0..10 40..50", "30..40 40..50", "0..10 80..90", "30..40 80..90"}));
  EXPECT_EQ(boxes_of(insert("A", {0, 0}, "50\n90\n70\n2\n44\n30\n")), (Names{"-10..0 0..20", "-10..0 30..50"}));
  // The right angle of the mirrored triangle is on the right.
  const NestRing mirrored = only_outline(read(with_blocks(blocks, insert("A", {0, 0}, "41\n-1\n"))));
  EXPECT_NE(std::find(mirrored.begin(), mirrored.end(), NestPoint{0, 10}), mirrored.end());
  EXPECT_EQ(std::find(mirrored.begin(), mirrored.end(), NestPoint{-20, 10}), mirrored.end());
}

TEST(DxfDrawings, CurvesOfBlocksKeepTheirShape) {
  const std::string blocks =
      block("DISC", "0\nCIRCLE\n10\n0\n20\n0\n40\n10\n") +
      block("SLOT", "0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n10\n20\n20\n0\n42\n1\n10\n20\n20\n10\n10\n0\n20\n10\n42\n1\n");
  const double pi = std::numbers::pi;
  const NestRing ellipse = only_outline(read(with_blocks(blocks, insert("DISC", {0, 0}, "41\n3\n50\n30\n"))));
  EXPECT_NEAR(area_of(ellipse), 300 * pi, 0.5);
  for (const NestPoint p : ellipse) {
    const double x = (p.x * std::cos(pi / 6) + p.y * std::sin(pi / 6)) / 30,
                 y = (p.y * std::cos(pi / 6) - p.x * std::sin(pi / 6)) / 10;
    EXPECT_NEAR(std::hypot(x, y), 1, 1e-9);
  }
  for (const std::string more : {"", "41\n-1\n", "42\n-1\n", "230\n-1\n"}) {
    EXPECT_NEAR(area_of(only_outline(read(with_blocks(blocks, insert("SLOT", {0, 0}, more))))), 200 + 25 * pi, 0.3);
  }
}

TEST(DxfDrawings, BlocksThatAreNotThereAreTold) {
  const std::string xref = "0\nBLOCK\n2\nXREF\n70\n4\n1\nother.dwg\n0\nENDBLK\n";
  const std::string unused = block("UNUSED", "0\nTEXT\n1\nx\n0\nHATCH\n");
  const DxfDrawings found =
      read(with_blocks(xref + unused + block("T", square(0, 0, 9) + "0\nTEXT\n1\nx\n0\nATTDEF\n1\nx\n"),
                       insert("T", {0, 0}) + insert("XREF", {0, 0}) + insert("GONE", {0, 0}) + "0\nVIEWPORT\n67\n1\n"));
  EXPECT_EQ(boxes(found), Names{"0..9 0..9"});
  EXPECT_EQ(found.notes, (Names{"left out 1 entity of a kind that is not read: TEXT",
                                "left out 2 references to blocks that the file does not hold: XREF, GONE"}));
}

TEST(DxfDrawings, BlocksThatExplodeAreRefused) {
  EXPECT_EQ(refused(with_blocks(block("Loop", square(0, 0, 1) + insert("LOOP", {2, 2})), insert("loop", {0, 0}))),
            "a.dxf: block \"Loop\": it contains itself");
  EXPECT_EQ(refused(with_blocks(block("A", insert("B", {0, 0})) + block("B", insert("A", {0, 0})), insert("A", {}))),
            "a.dxf: block \"A\": it contains itself");
  // A block that contains itself does no harm if no entity refers to it.
  EXPECT_EQ(refused(with_blocks(block("A", insert("A", {0, 0})), square(0, 0, 1))), "");
  std::string doubling = block("B0", "");
  for (int i = 1; i < 60; ++i) {
    const std::string inner = insert("B" + std::to_string(i - 1), {0, 0});
    doubling += block("B" + std::to_string(i), inner + inner);
  }
  const std::string many = "a.dxf: found more than 200000 entities in its blocks; allowed: 200000 or fewer";
  EXPECT_EQ(refused(with_blocks(doubling, insert("B59", {0, 0}))), many);
  EXPECT_EQ(refused(with_blocks(block("E", ""), insert("E", {0, 0}, "70\n30000\n71\n30000\n"))), many);
  EXPECT_EQ(refused(with_blocks(block("E", "0\nCIRCLE\n40\n9\n"), insert("E", {0, 0}, "70\n30000\n71\n30000\n"))),
            "a.dxf: found more than 200000 points in a file; allowed: 200000 or fewer");
  std::string deep = block("B0", square(0, 0, 1));
  for (int i = 1; i < 100; ++i) deep += block("B" + std::to_string(i), insert("B" + std::to_string(i - 1), {0, 0}));
  EXPECT_EQ(refused(with_blocks(deep, insert("B99", {0, 0}))),
            "a.dxf: found more than 64 levels of blocks; allowed: 64 or fewer");
  EXPECT_EQ(refused(with_blocks(deep, insert("B63", {0, 0}))), "");
  std::string growing = block("B0", square(0, 0, 1));
  for (int i = 1; i < 60; ++i)
    growing += block("B" + std::to_string(i), insert("B" + std::to_string(i - 1), {0, 0}, "41\n1e12\n"));
  EXPECT_EQ(refused(with_blocks(growing, insert("B59", {0, 0}))),
            "a.dxf: block \"B55\": found a reference that makes it too large");
}

TEST(DxfDrawings, SplinesWithRepeatedKnots) {
  // Two cubic Bézier curves that meet in a corner at (30, 60). The area is computed by hand.
  const NestRing points = {{0, 0}, {30, 0}, {60, 30}, {30, 60}, {0, 60}, {-30, 30}, {0, 0}};
  const NestRing outline = only_outline(read(dxf(spline(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}, points))));
  EXPECT_NEAR(area_of(outline), 2430, 2430 * 0.001);
  EXPECT_NE(std::find(outline.begin(), outline.end(), NestPoint{30, 60}), outline.end());
  // A spline of degree 1 is the polygon of its control points.
  const NestRing square = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}};
  EXPECT_EQ(only_outline(read(dxf(spline(1, {0, 0, 1, 2, 3, 4, 4}, square)))),
            NestRing(square.begin(), square.end() - 1));
  // A closed uniform spline of degree 2: the control points repeat at its end, and the ends are not clamped.
  const NestRing round = {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}, {100, 0}};
  EXPECT_NEAR(area_of(only_outline(read(dxf(spline(2, {0, 1, 2, 3, 4, 5, 6, 7, 8}, round))))), 25'000.0 / 3, 3);
}

TEST(DxfDrawings, RationalSplinesAreExactCircles) {
  const double w = std::sqrt(0.5);
  const NestRing points = {{10, 0}, {10, 10}, {0, 10}, {-10, 10}, {-10, 0}, {-10, -10}, {0, -10}, {10, -10}, {10, 0}};
  const std::string circle = spline(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, points, {1, w, 1, w, 1, w, 1, w, 1});
  const NestRing ring = only_outline(read(dxf(circle)));
  EXPECT_NEAR(area_of(ring), 100 * std::numbers::pi, 0.5);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    EXPECT_NEAR(norm(ring[i]), 10, 1e-9);
    // No point is farther than 0.01 mm from the curve.
    EXPECT_GT(norm((ring[i] + ring[(i + 1) % ring.size()]) * 0.5), 10 - 0.01);
  }
  // A mirrored and scaled circle in a block.
  EXPECT_NEAR(area_of(only_outline(read(with_blocks(block("C", circle), insert("C", {}, "41\n-5\n42\n2\n"))))),
              1000 * std::numbers::pi, 2);
}

TEST(DxfDrawings, SplinesThatCannotBeReadAreTold) {
  const NestRing points = {{0, 0}, {9, 0}, {9, 9}, {0, 0}};
  const auto notes = [&](const std::string& curve) { return read(dxf(square(0, 0, 1) + curve)).notes; };
  EXPECT_EQ(notes("0\nSPLINE\n70\n1024\n71\n3\n74\n3\n11\n0\n21\n0\n11\n9\n21\n9\n11\n0\n21\n9\n"),
            Names{"left out 1 entity of a kind that is not read: SPLINE with fit points only"});
  const Names wrong = {"left out 1 entity of a kind that is not read: SPLINE whose knots or weights are wrong"};
  EXPECT_EQ(notes(spline(3, {0, 0, 0, 0, 1, 1, 1}, points)), wrong);
  EXPECT_EQ(notes(spline(3, {0, 0, 0, 0, 1, 1, 1, 0}, points)), wrong);
  EXPECT_EQ(notes(spline(3, {0, 0, 0, 0, 0, 0, 0, 0}, points)), wrong);
  EXPECT_EQ(notes(spline(3, {0, 0, 0, 0, 1, 1, 1, 1}, points, {1, 1, 1})), wrong);
  EXPECT_EQ(notes(spline(3, {0, 0, 0, 0, 1, 1, 1, 1}, points, {1, 0, 1, 1})), wrong);
  EXPECT_EQ(notes(spline(0, {0, 1, 2, 3, 4}, points)), wrong);
  EXPECT_EQ(notes(spline(3, {0, 0, 0, 0, 1, 1, 1, 1}, points, {1, 1, 1, 1})), Names{});
}

TEST(DxfDrawings, EllipsesAndTheirArcs) {
  const std::string centre = "0\nELLIPSE\n10\n50\n20\n50\n11\n24\n21\n32\n40\n0.5\n";
  const double pi = std::numbers::pi;
  const NestRing whole = only_outline(read(dxf(centre + "41\n0\n42\n6.283185307179586\n")));
  EXPECT_NEAR(area_of(whole), 800 * pi, 1);
  for (const NestPoint p : whole) {
    const NestPoint off = p - NestPoint{50, 50};
    EXPECT_NEAR(std::hypot((off.x * 0.6 + off.y * 0.8) / 40, (off.y * 0.6 - off.x * 0.8) / 20), 1, 1e-9);
  }
  EXPECT_EQ(only_outline(read(dxf(centre))).size(), whole.size());
  // Half an ellipse, closed by a line. It runs anticlockwise from the end of its major axis, or clockwise when seen from below.
  const std::string half = "0\nELLIPSE\n10\n0\n20\n0\n11\n40\n21\n0\n40\n0.5\n41\n0\n42\n" + std::to_string(pi) + "\n";
  const NestBox above = box_of(only_outline(read(dxf(half + line(-40, 0, 40, 0)))));
  EXPECT_NEAR(above.low.y, 0, 1e-4);
  EXPECT_NEAR(above.high.y, 20, 0.01);
  const NestBox below = box_of(only_outline(read(dxf(half + "210\n0\n220\n0\n230\n-1\n" + line(-40, 0, 40, 0)))));
  EXPECT_NEAR(below.low.y, -20, 0.01);
  EXPECT_NEAR(below.high.y, 0, 1e-4);
}

TEST(DxfDrawings, NationalGridIsMovedToTheOrigin) {
  const DxfDrawings found = read(dxf(square(3'500'000.25, 5'800'000.5, 100) + square(3'500'010.25, 5'800'010.5, 10)));
  EXPECT_EQ(boxes(found), Names{"0..100 0..100"});
  ASSERT_EQ(found.drawings[0].holes.size(), 1u);
  EXPECT_EQ(found.notes, Names{"the drawing begins at (3500000.25, 5800000.5): moved to the origin"});
  // In metres, with one stray outline at the origin, far from most others.
  const DxfDrawings metres = read(dxf(square(0, 0, 0.1) + square(3'500'000.25, 5'800'000.5, 0.5) +
                                          square(3'500'001.25, 5'800'000.5, 0.5) + square(3'500'002, 5'800'000.5, 0.25),
                                      "9\n$INSUNITS\n70\n6\n"));
  EXPECT_EQ(boxes(metres), (Names{"0..500 0..500", "1000..1500 0..500", "1750..2000 0..250"}));
  EXPECT_EQ(metres.notes, (Names{"the drawing begins at (3500000.25, 5800000.5): moved to the origin",
                                 "left out contour 1 at (0, 0): found a coordinate that is no number or too large, "
                                 "allowed: 1e6 mm either way"}));
  EXPECT_EQ(boxes(read(dxf(square(-500, 999'000, 100)))), Names{"-500..-400 999000..999100"}) << "is near enough";
}

TEST(DxfDrawings, ABadOutlineBesideGoodOnesIsLeftOut) {
  const NestRing bow = {{50, 50}, {60, 60}, {60, 50}, {50, 60}};
  const DxfDrawings found = read(dxf(square(0, 0, 10) + polygon(bow) + square(58.5, 54.5, 1)));
  EXPECT_EQ(boxes(found), Names{"0..10 0..10"}) << "what lies in the bad one is no piece";
  EXPECT_EQ(found.notes, Names{"left out contour 2 at (50, 50): found a contour that crosses itself"});
  EXPECT_EQ(refused(dxf(polygon(bow))), "a.dxf: contour 1 at (50, 50): found a contour that crosses itself");
  const NestRing other = {{0, 0}, {9, 9}, {9, 0}, {0, 9}};
  EXPECT_EQ(
      refused(dxf(polygon(bow) + polygon(other))),
      "a.dxf: none of 2 contours is of use: contour 1 at (50, 50): found a contour that crosses itself; contour 2 "
      "at (0, 0): found a contour that crosses itself");
}

TEST(DxfDrawings, NestTellsWhatWasLeftOut) {
  test::ScratchFolder folder;
  const auto path = [&](const std::string& text) { return folder.write("part.dxf", text); };
  const std::string hidden = path(dxf(square(0, 0, 9, "60\n1\n") + "0\nHATCH\n"));
  EXPECT_EQ(test::message_of([&] { read_nest_input(hidden); }),
            hidden + ": found no closed shape; open lines enclose nothing; " + hidden +
                ": left out 1 invisible entity; " + hidden + ": left out 1 entity of a kind that is not read: HATCH");
  const std::string plain = polygon({{0, 0}, {9.84, 0}, {9.84, 3.94}, {0, 3.94}});
  const std::string says = ": 1 unit is taken as 1 mm, its shapes take 9.84 x 3.94 mm; ";
  const std::string cure = "$INSUNITS in the DXF sets it";
  const std::string unit = path(dxf(plain));
  EXPECT_EQ(read_nest_input(unit).notes, Names{unit + " says no unit" + says + cure});
  EXPECT_EQ(read_nest_input(path(dxf(plain, "9\n$INSUNITS\n70\n0\n9\n$MEASUREMENT\n70\n0\n"))).notes,
            Names{unit + " says no unit" + says + "$MEASUREMENT = 0 hints at inches: 249.9 x 100.1 mm; " + cure});
  EXPECT_EQ(read_nest_input(path(dxf(plain, "9\n$INSUNITS\n70\n1\n9\n$MEASUREMENT\n70\n0\n"))).notes, Names{});
}

TEST(DxfDrawings, UnitsThatAreHintedAt) {
  const auto hint = [](const std::string& header) { return read(dxf(square(0, 0, 9), header)).measures_in_inches; };
  EXPECT_TRUE(hint("9\n$MEASUREMENT\n70\n0\n"));
  EXPECT_FALSE(hint("9\n$MEASUREMENT\n70\n1\n"));
  EXPECT_FALSE(hint(""));
}

}  // namespace test_dxf_drawings
}  // namespace tessera
