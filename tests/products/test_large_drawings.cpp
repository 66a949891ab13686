// Drawings and instances that would need too much time or memory. Each is refused within seconds and 512 MiB, with its name and the
// excessive part.
#include <gtest/gtest.h>

#include <filesystem>

#include "products/nesting/nest_input.h"
#include "support/large_file.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_large_drawings {

/// The message when a drawer reaches its own limit.
const std::string kTooLarge = "needs more than 512 MiB of memory";
const std::string kSvg = "<svg xmlns='http://www.w3.org/2000/svg'>";

class LargeDrawings : public testing::Test {
 protected:
  void expect_refused(const std::string& name, const test::LargeText& text, const std::string& said) {
    const std::string path = folder_.path(name);
    if (name.ends_with(".svgz"))
      text.write_packed(path);
    else
      text.write(path);
    test::expect_refused(path, said, [&] { read_nest_input(path); });
    std::filesystem::remove(path);
  }

  test::ScratchFolder folder_;
};

TEST_F(LargeDrawings, AreRefusedOfManyElements) {
  expect_refused("empty.svgz", {kSvg, "<g/>", 16'000'000, "</svg>"}, kTooLarge);
  expect_refused("texts.svgz", {kSvg, "<g/>x", 12'000'000, "</svg>"}, kTooLarge);
  expect_refused("dots.svg", {kSvg, "<path d='M0 0z'/>", 3'900'000, "</svg>"}, kTooLarge);
  expect_refused("endless.svgz", {kSvg, " ", 100'000'000, "</svg>"}, "found more than 64 MiB when decompressed");
  expect_refused("deep.svgz", {kSvg, "<g>", 10'000'000, "</svg>"},
                 "not a readable SVG file: line 1: Excessive depth in document: 256");
  expect_refused("comments.svgz", {kSvg, "<!---->", 9'000'000, "</svg>"}, kTooLarge);
  expect_refused("instructions.svgz", {kSvg, "<?a?>", 12'000'000, "</svg>"}, kTooLarge);
  expect_refused("blanks.svgz", {kSvg, "<g/>                    ", 90'000, "</svg>"}, "found no closed shape");
}

TEST_F(LargeDrawings, AreRefusedOfManyAttributes) {
  std::string names, name_spaces;
  for (int i = 0; i < 2'900; ++i) names += " a" + std::to_string(i) + "=''";
  for (int i = 0; i < 900; ++i) name_spaces += " xmlns:a" + std::to_string(i) + "='u" + std::to_string(i) + "'";
  expect_refused("attributes.svg", {kSvg + "<g", " a=''", 1'000'000, "/></svg>"},
                 "not a readable SVG file: line 1: Attribute a redefined");
  expect_refused("wide.svgz", {kSvg, "<g" + names + "/>", 1'500, "</svg>"}, "wide.svgz: ");
  expect_refused("spaces.svgz", {kSvg, "<g" + name_spaces + ">", 250, "</svg>"}, "not a readable SVG file");
  expect_refused("long.svg", {kSvg + "<path d='", "9", 50'000'000, "'/></svg>"}, "not a readable SVG file");
  expect_refused("text.svg", {kSvg, "x", 50'000'000, "</svg>"}, "found no closed shape");
  expect_refused("name.svg",
                 {kSvg + "<path id='" + std::string(2'000'000, 'n') + "' d='", "M0 0h9v9z", 3'000, "'/></svg>"},
                 "id: found a name of 2000000 bytes, \"nnnnnnnnnnnnnnnnnnnn...\", allowed: 1000");
}

/// libxml2 refuses documents of more than 10 MB that end right after a long tag.
TEST_F(LargeDrawings, AreReadToTheirLastByte) {
  const std::string arcs = "a1 1 0 1 1 2 0 ";
  std::string path = "<path id='a' d='M0 0 ";
  for (int i = 0; i < 100'000; ++i) path += arcs;
  path += "z'/>";
  for (const char* name : {"arcs.svg", "arcs.svgz"})
    expect_refused(name, {kSvg, path, 12, "</svg>"}, ": found more than 64 MiB of paths");
}

TEST_F(LargeDrawings, AreRefusedOfManyNumbers) {
  expect_refused("line.svg", {kSvg + "<path d='M0 0", " 1 1", 1'000'000, "'/></svg>"}, "found no closed shape");
  expect_refused("starts.svg", {kSvg + "<path d='", "M0 0", 2'000'000, "'/></svg>"}, "found no closed shape");
  expect_refused("arcs.svg", {kSvg + "<path d='M0 0", "a9e8 9e8 0 1 1 1e8 0", 400'000, "'/></svg>"}, kTooLarge);
  expect_refused("points.svg", {kSvg + "<polygon points='", "1 2 ", 1'000'000, "'/></svg>"}, "found no closed shape");
  expect_refused("turns.svg", {kSvg + "<g transform='rotate(", "1 ", 1'000'000, ")'/></svg>"}, "found no closed shape");
  expect_refused("exponent.svg", {kSvg + "<path d='M1e", "9", 1'000'000, " 0h9'/></svg>"}, "found no closed shape");
}

TEST_F(LargeDrawings, AreRefusedOfDeclarationsAndEncodings) {
  std::string defaults;
  for (int i = 0; i < 900; ++i) defaults += "<!ATTLIST g a" + std::to_string(i) + " CDATA 'x'>";
  expect_refused("defaults.svgz", {"<!DOCTYPE svg [" + defaults + "]>" + kSvg, "<g/>", 90'000, "</svg>"},
                 "defaults.svgz: ");
  expect_refused("declared.svgz", {"<!DOCTYPE svg [", "<!ATTLIST g a CDATA 'x'>", 2'000'000, "]>" + kSvg + "</svg>"},
                 "found no closed shape");
  expect_refused("entities.svgz", {"<!DOCTYPE svg [", "<!ENTITY a 'x'>", 4'000'000, "]>" + kSvg + "</svg>"},
                 "found no closed shape");
  expect_refused("elements.svgz", {"<!DOCTYPE svg [", "<!ELEMENT a ANY>", 4'000'000, "]>" + kSvg + "</svg>"},
                 "found no closed shape");
  std::string laughs = "<!DOCTYPE svg [<!ENTITY a '<g/><g/><g/><g/>'>";
  for (char c = 'b'; c < 'z'; ++c) {
    laughs += std::string("<!ENTITY ") + c + " '";
    for (int i = 0; i < 30; ++i) laughs += std::string("&") + char(c - 1) + ";";
    laughs += "'>";
  }
  expect_refused("laughs.svg", {laughs + "]>" + kSvg, "&y;", 1, "</svg>"}, "laughs.svg: ");
  expect_refused("utf7.svg", {"<?xml version='1.0' encoding='UTF-7'?>", "+ADw-svg+AD4-", 1, ""},
                 "not a readable SVG file");
  expect_refused("ebcdic.svg", {"<?xml version='1.0' encoding='IBM037'?>" + kSvg, "", 0, "</svg>"},
                 "not a readable SVG file");
  expect_refused("utf16.svg", {std::string("\xff\xfe<\0s\0v\0g\0/\0>\0", 14), "", 0, ""}, "found no closed shape");
  expect_refused("html.svg", {"<html xmlns='http://www.w3.org/1999/xhtml'>", "<p/>", 9, "</html>"}, "not an SVG file");
}

TEST_F(LargeDrawings, AreReadWithinTheBounds) {
  const std::string path = folder_.path("full.svgz");
  const test::LargeText full{"<?xml version='1.0' encoding='ISO-8859-1'?><!DOCTYPE svg [<!ENTITY n 'a'>]>" + kSvg +
                                 "<path id='\xfc' d='M0 0h9v9z'/>",
                             "<g a='' b='' c='' style='fill:none'/>  text  <!-- -->", 99'000, "</svg>"};
  full.write_packed(path);
  test::expect_refused(path, "", [&] {
    if (read_nest_input(path).sources.at(0).drawing.name != "\u00fc") throw InputError("another name");
  });
}

/// In the first file each contour lies in the boxes of many others, but inside none. In the second, contours are nested.
TEST_F(LargeDrawings, OfManyContoursInEachOtherAreSortedInSeconds) {
  std::string frames = kSvg, nested = kSvg;
  for (int i = 0; i < 2'000; ++i) {
    const std::string x = std::to_string(i * 0.01), far = std::to_string(5000 - i * 0.01);
    frames += "<path d='M" + x + " " + x + "V" + far + "H" + far;
    for (int step = 0; step < 40; ++step) frames += "l-1 -.0" + std::to_string(step + 10);
    frames += "z'/><path d='M4000 " + std::to_string(1 + i * 0.5) + "h.2v.2z'/>";
    nested += "<path d='M" + x + " " + x + "V" + far + "H" + far + "V" + x + "z'/>";
  }
  for (const std::string& text : {frames, nested}) {
    const std::string path = folder_.write("contours.svg", text + "</svg>");
    test::expect_refused(path, "contours.svg",
                         [&] { throw InputError(path + ": " + std::to_string(read_nest_input(path).sources.size())); });
  }
}

TEST_F(LargeDrawings, InDxfAreRefused) {
  const std::string begin = "0\nSECTION\n2\nENTITIES\n";
  const std::string points = "found more than 200000 points in a file; allowed: 200000 or fewer";
  expect_refused("bulges.dxf", {begin + "0\nLWPOLYLINE\n", "10\n0\n20\n0\n42\n1\n10\n1e5\n20\n0\n42\n1\n", 90'000, ""},
                 points);
  expect_refused("vertices.dxf", {begin + "0\nLWPOLYLINE\n", "10\n0\n", 9'000'000, ""}, points);
  expect_refused("polyline.dxf", {begin + "0\nPOLYLINE\n", "0\nVERTEX\n", 4'000'000, ""}, points);
  expect_refused("lines.dxf", {begin, "0\nLINE\n11\n9\n", 4'000'000, ""}, points);
  expect_refused("circles.dxf", {begin, "0\nCIRCLE\n40\n9e9\n", 3'000'000, ""}, points);
  expect_refused("number.dxf", {begin + "0\nCIRCLE\n40\n", "9", 60'000'000, "\n"}, "allowed: a number");
  expect_refused("exponent.dxf", {begin + "0\nCIRCLE\n40\n1e", "9", 1'000, "\n"}, "allowed: a number");
  expect_refused("code.dxf", {begin, "9", 60'000'000, "\n"}, "allowed: the number of a group code");
  expect_refused("empty.dxf", {begin, "\n", 60'000'000, ""}, "allowed: the number of a group code");
  expect_refused("texts.dxf", {begin, "0\nTEXT\n", 8'000'000, ""}, "found no closed shape");
}

TEST_F(LargeDrawings, OfDxfBlocksAndLayersAreRefused) {
  const std::string entities = "0\nSECTION\n2\nENTITIES\n", blocks = "0\nSECTION\n2\nBLOCKS\n";
  const std::string points = "found more than 200000 points in a file; allowed: 200000 or fewer";
  std::string layers;
  for (int i = 0; i < 400'000; ++i) layers += "0\nLAYER\n2\n" + std::to_string(i) + "\n62\n-7\n";
  expect_refused("layers.dxf", {"0\nSECTION\n2\nTABLES\n" + layers, "", 0, ""},
                 "found more than 100000 layers; allowed: 100000 or fewer");
  std::string names;
  for (int i = 0; i < 400'000; ++i) names += "0\nBLOCK\n2\n" + std::to_string(i) + "\n";
  expect_refused("blocks.dxf", {blocks + names, "", 0, ""}, "found more than 100000 blocks; allowed: 100000 or fewer");
  expect_refused("inserts.dxf", {entities, "0\nINSERT\n2\nA\n", 3'000'000, ""}, points);
  expect_refused("knots.dxf", {entities + "0\nSPLINE\n", "40\n1\n", 9'000'000, ""}, points);
  expect_refused("weights.dxf", {entities + "0\nSPLINE\n", "41\n1\n", 9'000'000, ""}, points);
  expect_refused("controls.dxf", {entities + "0\nSPLINE\n", "10\n1\n", 9'000'000, ""}, points);
  expect_refused("kinds.dxf", {blocks, "0\nBLOCK\n2\nA\n0\nA\n0\nB\n0\nC\n", 1'500'000, ""}, "found no closed shape");
  // Short lines on layers with long names, and splines of many control points but little length. Both are drawn very often.
  const std::string often = "0\nENDBLK\n0\nENDSEC\n" + entities + "0\nINSERT\n2\nB\n70\n30000\n71\n30000\n";
  expect_refused(
      "names.dxf",
      {"0\nSECTION\n2\nTABLES\n0\nLAYER\n2\nX\n62\n-1\n0\nENDSEC\n" + blocks + "0\nBLOCK\n2\nB\n0\nLINE\n8\n", "n",
       50'000'000, "\n11\n9\n" + often},
      "found more than 200000 entities in its blocks");
  expect_refused("splines.dxf",
                 {blocks + "0\nBLOCK\n2\nB\n0\nSPLINE\n71\n1\n40\n0\n40\n0\n", "10\n1\n40\n1\n", 150'000, often},
                 points);
  // A spline of the highest degree that is never flat.
  expect_refused("degrees.dxf",
                 {entities + "0\nSPLINE\n71\n25\n", "10\n1e9\n40\n1\n10\n-1e9\n20\n1e9\n40\n1\n", 90'000, ""},
                 "found no closed shape");
  std::string curve;
  for (int i = 0; i < 90'026; ++i) curve += "40\n" + std::to_string(i) + "\n";
  expect_refused("bends.dxf",
                 {entities + "0\nSPLINE\n71\n25\n" + curve, "10\n1e9\n20\n0\n10\n-1e9\n20\n1e9\n", 45'000, ""}, points);
}

TEST_F(LargeDrawings, InInstancesAreRefused) {
  const std::string begin = R"({"strip_height": 9, "items": [)";
  const std::string ring = begin + R"({"shape": {"type": "simple_polygon", "data": [)";
  const std::string values = "found more than 1000000 values; allowed: 1000000 or fewer";
  expect_refused("lists.json", {begin, "[],", 20'000'000, "[]]}"}, values);
  expect_refused("objects.json", {begin, "{},", 20'000'000, "{}]}"}, values);
  expect_refused("members.json", {R"({"a": {)", "\"a\":{},", 9'000'000, "\"b\":1}}"}, values);
  expect_refused("points.json", {ring, "[1,2],", 10'000'000, "[1,2]]}}]}"}, values);
  expect_refused("ring.json", {ring, "[1,2],", 300'000, "[1,2]]}}]}"},
                 "found 300001 points, allowed: a list of points");
  expect_refused("deep.json", {"", "[", 60'000'000, ""},
                 "found more than 32 levels of lists and objects in each other");
  expect_refused("deeper.json", {"", "{\"a\":", 12'000'000, ""}, "found more than 32 levels");
  expect_refused("text.json", {"{\"name\": \"", "x", 60'000'000, "\"}"},
                 "found more than 1048576 bytes in a text or number");
  expect_refused("escapes.json", {"{\"name\": \"", "\\\"", 30'000'000, "\"}"},
                 "found more than 1048576 bytes in a text or number");
  expect_refused("number.json", {"{\"name\": ", "9", 60'000'000, "}"},
                 "found more than 1048576 bytes in a text or number");
  expect_refused("exponent.json", {"{\"strip_height\": 1e", "9", 1'000, "}"}, "not a readable JSON file");
  expect_refused(
      "name.json",
      {begin + "{\"id\": \"", "x", 2'000, R"(", "shape": {"type": "rectangle", "data": {"width": 1, "height": 1}}}]})"},
      "id: found a name of 2000 bytes");
  expect_refused("blanks.json", {"{", " ", 60'000'000, "}"}, "has no \"items\"");
  expect_refused("large.json", {"{", " ", 70'000'000, "}"}, "67 MiB, more than the 64 MiB allowed");
}

TEST_F(LargeDrawings, InFoldersAreCounted) {
  const std::string path = folder_.path("parts");
  std::filesystem::create_directory(path);
  for (int file = 0; file < 30; ++file) {
    test::LargeText{kSvg + "<path d='M0 0", " h1v1", 4, "H0z"}.write(path + "/" + std::to_string(file) + ".svg");
    std::ofstream out(path + "/" + std::to_string(file) + ".svg");
    out << kSvg;
    for (int ring = 0; ring < 40; ++ring) {
      out << "<path d='M0 " << ring * 3;
      for (int i = 0; i < 2'000; ++i) out << "h.01v.0001";
      out << "V" << ring * 3 + 2 << "H0z'/>";
    }
    out << "</svg>";
  }
  test::expect_refused(path, "found more than 2000000 points in its files; allowed: 2000000 or fewer",
                       [&] { read_nest_input(path); });
}

}  // namespace test_large_drawings
}  // namespace tessera
