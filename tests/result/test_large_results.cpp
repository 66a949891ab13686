// GeoJSON and other result files that would need too much of the machine. Each is refused or read within seconds and 512 MiB.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/field/canvas.h"
#include "files/file_blocks.h"
#include "job/pieces/start_pieces.h"
#include "render/card_drawing.h"
#include "result/card_input.h"
#include "result/folder/result_manifest.h"
#include "result/placed_pieces.h"
#include "result/polygon_features.h"
#include "result/polygon_pieces.h"
#include "support/large_file.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_large_results {

const std::string kBegin = R"({"type":"FeatureCollection","features":[)";
const std::string kPose = R"("shape":"disc","scale":40,"rotation_deg":0,"x_px":1,"y_px":2)";
const std::string kToken = "found more than 1048576 bytes in a text or number; allowed: 1048576 or fewer";

class LargeResults : public testing::Test {
 protected:
  void read_polygons() { read_polygon_pieces(pieces_, make_rectangle_canvas(200, 100)); }

  void read_start() {
    Job job;
    job.path = "job.toml";
    job.start.pieces = pieces_;
    add_start_pieces({{"disc"}}, job);
  }

  void read_placed() { read_placed_pieces(folder_.path("")); }

  /// Expects a refusal by all functions that read pieces.
  void expect_refused(const test::LargeText& text, const std::string& by_polygons, const std::string& by_start,
                      const std::string& by_placed) {
    text.write(pieces_);
    test::expect_refused(pieces_, by_polygons, [&] { read_polygons(); });
    test::expect_refused(pieces_, by_start, [&] { read_start(); });
    test::expect_refused(pieces_, by_placed, [&] { read_placed(); });
  }

  test::ScratchFolder folder_;
  const std::string pieces_ = folder_.path("pieces.geojson");
};

TEST_F(LargeResults, OfLongTextsAreRefused) {
  expect_refused({kBegin + R"({"properties":{"shape":")", "x", 100'000'000, R"("}}]})"}, kToken, kToken, kToken);
  expect_refused({R"({"note":")", "\\\\", 50'000'000, R"(","features":[]})"}, kToken, kToken, kToken);
  expect_refused({kBegin + R"({"properties":{"scale":)", "9", 100'000'000, "}}]}"}, kToken, kToken, kToken);
}

TEST_F(LargeResults, OfManyValuesAreRefused) {
  const std::string lists = "feature 0: properties: found more than 16 values in lists, allowed: 16 or fewer";
  expect_refused({kBegin + R"({"properties":{)" + kPose + R"(,"canvas_from_shape":[1)", ",1", 20'000'000, "]}}]}"},
                 "geometry.type: found nothing", lists, lists);
  expect_refused({kBegin + "{", R"("properties":{"shape":[1,2]},)", 2'000'000, R"("a":1}]})"}, "shape: found a list",
                 lists, lists);
  expect_refused({kBegin + "7", ",7", 20'000'000, "]}"}, "the feature: found 7", "feature 0: properties: found nothing",
                 "not a pieces.geojson");
  const std::string feature = R"({"properties":{)" + kPose +
                              R"(},"geometry":{"type":"Polygon","coordinates":[)"
                              "[[1,1],[9,1],[9,9],[1,1]]]}}";
  expect_refused({kBegin + feature, "," + feature, 1'000'000, "]}"}, "more than 100000 features",
                 "more than 100000 features", "more than 1000000 features");
  // Parts that no function reads take no memory.
  expect_refused({kBegin + R"({"a":[)", "[],", 20'000'000, R"([]],"properties":{)" + kPose + "}}]}"},
                 "geometry.type: found nothing", "", "");
  expect_refused({kBegin + R"({"properties":{)", R"("a":{},)", 8'000'000, kPose + "}}]}"},
                 "geometry.type: found nothing", "", "");
}

/// The program's own results may have more pieces than a job may give.
TEST_F(LargeResults, OfManyPiecesAreRead) {
  const std::string feature = R"({"properties":{)" + kPose + "}}";
  test::LargeText{kBegin + feature, "," + feature, 250'000, "]}"}.write(pieces_);
  EXPECT_EQ(read_placed_pieces(folder_.path("")).size(), 250'001u);
}

TEST_F(LargeResults, OfManyPositionsAreRefused) {
  std::string ring = "[1,1]";  // dense, as small pieces may be
  for (int i = 0; i < 249; ++i) ring += ",[9," + std::to_string(1 + i / 32) + "." + std::to_string(100 + i) + "]";
  const std::string feature = R"({"geometry":{"type":"Polygon","coordinates":[[)" + ring + ",[1,9],[1,1]]]}}";
  const test::LargeText text{kBegin + feature, "," + feature, 99'990, "]}"};
  text.write(pieces_);
  test::expect_refused(pieces_, "geometry.coordinates: found more than 25000000 positions up to here", [&] {
    JsonFile file{FileBlocks(pieces_, std::size_t(1) << 40)};
    std::vector<PolygonFeature> all;
    try {
      read_polygon_features(file, [&](PolygonFeature one) { all.push_back(std::move(one)); });
    } catch (const InputError& error) {
      throw InputError(pieces_ + ": " + error.what());
    }
  });
  const std::string name = R"({"properties":{"shape":")" + std::string(1'001, 'n') + R"("},"geometry":{}})";
  test::LargeText{kBegin + name, "", 0, "]}"}.write(pieces_);
  test::expect_refused(pieces_, "shape: found a text of 1001 bytes, allowed: 1000", [&] { read_polygons(); });
}

TEST_F(LargeResults, CardsAndManifestsAreSmall) {
  const std::string card = folder_.path("card.json"), manifest = folder_.path("manifest.json");
  const auto expect_card_refused = [&](const test::LargeText& text, const std::string& said) {
    text.write(card);
    test::expect_refused(card, said, [&] { read_card(folder_.path("")); });
    test::expect_refused(card, said, [&] { throw InputError(add_drawing_to_cards(folder_.path(""), {}).at(0)); });
  };
  expect_card_refused({R"({"a":[)", "[],", 20'000'000, "[]]}"},
                      "found more than 500000 values; allowed: 500000 or fewer");
  expect_card_refused({"{\"a\":", "[", 20'000'000, ""}, "found more than 32 levels of lists and objects");
  expect_card_refused({"{\"a\":\"", "x", 60'000'000, "\"}"}, kToken);
  expect_card_refused({"{\"b\":1", ",\"a\":1", 2'000, "}"}, "found more than 1000 members of one object");
  expect_card_refused({"{", " ", 70'000'000, "}"}, "found 70000002 bytes, allowed: 67108864");
  const auto expect_manifest_refused = [&](const test::LargeText& text, const std::string& said) {
    text.write(manifest);
    test::expect_refused(manifest, said, [&] { read_manifest(folder_.path("")); });
  };
  expect_manifest_refused({R"({"a":[)", "[],", 20'000'000, "[]]}"}, "found more than 2000000 values");
  std::string members;  // all different
  for (int i = 0; i < 900'000; ++i) members += ",\"" + std::to_string(i) + "\":1";
  expect_manifest_refused({"{\"b\":1" + members, "", 0, "}"}, "not a manifest of tessera collage");
}

}  // namespace test_large_results
}  // namespace tessera
