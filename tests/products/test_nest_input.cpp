// Instances of foreign origin as the input of nest. For SVGs and DXFs see test_svg_drawings.cpp and test_dxf_drawings.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "products/nesting/nest_input.h"
#include "products/nesting/nest_instance.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_nest_input {

std::string refusal(const std::function<void()>& f) {
  try {
    f();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
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
  EXPECT_EQ(std::abs(signed_area(input.sources[1].drawing.outline)), 8);
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

/// A DXF with a closed polyline through these points.
std::string dxf(const std::vector<std::pair<int, int>>& points) {
  std::string text = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n90\n" + std::to_string(points.size()) + "\n70\n1\n";
  for (const auto& [x, y] : points) text += "10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n";
  return text + "0\nENDSEC\n0\nEOF\n";
}

TEST(NestInput, AllFilesOfAFolderThatCannotBeUsedAreToldAtOnce) {
  const test::ScratchFolder folder;
  folder.write("b.dxf", dxf({{0, 0}, {9, 0}, {0, 9}}));
  folder.write("readme.txt", "no drawing");
  const std::string path = folder.path(".");
  const NestInput input = read_nest_input(path);
  EXPECT_EQ(input.sources.size(), 1u);
  ASSERT_FALSE(input.notes.empty());
  EXPECT_NE(input.notes[0].find("left out 1 file that is neither SVG nor DXF: readme.txt"), std::string::npos);

  folder.write("a.dxf", dxf({{0, 0}, {9, 9}, {9, 0}, {0, 9}}));
  const std::string alone = refusal([&] { read_nest_input(path); });
  EXPECT_NE(alone.find("a.dxf: "), std::string::npos);
  EXPECT_EQ(alone.find("more file"), std::string::npos);
  folder.write("c.dxf", "AutoCAD Binary DXF\r\n");
  folder.write("d.dxf", "no DXF");
  const std::string all = refusal([&] { read_nest_input(path); });
  EXPECT_EQ(all, alone + "; 2 more files cannot be used: c.dxf, d.dxf");
}

}  // namespace test_nest_input
}  // namespace tessera
