// pieces.geojson: the properties that other programs rely on.
#include <gtest/gtest.h>

#include <clocale>
#include <nlohmann/json.hpp>

#include "result/geojson_output.h"
#include "support/sample_collage.h"
#include "text/number_text.h"
#include "text/pose.h"

namespace tessera {
namespace test_geojson {

using nlohmann::json;

double ring_area(const json& ring) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    sum += ring[i][0].get<double>() * ring[i + 1][1].get<double>() -
           ring[i + 1][0].get<double>() * ring[i][1].get<double>();
  }
  return sum / 2;
}

TEST(Pose, IsOfSizeDegreesAndPlace) {
  const Similarity pose = pose_of(300, 120, 100, -5);
  EXPECT_FLOAT_EQ(pose.scale(), 300);
  EXPECT_NEAR(rotation_deg(pose), 120, 1e-4);
  EXPECT_EQ(pose.translation(), (Vec2{100, -5}));
  EXPECT_FLOAT_EQ(pose_of(2, 90, 0, 0).apply({1, 0}).y, 2) << "clockwise on the picture";
}

TEST(GeoJson, OneFeatureAPlacementWithItsProperties) {
  const test::SampleCollage sample;
  const json collection = json::parse(geojson_text(sample.report));
  EXPECT_EQ(collection["type"], "FeatureCollection");
  ASSERT_EQ(collection["features"].size(), 2u);
  const json& feature = collection["features"][0];
  EXPECT_EQ(feature["type"], "Feature");
  const json& properties = feature["properties"];
  EXPECT_EQ(properties["index"], 0);
  EXPECT_EQ(properties["shape"], "disc");
  EXPECT_EQ(properties["source"], "");
  EXPECT_NEAR(properties["scale"].get<double>(), 40, 1e-3);
  EXPECT_NEAR(properties["rotation_deg"].get<double>(), 28.648, 1e-3);
  EXPECT_EQ(properties["x_px"], 50.0);
  EXPECT_EQ(properties["y_px"], 50.0);
  EXPECT_EQ(properties["mirrored"], false);
  EXPECT_EQ(properties["score"], 0.75);
  EXPECT_EQ(properties["matched_px"], 12.5);
  const Similarity& pose = sample.report.placements[0].canvas_from_shape;
  const json& exact = properties["canvas_from_shape"];
  ASSERT_EQ(exact.size(), 4u);
  EXPECT_EQ((Similarity{exact[0], exact[1], exact[2], exact[3]}), pose) << "to the last bit";
}

TEST(GeoJson, SaysWhichPiecesAreMirroredAndWhichGroupTheyAreOf) {
  test::SampleCollage sample;
  sample.report.shapes[1].artwork.mirrored = true;
  sample.report.groups = {"round \"ones\"", ""};
  const json collection = json::parse(geojson_text(sample.report));
  const json& disc = collection["features"][0]["properties"];
  const json& ring = collection["features"][1]["properties"];
  EXPECT_EQ(disc["mirrored"], false);
  EXPECT_EQ(ring["mirrored"], true);
  EXPECT_EQ(disc["group"], "round \"ones\"");
  EXPECT_FALSE(ring.contains("group"));
}

TEST(GeoJson, SaysWhichPiecesAreLocked) {
  test::SampleCollage sample;
  EXPECT_EQ(geojson_text(sample.report).find("locked"), std::string::npos);
  sample.report.locked = {false, true};
  const json features = json::parse(geojson_text(sample.report))["features"];
  EXPECT_FALSE(features[0]["properties"].contains("locked"));
  EXPECT_EQ(features[1]["properties"]["locked"], true);
}

TEST(GeoJson, RingsAreClosedAndTurnAsTheStandardSays) {
  const test::SampleCollage sample;
  const json geometry = json::parse(geojson_text(sample.report))["features"][1]["geometry"];
  EXPECT_EQ(geometry["type"], "Polygon");
  ASSERT_EQ(geometry["coordinates"].size(), 2u);
  for (const json& ring : geometry["coordinates"]) EXPECT_EQ(ring.front(), ring.back());
  const double outer = ring_area(geometry["coordinates"][0]);
  const double hole = ring_area(geometry["coordinates"][1]);
  EXPECT_GT(outer, 0);
  EXPECT_LT(hole, 0);
  EXPECT_NEAR(outer + hole, 60 * 60, 20);  // the square of its scale
}

TEST(GeoJson, AnyFileNameGivesValidJson) {
  test::SampleCollage sample;
  sample.report.shapes[0].name = "quote\" back\\slash \n \xff\xfe";
  const json collection = json::parse(geojson_text(sample.report));
  const std::string name = collection["features"][0]["properties"]["shape"];
  EXPECT_TRUE(name.starts_with("quote\" back\\slash \n ")) << name;
}

TEST(GeoJson, AnEmptyCollageIsAnEmptyCollection) {
  test::SampleCollage sample;
  sample.report.placements.clear();
  EXPECT_TRUE(json::parse(geojson_text(sample.report))["features"].empty());
}

TEST(NumberText, FixedDecimalsWithoutMinusZero) {
  EXPECT_EQ(fixed(2, 3), "2.000");
  EXPECT_EQ(fixed(-1.23456, 3), "-1.235");
  EXPECT_EQ(fixed(-0.0001, 3), "0.000");
  EXPECT_EQ(fixed(-7, 0), "-7");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 1), "0.0");
  EXPECT_EQ(fixed(1e300, 1).size(), 303u);
}

TEST(NumberText, TheLocaleDoesNotMatter) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // without this locale nothing changes
  EXPECT_EQ(fixed(0.5, 1), "0.5");
  std::setlocale(LC_ALL, before.c_str());
}

}  // namespace test_geojson
}  // namespace tessera
