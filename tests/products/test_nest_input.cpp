// What is nested comes from strangers: instances and SVGs. DXFs: test_dxf_drawings.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "core/base/error.h"
#include "products/nesting/drawings/svg_drawings.h"
#include "products/nesting/drawings/svg_path_data.h"
#include "products/nesting/nest_instance.h"

namespace tessera {
namespace test_nest_input {

SvgDrawings svg(const std::string& content,
                const std::string& page = "width='100mm' height='100mm' viewBox='0 0 100 100'") {
  const std::string text = "<svg xmlns='http://www.w3.org/2000/svg' " + page + ">" + content + "</svg>";
  return svg_drawings({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "a.svg");
}

std::string refusal(const std::function<void()>& f) {
  try {
    f();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string svg_refusal(const std::string& content) {
  return refusal([&] { svg(content); });
}

double area_of(const NestRing& ring) { return std::abs(signed_area(ring)); }

TEST(SvgDrawings, ReadsAllKindsInMm) {
  const SvgDrawings found =
      svg("<rect id='r' width='20' height='10'/><circle id='c' cx='50' cy='50' r='10'/>"
          "<ellipse id='e' cx='9' cy='9' rx='4' ry='8'/><polygon id='p' points='0,30 10,30 0,40'/>"
          "<rect id='q' x='60' width='20' height='10' rx='5'/><path id='x' d='M0 60h10v10h-10z'/><path d='M1 1L3 3'/>");
  ASSERT_EQ(found.drawings.size(), 6u);
  EXPECT_EQ(found.open_paths, 1);
  const double pi = std::acos(-1.0);
  const std::vector<std::pair<std::string, double>> want = {
      {"r", 200}, {"c", 100 * pi}, {"e", 32 * pi}, {"p", 50}, {"q", 200 - (100 - 25 * pi)}, {"x", 100}};
  for (std::size_t i = 0; i < want.size(); ++i) {
    EXPECT_EQ(found.drawings[i].name, want[i].first);
    EXPECT_NEAR(area_of(found.drawings[i].outline), want[i].second, 0.01 * want[i].second) << want[i].first;
  }
}

TEST(SvgDrawings, UnitsAndTransforms) {
  EXPECT_NEAR(area_of(svg("<rect width='96' height='96'/>", "").drawings.at(0).outline), 25.4 * 25.4, 1e-6);
  EXPECT_NEAR(
      area_of(
          svg("<rect width='1' height='1'/>", "width='20cm' height='20cm' viewBox='0 0 10 10'").drawings.at(0).outline),
      400, 1e-6);
  const NestRing ring =
      svg("<g transform='translate(10,20) rotate(90)'><rect transform='scale(2 3)' width='5' height='1'/></g>")
          .drawings.at(0)
          .outline;
  const NestBox box = box_of(ring);
  EXPECT_NEAR(box.low.x, 7, 1e-9);
  EXPECT_NEAR(box.high.x, 10, 1e-9);
  EXPECT_NEAR(box.low.y, 20, 1e-9);
  EXPECT_NEAR(box.high.y, 30, 1e-9);
}

TEST(SvgDrawings, HolesTravelAlongAndPartsAreParted) {
  const SvgDrawings found = svg("<path id='a' d='M0 0h30v30h-30z m5 5h5v5h-5z M40 0h9v9h-9z'/>");
  ASSERT_EQ(found.drawings.size(), 2u);
  EXPECT_EQ(found.drawings[0].name, "a-1");
  EXPECT_EQ(found.drawings[0].holes.size(), 1u);
  EXPECT_EQ(found.drawings[1].name, "a-2");
  EXPECT_TRUE(found.drawings[1].holes.empty());
}

TEST(SvgDrawings, HolesMayBeElementsOfTheirOwn) {
  const SvgDrawings found =
      svg("<circle id='hole' cx='50' cy='50' r='20'/><g id='part'><rect id='plate' width='100' height='100'/>"
          "<circle cx='50' cy='50' r='5'/></g><rect id='beside' x='100' width='30' height='30'/>"
          "<rect id='across' x='90' y='95' width='9' height='9'/>");
  ASSERT_EQ(found.drawings.size(), 3u);
  EXPECT_EQ(found.drawings[0].name, "plate");
  EXPECT_EQ(found.drawings[0].holes.size(), 2u);
  EXPECT_EQ(found.drawings[1].name, "beside");
  EXPECT_TRUE(found.drawings[1].holes.empty());
  EXPECT_EQ(found.drawings[2].name, "across");
}

TEST(SvgDrawings, NothingVanishesWithoutAWord) {
  const SvgDrawings found =
      svg("<switch><foreignObject requiredExtensions='x'/><g><rect id='a' width='30' height='30'/></g>"
          "<rect id='not' x='40' width='9' height='9'/></switch><polyline id='b' points='60,0 70,0 70,10 60,0'/>"
          "<polyline points='0,0 10,0 10,10'/><line x2='9'/><use href='#a'/><image/><text>x</text>");
  ASSERT_EQ(found.drawings.size(), 2u);
  EXPECT_EQ(found.drawings[0].name, "a");
  EXPECT_EQ(found.drawings[1].name, "b");
  EXPECT_EQ(found.open_paths, 2);
  EXPECT_EQ(found.unread_elements, 3);
}

TEST(SvgPath, NumbersThatOverflowAreRefused) {
  EXPECT_NE(svg_refusal("<g transform='scale(1e200)'><g transform='scale(1e200)'><circle id='c' r='9'/></g></g>"), "");
  EXPECT_NE(svg_refusal("<path id='p' transform='scale(1e200)' d='M0 0C1e300 0 -1e300 9 1e300 9z'/>"), "");
}

TEST(SvgDrawings, WhatIsNotDrawnIsNotRead) {
  EXPECT_TRUE(svg("<defs><rect width='9' height='9'/></defs><clipPath><rect width='9' height='9'/></clipPath>"
                  "<g display='none'><rect width='9' height='9'/></g><rect style='display: none' width='9' height='9'/>"
                  "<rect width='0' height='9'/><text>x</text>")
                  .drawings.empty());
}

TEST(SvgPath, KnowsEveryCommand) {
  const auto area = [](const std::string& d) { return area_of(svg_subpaths(d, {}).at(0).points); };
  EXPECT_NEAR(area("M0,0L10 0l0 10H0Z"), 100, 1e-9);
  EXPECT_NEAR(area("m0 0 10 0 0 10-10 0z"), 100, 1e-9);
  EXPECT_NEAR(area("M0 0V10h10v-10z"), 100, 1e-9);
  EXPECT_NEAR(area("M0 0C0 10 10 10 10 0z"), 60, 0.1);
  EXPECT_NEAR(area("M0 0c0 10 10 10 10 0s10-10 10 0z"), 0, 0.2);
  EXPECT_NEAR(area("M0 0Q5 10 10 0z"), 100.0 / 3, 0.1);
  EXPECT_NEAR(area("M0 0q5 10 10 0t10 0z"), 0, 0.2);
  EXPECT_NEAR(area("M0 0A5 5 0 0 1 10 0z"), 12.5 * std::acos(-1.0), 0.2);
  EXPECT_NEAR(area("M0 0a5 5 0 1010 0z"), 12.5 * std::acos(-1.0), 0.2);   // flags without separators
  EXPECT_NEAR(area("M0 0a1 1 0 01 10 0z"), 12.5 * std::acos(-1.0), 0.2);  // too small: enlarged
  EXPECT_NEAR(area("M.5.5l1e1 0 0-1e1z"), 50, 1e-9);
  EXPECT_EQ(svg_subpaths("M0 0h1v1zM5 5h1v1zl3 3 0 4z", {}).size(), 3u);
}

TEST(SvgDrawings, RefusesWhatIsOfNoUse) {
  EXPECT_EQ(svg_refusal("<path id='bow' d='M0 0L40 40V0L0 40z'/>"), "a.svg: bow: found a contour that crosses itself");
  EXPECT_EQ(svg_refusal("<path id='flat' d='M0 0L40 40L80 80z'/>"),
            "a.svg: flat: found a contour that encloses nothing");
  EXPECT_EQ(svg_refusal("<path id='two' d='M0 0L40 40z'/>"),
            "a.svg: two: found a contour of 2 points, allowed: 3 or more");
  EXPECT_EQ(svg_refusal("<path id='far' d='M0 0H1e9V9z'/>"),
            "a.svg: far: found a coordinate that is no number or too large, allowed: 1e6 mm either way");
  for (const std::string d :
       {"M0 0Lnan 3z", "M0 0L1e999 3z", "M0 0L", "L3 3", "M0 0X3", "3 4", "M0 0A1 1 0 2 1 4 4z", "M0 0zz5"})
    EXPECT_NE(svg_refusal("<path id='bad' d='" + d + "'/>").find("a.svg: bad: found"), std::string::npos) << d;
  EXPECT_NE(svg_refusal("<rect width='9' height='9' transform='rotate(x)'/>").find("a.svg: rect1: found"),
            std::string::npos);
  EXPECT_NE(svg_refusal("<rect width='9' height='9' transform='turn(3)'/>").find("transform: found turn"),
            std::string::npos);
  EXPECT_EQ(svg_refusal("<rect").substr(0, 39), "a.svg: not a readable SVG file: line 1:");
  EXPECT_EQ(refusal([] { svg("", "viewBox='0 0 0 9'"); }),
            "a.svg: viewBox: found \"0 0 0 9\", allowed: four numbers, the last two above 0");
  EXPECT_EQ(svg_refusal("<circle r='1e9'/>"),
            "a.svg: circle1: r: found \"1e9\", allowed: a length below 1e9 px, in px, mm, cm, in, pt or pc");
}

TEST(SvgDrawings, ABadOutlineBesideGoodOnesIsLeftOut) {
  const SvgDrawings found =
      svg("<rect id='good' width='30' height='30'/><rect x='5' y='5' width='5' height='5'/>"
          "<path id='bow' d='M40 0L90 50V0L40 50z'/><circle cx='80' cy='25' r='3'/><path id='two' d='M0 0L4 4z'/>");
  ASSERT_EQ(found.drawings.size(), 1u) << "the circle lies in the bow, and is none of the pieces";
  EXPECT_EQ(found.drawings[0].name, "good");
  EXPECT_EQ(found.drawings[0].holes.size(), 1u);
  EXPECT_EQ(
      found.left_out,
      "left out 2 contours: bow: found a contour that crosses itself; two: found a contour of 2 points, allowed: 3 "
      "or more");
  EXPECT_EQ(svg("<rect width='9' height='9'/>").left_out, "");
  EXPECT_EQ(svg_refusal("<path id='a' d='M0 0L40 40V0L0 40z'/><path id='b' d='M0 0L4 4z'/>"),
            "a.svg: none of 2 contours is of use: a: found a contour that crosses itself; b: found a contour of 2 "
            "points, allowed: 3 or more");
}

TEST(SvgDrawings, BoundsHostileOnes) {
  std::string nested;
  for (int i = 0; i < 5'000; ++i) nested += "<g>";
  EXPECT_EQ(svg_refusal(nested), "a.svg: found 251 levels of elements in each other, allowed: 250");
  std::string bomb = "<!DOCTYPE svg [<!ENTITY a '0123456789'>";
  for (char c = 'b'; c < 'l'; ++c) {
    bomb += "<!ENTITY " + std::string(1, c) + " '";
    for (int i = 0; i < 10; ++i) bomb += "&" + std::string(1, char(c - 1)) + ";";
    bomb += "'>";
  }
  bomb += "]><svg xmlns='http://www.w3.org/2000/svg'><path d='&k;'/></svg>";
  EXPECT_NE(refusal([&] {
              svg_drawings({reinterpret_cast<const std::uint8_t*>(bomb.data()), bomb.size()}, "b.svg");
            }),
            "");
  const auto of_entity = [](const std::string& attribute) {
    const std::string text = "<!DOCTYPE svg [<!ENTITY a '" + std::string(1'000'000, ' ') +
                             "'><!ATTLIST path d CDATA 'M0 0z'>]><svg xmlns='http://www.w3.org/2000/svg'>"
                             "<rect id='&lt;r&gt;' width='9' height='9'/><path " +
                             attribute + "='M0 0h9v9z&a;&a;&a;'/></svg>";
    return refusal([&] { svg_drawings({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "e.svg"); });
  };
  EXPECT_EQ(of_entity("d"), "e.svg: path2: d: found an entity, allowed: what it stands for");
  EXPECT_EQ(of_entity("style"), "e.svg: style: found an entity, allowed: what it stands for");
  EXPECT_EQ(of_entity("requiredExtensions"), "");  // as drawing programs write them
  std::string zigzag = "M0 0";
  for (int i = 0; i < 300'000; ++i) zigzag += "l1 1";
  EXPECT_NE(svg_refusal("<path d='" + zigzag + "z'/>").find("found more than 200000 points; allowed: 200000 or fewer"),
            std::string::npos);
}

std::string instance(const std::string& item) { return R"({"name": "a", "strip_height": 9, "items": [)" + item + "]}"; }

TEST(NestInstance, ReadsWhatSparrowReads) {
  const NestInput input =
      nest_instance(instance(R"({"id": 7, "demand": 3, "dxf": "x.dxf", "allowed_orientations": [0.0, 180.0],
                   "shape": {"type": "simple_polygon", "data": [[0,0],[3,0],[0,3],[0,0]]}},
                  {"id": 8, "demand": 1, "shape": {"type": "rectangle", "data": {"x_min": 0, "y_min": 0, "width": 4, "height": 2}}})"),
                    "a.json");
  EXPECT_EQ(input.strip_height, 9);
  ASSERT_EQ(input.sources.size(), 2u);
  EXPECT_EQ(input.sources[0].drawing.name, "7");
  EXPECT_EQ(input.sources[0].drawing.outline.size(), 3u);
  EXPECT_EQ(input.sources[0].demand, 3);
  EXPECT_EQ(input.sources[0].angles_deg, (std::vector<double>{0, 180}));
  EXPECT_EQ(area_of(input.sources[1].drawing.outline), 8);
  EXPECT_TRUE(input.sources[1].angles_deg.empty());
}

TEST(NestInstance, RefusesWhatIsOfNoUse) {
  const auto refused = [](const std::string& text) { return refusal([&] { nest_instance(text, "a.json"); }); };
  const auto of = [&](const std::string& shape) {
    return refused(instance(R"({"id": 0, "demand": 1, "shape": )" + shape + "}"));
  };
  EXPECT_EQ(refused("{"), "a.json: not a readable JSON file");
  EXPECT_EQ(refused("[]"), "a.json: has no \"items\"");
  EXPECT_EQ(refused(instance("3")), "a.json: item 0: found 3, allowed: an object");
  EXPECT_EQ(refused(instance("{}")), "a.json: item 0: has no \"shape\"");
  EXPECT_EQ(of(R"({"type": "blob", "data": []})"),
            "a.json: item 0: shape: type: found \"blob\", allowed: \"simple_polygon\", \"polygon\" or \"rectangle\"");
  EXPECT_EQ(of(R"({"type": "simple_polygon", "data": [[0,0],[1,0]]})"),
            "a.json: item 0: shape: found a contour of 2 points, allowed: 3 or more");
  EXPECT_EQ(of(R"({"type": "simple_polygon", "data": [[0,0],[1,null],[2,2]]})"),
            "a.json: item 0: shape: found null, allowed: a number from -1000000.0 to 1000000.0");
  EXPECT_EQ(of(R"({"type": "simple_polygon", "data": [[0,0],[1],[2,2]]})"),
            "a.json: item 0: shape: found a list, allowed: [x, y]");
  EXPECT_EQ(of(R"({"type": "simple_polygon", "data": [[0,0],[4,4],[4,0],[0,4]]})"),
            "a.json: item 0: shape: found a contour that crosses itself");
  EXPECT_NE(refused(instance(R"({"demand": 1e9, "shape": {"type": "simple_polygon", "data": [[0,0],[3,0],[0,3]]}})"))
                .find("demand: found"),
            std::string::npos);
  EXPECT_NE(refused(std::string(1'000'000, '[')).find("a.json: "), std::string::npos);
  const std::string triangle = R"("shape": {"type": "simple_polygon", "data": [[0,0],[3,0],[0,3]]})";
  EXPECT_EQ(refused(instance(R"({"demand": 2.7, )" + triangle + "}")),
            "a.json: item 0: demand: found 2.7, allowed: a whole number from 0 to 2000");
  EXPECT_EQ(refused(instance(R"({"demand": 2001, )" + triangle + "}")),
            "a.json: item 0: demand: found 2001, allowed: a whole number from 0 to 2000");
  EXPECT_EQ(refused(instance(R"({"demand": "two", )" + triangle + "}")),
            "a.json: item 0: demand: found \"two\", allowed: a whole number from 0 to 2000");
  EXPECT_EQ(nest_instance(instance(R"({"demand": 2.0, )" + triangle + "}"), "a.json").sources.at(0).demand, 2);
  EXPECT_EQ(of(R"({"type": "polygon", "data": {"outer": [[0,0],[9,0],[0,9]], "inner": 3}})"),
            "a.json: item 0: shape: inner: found 3, allowed: a list of contours");
}

const std::string kItems = R"("items": [{"id": 0, "shape": {"type": "simple_polygon", "data": [[0,0],[3,0],[0,3]]}}])";

std::string bin(const std::string& more = "", const std::string& type = "rectangle") {
  return R"({"id": 0, "cost": 9, "shape": {"type": ")" + type +
         R"(", "data": {"x_min": 5, "y_min": 5, "width": 100, "height": 60}})" + more + "}";
}

TEST(NestInstance, OneKindOfBinIsTheSheet) {
  const auto input = [](const std::string& bins) {
    return nest_instance(R"({"bins": )" + bins + ", " + kItems + "}", "a.json");
  };
  const NestInput found = input("[" + bin(R"(, "stock": 2, "zones": [])") + "]");
  ASSERT_TRUE(found.bin.has_value());
  EXPECT_EQ(found.bin->width, 100);
  EXPECT_EQ(found.bin->height, 60);
  EXPECT_EQ(found.bin->stock, 2);
  EXPECT_EQ(found.strip_height, 0);
  EXPECT_EQ(input("[" + bin() + "]").bin.value().stock, 0);
  EXPECT_FALSE(input("[]").bin.has_value());
  EXPECT_FALSE(input("null").bin.has_value());
}

TEST(NestInstance, WhatIsNotReadIsRefusedByName) {
  const auto refused = [](const std::string& material) {
    return refusal([&] { nest_instance("{" + material + ", " + kItems + "}", "a.json"); });
  };
  const auto bins = [&](const std::string& list) { return refused(R"("bins": )" + list); };
  const std::string one_kind = "; allowed: one kind, a rectangle without zones";
  EXPECT_EQ(bins("[" + bin() + "," + bin() + "]"),
            "a.json: bins: found 2 kinds of bins: sheets of several sizes or costs, which are not read" + one_kind);
  EXPECT_EQ(bins("[" + bin("", "simple_polygon") + "]"),
            "a.json: bins: shape: found \"simple_polygon\": a sheet of another shape, which is not read" + one_kind);
  EXPECT_EQ(bins("7"), "a.json: bins: found 7" + one_kind);
  EXPECT_EQ(bins("[7]"), "a.json: bins: has no \"shape\"");
  EXPECT_EQ(bins("[" + bin(R"(, "stock": 0)") + "]"),
            "a.json: bins: stock: found 0, allowed: a whole number from 1 to 1000000000");
  const std::string zones =
      "zones: found 1 zone: parts of the material with another quality, which are not read; "
      "allowed: no zones";
  EXPECT_EQ(bins("[" + bin(R"(, "zones": [{"quality": 0, "shape": {}}])") + "]"), "a.json: bins: " + zones);
  EXPECT_EQ(refused(R"("strip_height": 9, "zones": [{}])"), "a.json: " + zones);
  EXPECT_EQ(refused(R"("strip_height": 9, "bins": [)" + bin() + "]"),
            "a.json: strip_height and bins: allowed: one of them");
  const std::string triangle = R"("shape": {"type": "simple_polygon", "data": [[0,0],[3,0],[0,3]]})";
  const auto item = [&](const std::string& quality) {
    return refusal([&] { nest_instance(instance("{\"min_quality\": " + quality + ", " + triangle + "}"), "a.json"); });
  };
  EXPECT_EQ(
      item("5"),
      "a.json: item 0: min_quality: found 5: the piece may lie only where the material is that good, which is not "
      "read; allowed: no min_quality");
  EXPECT_EQ(item("null"), "");
}

TEST(NestInstance, OfTheOlderFormatAreRefusedByName) {
  const std::string old =
      ": an instance of an older format of jagua-rs (\"Objects\" are sheets), which is not read; "
      "allowed: \"items\", and \"strip_height\" or \"bins\", as sparrow and newer versions have them";
  const auto refused = [](const std::string& text) { return refusal([&] { nest_instance(text, "a.json"); }); };
  EXPECT_EQ(refused(R"({"Name": "a", "Items": [], "Objects": []})"), "a.json: found \"Items\", \"Objects\"" + old);
  EXPECT_EQ(refused(R"({"Strip": {"Height": 9}, )" + kItems + "}"), "a.json: found \"Strip\"" + old);
}

TEST(NestInstance, BoundsHostileOnes) {
  const auto refused = [](const std::string& text) { return refusal([&] { nest_instance(text, "a.json"); }); };
  const std::string deep = std::string(400'000, '[') + std::string(400'000, ']');
  EXPECT_EQ(refused(instance("[[[]]]")), "a.json: item 0: found a list, allowed: an object");
  const std::string too_deep =
      "a.json: found more than 32 levels of lists and objects in each other; allowed: 32 or fewer";
  EXPECT_EQ(refused(instance(deep)), too_deep);
  EXPECT_EQ(refused(instance(R"({"shape": {"type": "simple_polygon", "data": [[0,0],[3,0],[0,3]]}, "demand": [[]]})")),
            "a.json: item 0: demand: found a list, allowed: a whole number from 0 to 2000");
  std::string holes;
  for (int i = 0; i < 70'000; ++i) holes += std::string(i > 0 ? "," : "") + "[[1,1],[2,1],[1,2]]";
  EXPECT_EQ(refused(instance(R"({"shape": {"type": "polygon", "data": {"outer": [[0,0],[9,0],[0,9]], "inner": [)" +
                             holes + "]}}}")),
            "a.json: found more than 200000 points in a file; allowed: 200000 or fewer");
}

}  // namespace test_nest_input
}  // namespace tessera
