// Polygons of any GeoJSON as pieces: files of the program, of other programs, and invalid ones.
#include "result/polygon_pieces.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>

#include <cmath>

#include "core/geometry/winding.h"
#include "core/quality/quality.h"
#include "result/geojson_output.h"
#include "support/input_error.h"
#include "support/limited_child.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_polygon_pieces {

const Canvas& canvas() {
  static const Canvas made = make_rectangle_canvas(200, 100);
  return made;
}

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

std::string feature(const std::string& coordinates, const std::string& type = "Polygon",
                    const std::string& properties = "{}") {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":{"type":")" + type + R"(","coordinates":)" +
         coordinates + "}}";
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// The positions of a comb from `at` on: `count` teeth `apart_px` apart, from `low_px` to `high_px` below it. Two more close it.
std::string teeth(int count, double apart_px, double low_px, double high_px, Vec2 at = {}) {
  const auto position = [&](double x, double y) {
    return "[" + std::to_string(at.x + x) + "," + std::to_string(at.y + y) + "]";
  };
  std::string all = position(0, 0);
  for (int i = 0; i < count; ++i) {
    all += "," + position(i * apart_px, high_px) + "," + position((i + 0.5) * apart_px, low_px);
  }
  return all;
}

const std::string kSquare = "[[10,10],[30,10],[30,30],[10,30],[10,10]]";  // 20 px wide
const std::string kHole = "[[15,15],[25,15],[25,25],[15,25],[15,15]]";

class PolygonPieces : public testing::Test {
 protected:
  std::vector<JudgedPiece> pieces_in(const std::string& bytes) {
    return read_polygon_pieces(folder_.write("pieces.geojson", bytes), canvas());
  }

  /// The message after the file's name.
  std::string mistake(const std::string& bytes) {
    const std::string said = test::message_of([&] { pieces_in(bytes); });
    const std::string where = folder_.path("pieces.geojson") + ": ";
    EXPECT_EQ(said.substr(0, where.size()), where) << bytes.substr(0, 200);
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said.substr(std::min(said.size(), where.size()));
  }

  void expect_mistake(const std::string& of_the_second, const std::string& said) {
    const std::string found = mistake(collection(feature("[" + kSquare + "]") + "," + of_the_second));
    EXPECT_EQ(found.substr(0, said.size() + 11), "feature 1: " + said);
  }

  void expect_wrong_coordinates(const std::string& coordinates, const std::string& said) {
    expect_mistake(feature(coordinates), "geometry.coordinates: found " + said);
  }

  test::ScratchFolder folder_;
};

TEST_F(PolygonPieces, AreThoseOfAResult) {
  const test::SampleCollage sample;
  const auto shape = [&](ShapeId id) -> const Shape& { return sample.report.shape(id); };
  const std::vector<JudgedPiece> pieces = pieces_in(geojson_text(sample.report));
  const std::vector<JudgedPiece> laid = judged_pieces(sample.report.placements, shape);
  ASSERT_EQ(pieces.size(), laid.size());
  for (std::size_t i = 0; i < laid.size(); ++i) {
    EXPECT_EQ(pieces[i].shape, laid[i].shape);
    EXPECT_NEAR(pieces[i].scale_px, laid[i].scale_px, 0.02);
    EXPECT_NEAR(norm(pieces[i].centre_px - laid[i].centre_px), 0, 0.02);
    EXPECT_EQ(pieces[i].outline_px.curves.size(), laid[i].outline_px.curves.size());
  }
  const Quality ours = measure_quality(canvas(), laid), theirs = measure_quality(canvas(), pieces);
  EXPECT_NEAR(ours.coverage, theirs.coverage, 1e-4);
  EXPECT_NEAR(ours.shared_boundary, theirs.shared_boundary, 1e-3);
  EXPECT_NEAR(ours.between_px.value(), theirs.between_px.value(), 0.003);
}

TEST_F(PolygonPieces, MayRunEitherWayRound) {
  for (const std::string& hole : {kHole, std::string("[[15,15],[15,25],[25,25],[25,15],[15,15]]")}) {
    const JudgedPiece piece = pieces_in(collection(feature("[" + kSquare + "," + hole + "]"))).at(0);
    EXPECT_NEAR(piece.scale_px, std::sqrt(300.), 1e-4);
    EXPECT_GT(signed_area(piece.outline_px.curves[0]), 0);
    EXPECT_LT(signed_area(piece.outline_px.curves[1]), 0);
  }
}

TEST_F(PolygonPieces, OfSeveralPolygonsAreOne) {
  const std::string two = "[[" + kSquare + "],[[[50,10],[70,10],[70,30],[50,30],[50,10]]]]";
  const std::vector<JudgedPiece> pieces = pieces_in(collection(feature(two, "MultiPolygon", R"({"shape":"two"})")));
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].shape, "two");
  EXPECT_EQ(pieces[0].centre_px, (Vec2{40, 20}));
  EXPECT_NEAR(pieces[0].scale_px, std::sqrt(800.), 1e-4);
  EXPECT_NEAR(measure_quality(canvas(), pieces).coverage, 800 / 20000., 1e-6);
}

TEST_F(PolygonPieces, AnIslandInAHoleIsPartOfThem) {
  const std::string island = "[[[18,18],[22,18],[22,22],[18,22],[18,18]]]";
  const auto pieces =
      pieces_in(collection(feature("[[" + kSquare + "," + kHole + "]," + island + "]", "MultiPolygon")));
  EXPECT_NEAR(pieces.at(0).scale_px, std::sqrt(316.), 1e-4);
}

TEST_F(PolygonPieces, WhatElseAFileHoldsDoesNotMatter) {
  const std::string geometry =
      R"({"coordinates":[[[10,10,7],[30,10,7],[30,30],[10,10]]],"bbox":[1,2],"type":"Polygon"})";
  const std::string bytes =
      R"({"features":[{"geometry":)" + geometry +
      R"(,"id":7,"properties":{"shape":null,"features":[{"a":[[]]}],"b":{"shape":3}}}],"crs":{}})";
  const std::vector<JudgedPiece> pieces = pieces_in(bytes);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].shape, "");
  EXPECT_TRUE(pieces_in(collection("")).empty());
}

TEST_F(PolygonPieces, TinyLoopsOfAnOutlineArePassedOver) {
  EXPECT_EQ(
      pieces_in(collection(feature("[[[0,0],[40,0],[40,40],[40.2,40.2],[40,40.2],[40.2,40],[0,40],[0,0]]]"))).size(),
      1u);
}

TEST_F(PolygonPieces, MistakesNameTheFeatureTheKeyAndWhatIsAllowed) {
  expect_mistake("7", "the feature: found 7, allowed: an object");
  expect_mistake("[]", "the feature: found a list, allowed: an object");
  expect_mistake("{}", "geometry.type: found nothing, allowed: \"Polygon\" or \"MultiPolygon\"");
  expect_mistake(R"({"geometry":null})", "geometry.type: found nothing");
  expect_mistake(feature("[1,2]", "Point"), "geometry.type: found \"Point\", allowed: \"Polygon\" or \"MultiPolygon\"");
  expect_mistake(R"({"geometry":{"type":"Polygon"}})", "geometry.coordinates: found nothing, allowed: a list of rings");
  expect_mistake(feature("[" + kSquare + "]", "Polygon", R"({"shape":7})"), "shape: found 7, allowed: a text");
  expect_mistake(feature("[" + kSquare + "]", "Polygon", R"({"shape":["cat"]})"), "shape: found a list, allowed");
  expect_mistake(feature("[" + kSquare + "]", "Polygon", R"({"shape":{"name":"cat"}})"), "shape: found an object");
  expect_wrong_coordinates("7", "7, allowed: a list of rings");
  expect_wrong_coordinates("[]", "an empty list");
  expect_wrong_coordinates("[[]]", "an empty list");
  expect_wrong_coordinates("[[[]]]", "an empty list");
  expect_wrong_coordinates("[" + kSquare + ",[]]", "an empty list");
  expect_wrong_coordinates("[[[1]]]", "a position of one number, allowed: [x, y]");
  expect_wrong_coordinates("[[[1,[2]]]]", "a list within a position");
  expect_wrong_coordinates("[[[1,2],3]]", "3 beside lists");
  expect_wrong_coordinates("[[[1,\"2\"]]]", "\"2\", allowed: numbers and lists");
  expect_wrong_coordinates("[[[1,null]]]", "null, allowed: numbers and lists");
  expect_wrong_coordinates("[[{}]]", "an object, allowed: numbers and lists");
  expect_wrong_coordinates(kSquare, "positions 2 lists deep, allowed: 3 of a Polygon");
  expect_mistake(feature("[" + kSquare + "]", "MultiPolygon"),
                 "geometry.coordinates: found positions 3 lists deep, allowed: 4 of a MultiPolygon");
}

TEST_F(PolygonPieces, RingsAreClosedAndEncloseSomething) {
  expect_wrong_coordinates("[[[10,10],[30,10],[10,10]]]", "a ring of 3 positions, allowed: 4 or more");
  expect_wrong_coordinates(
      "[[[10,10],[30,10],[30,30],[10,30]]]",
      "a ring that is open, from [10.000, 10.000] to [10.000, 30.000], allowed: the last position");
  expect_wrong_coordinates("[[[10,10],[30,10],[50,10],[10,10]]]", "rings that enclose 0.000000 square px");
  expect_wrong_coordinates("[" + kSquare + "," + kSquare + "]", "rings that enclose 0.000000 square px");
}

TEST_F(PolygonPieces, RingsAreSimple) {
  expect_wrong_coordinates("[[[10,10],[30,30],[30,10],[10,40],[10,10]]]", "rings that cross themselves");
  expect_wrong_coordinates("[" + kSquare + ",[[20,20],[40,20],[40,25],[20,25],[20,20]]]", "rings that cross");
  expect_wrong_coordinates("[" + kSquare + ",[[50,50],[60,50],[60,60],[50,60],[50,50]]]", "rings that cross");
  expect_mistake(feature("[[" + kSquare + "],[" + kHole + "]]", "MultiPolygon"),
                 "geometry.coordinates: found rings that cross");
}

TEST_F(PolygonPieces, NumbersAreWithinReason) {
  expect_wrong_coordinates("[[[1e308,2]]]", "1e+308, allowed: px from -20000 to 40000");
  expect_wrong_coordinates("[[[1,-20001]]]", "-20001, allowed: px from");
  expect_wrong_coordinates("[[[301,0],[310,0],[310,10],[301,0]]]",
                           "a piece from [301.000, 0.000] to [310.000, 10.000], far from the canvas of 200 x 100 px, "
                           "allowed: up to half of its width");
  expect_wrong_coordinates("[[[0,-90],[9,-90],[9,-51],[0,-90]]]", "a piece from [0.000, -90.000]");
  EXPECT_EQ(pieces_in(collection(feature("[[[0,0],[301,0],[301,10],[0,0]]]"))).size(), 1u) << "a part is near";
  for (const char* number : {"NaN", "Infinity", "1e999", "-", "0x10"}) {
    EXPECT_EQ(mistake(collection(feature(std::string("[[[") + number + ",2]]]"))).substr(0, 19), "feature 0: no JSON:")
        << number;
  }
}

TEST_F(PolygonPieces, OfASeamlessCanvasAreTakenFromAnyPeriod) {
  Canvas seamless = canvas();
  seamless.period = {200, 100};
  // The piece is 340 px long and 10 high. Its centre lies in the period itself, one before it, or three after it.
  for (const int x : {-160, -360, 440}) {
    const std::string from = std::to_string(x), to = std::to_string(x + 340);
    const std::string ring = "[[" + from + ",20],[" + to + ",20],[" + to + ",30],[" + from + ",30],[" + from + ",20]]";
    const std::string path = folder_.write("pieces.geojson", collection(feature("[" + ring + "]")));
    const std::vector<JudgedPiece> pieces = read_polygon_pieces(path, seamless);
    ASSERT_EQ(pieces.size(), 1u) << x;
    EXPECT_NEAR(norm(pieces[0].centre_px - Vec2{10, 25}), 0, 1e-3) << x;
    EXPECT_EQ(bounding_box(pieces[0].outline_px.curves[0]).low, (Vec2{-160, 20})) << x;
    EXPECT_NEAR(measure_quality(seamless, pieces).coverage, 0.1, 1e-6) << x;
  }
}

TEST_F(PolygonPieces, AFarPartTakesNoMemory) {
  const std::string bytes = collection(feature("[[[10,10],[39990,39980],[39990,39990],[10,10]]]") + "," +
                                       feature("[[[10,10],[-19990,-19980],[-19990,-19990],[10,10]]]"));
  const test::ChildReport report =
      test::in_child([&] { return std::to_string(measure_quality(canvas(), pieces_in(bytes)).pieces); });
  test::expect_survived(report, "two needles");
  EXPECT_EQ(report.said, "2");
}

TEST_F(PolygonPieces, WhatIsNoCollectionIsAMistake) {
  EXPECT_EQ(mistake("").substr(0, 8), "no JSON:");
  EXPECT_EQ(mistake("{\"features\":[").substr(0, 19), "feature 0: no JSON:");
  EXPECT_EQ(mistake(collection("") + "x").substr(0, 8), "no JSON:");
  EXPECT_EQ(mistake("\xff\xfe{}").substr(0, 8), "no JSON:");
  EXPECT_EQ(mistake("7"), "the file: found 7, allowed: a FeatureCollection");
  EXPECT_EQ(mistake("[]"), "the file: found a list, allowed: a FeatureCollection");
  EXPECT_EQ(mistake("{}").substr(0, 24), "features: found nothing,");
  EXPECT_EQ(mistake("{\"features\":7}").substr(0, 18), "features: found 7,");
  EXPECT_EQ(mistake("{\"features\":{}}").substr(0, 23), "features: found nothing");
  EXPECT_EQ(mistake(R"({"type":"Feature"})"), "type: found \"Feature\", allowed: \"FeatureCollection\"");
}

TEST_F(PolygonPieces, WhatIsNoFileIsAMistake) {
  const auto message = [&](const std::string& path) {
    return test::message_of([&] { read_polygon_pieces(path, canvas()); });
  };
  EXPECT_NE(message(folder_.path("none")).find("none: not a readable file"), std::string::npos);
  EXPECT_NE(message(folder_.path("")).find("found a folder"), std::string::npos);
  ASSERT_EQ(::mkfifo(folder_.path("pipe").c_str(), 0600), 0);
  EXPECT_NE(message(folder_.path("pipe")).find("found a pipe"), std::string::npos);
}

TEST_F(PolygonPieces, FilesThatWouldEatTheMachineAreRefused) {
  const std::string open_features = R"({"features":[)";
  const std::string open_ring = open_features + R"({"geometry":{"type":"Polygon","coordinates":[[)";
  // The teeth are 0.01 px wide and 98 px high, in the box of one piece.
  const std::string comb = feature("[[" + teeth(9'000, 0.01, 1, 99) + ",[99,0],[0,0]]]");
  const std::string dense = feature("[[" + teeth(2'000, 0.001, 1.95, 2) + ",[2,0],[0,0]]]");
  const std::string long_comb = feature("[[" + teeth(90, 1, 1, 99) + ",[99,0],[0,0]]]");
  const std::vector<std::pair<std::string, std::string>> files = {
      {repeated("[", 1'000'000), "the file: found a list"},
      {repeated("{\"a\":", 1'000'000), "more than 32 levels deep"},
      {open_features + repeated("[", 1'000'000), "the feature: found a list"},
      {open_ring + repeated("[", 1'000'000), "more than 32 levels deep"},
      {open_ring + repeated("[1,2],", 3'000'000),
       "found more than 20000 positions of a piece; allowed: 20000 or fewer"},
      {open_ring + repeated("1,", 3'000'000), "no JSON"},
      {open_features + repeated("{\"geometry\":{},", 500'000), "no JSON"},
      {collection(comb), "px of boundary in a box of 99.0 x 99.0 px, allowed: up to 100 times its width and height"},
      {collection(dense), "4002 positions in a box of 2.0 x 2.0 px, allowed: 1000, and 100 for each px"},
      {collection(repeated(long_comb + ",", 500) + long_comb),
       "more than 8000000 px of boundary up to here, of all pieces; allowed: 8000000 or fewer"}};
  for (const auto& [bytes, word] : files) {
    const test::ChildReport report = test::in_child([&] { return mistake(bytes); });
    test::expect_survived(report, bytes.substr(0, 60));
    EXPECT_NE(report.said.find(word), std::string::npos) << bytes.substr(0, 60) << ": " << report.said;
  }
}

TEST_F(PolygonPieces, DenseFilesWithinTheLimitsAreMeasuredInSeconds) {
  const std::string long_comb = feature("[[" + teeth(90, 1, 1, 99) + ",[99,0],[0,0]]]");
  std::string small_combs;  // each is 1.9 px from four others
  for (int i = 0; i < 1'250; ++i) {
    const double x = i % 50 * 3.9, y = i / 50 * 3.9;
    const std::string end = ",[" + std::to_string(x + 2) + "," + std::to_string(y) + "],";
    const std::string ring = teeth(690, 0.0029, 1.75, 2, {float(x), float(y)});
    small_combs += (i ? "," : "") + feature("[[" + ring + end + ring.substr(0, ring.find("]") + 1) + "]]");
  }
  for (const std::string& features : {repeated(long_comb + ",", 100) + long_comb, small_combs}) {
    const test::ChildReport report = test::in_child(
        [&] { return std::to_string(measure_quality(canvas(), pieces_in(collection(features))).pieces); });
    test::expect_survived(report, features.substr(0, 60));
    EXPECT_NE(report.said, "") << features.substr(0, 60);
  }
}

TEST(TwistedArea, IsThatOfLoops) {
  const std::vector<Vec2> square = {{0, 0}, {40, 0}, {40, 40}, {0, 40}};
  EXPECT_EQ(twisted_area({{square}}), 0);
  EXPECT_NEAR(twisted_area({{test::reversed(square)}}), 1600, 1e-6) << "backwards";
  EXPECT_NEAR(twisted_area({{{{0, 0}, {40, 40}, {40, 0}, {0, 40}}}}), 400, 20) << "an eight";
  EXPECT_NEAR(twisted_area({{square, square}}), 1600, 1e-6) << "twice";
  EXPECT_EQ(twisted_area({{{{3, 3}, {3, 3}, {3, 3}}}}), 0) << "a point";
}

RC_GTEST_PROP(TwistedArea, IsNoneOfSimpleOutlines, ()) {
  Outline outline = test::blob_outline(*rc::gen::arbitrary<std::uint32_t>());
  outline.curves.push_back(test::reversed(outline.curves[0]));
  for (Vec2& p : outline.curves[1]) p = p * 0.5f;
  const float angle = float(*rc::gen::inRange(0, 628)) * 0.01f;
  const float scale = float(*rc::gen::inRange(1, 400));
  const Similarity t{scale * std::cos(angle), scale * std::sin(angle), 1000, -500};
  for (auto& curve : outline.curves) {
    for (Vec2& p : curve) p = t.apply(p);
  }
  // Positions far from the origin are rounded to 0.0001 px.
  RC_ASSERT(twisted_area(outline) < 1e-4 * scale * scale + 1e-3 * scale);
}

}  // namespace test_polygon_pieces
}  // namespace tessera
