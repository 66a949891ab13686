// docs/result-format.md describes every field of a result.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/stop.h"
#include "render/ranking.h"
#include "result/card_output.h"
#include "result/drawing_notes.h"
#include "result/folder/result_manifest.h"
#include "result/geojson_output.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_result_format {

using nlohmann::json;

/// The text from a heading, "## ..." or "### ...", to the next heading of any level.
std::string documented_section(const std::string& heading) {
  std::ifstream file(std::string(TESSERA_SOURCE_DIR) + "/docs/result-format.md");
  const std::string all = "\n" + std::string{std::istreambuf_iterator<char>(file), {}};
  const auto begin = all.find("\n" + heading + "\n");
  return begin == std::string::npos ? "" : all.substr(begin, all.find("\n#", begin + 1) - begin);
}

/// Returns whether the text names the key, alone in backticks or as a part of a name with dots.
bool names(const std::string& text, const std::string& key) {
  for (const char* before : {"`", "."}) {
    for (const char* after : {"`", "."}) {
      if (text.find(before + key + after) != std::string::npos) return true;
    }
  }
  return false;
}

void expect_all_named(const json& object, const std::string& section) {
  for (const auto& [key, value] : object.items()) {
    EXPECT_TRUE(names(section, key)) << "docs/result-format.md lacks " << key;
    if (value.is_object()) expect_all_named(value, section);
    if (value.is_array() && !value.empty() && value[0].is_object()) expect_all_named(value[0], section);
  }
}

TEST(ResultFormat, has_every_key_of_the_card) {
  RankStatistics ranks;
  ranks.workers.resize(2);
  RunRecord record;
  record.ranks = {{"host", {{"cpu", "device", "platform", "driver", 1}}}};
  const json card =
      json::parse(card_json({}, {}, {}, ranks, record, DeformationFigures{}, {{ShapeId{0}, "ant", 5, 3}}));
  ASSERT_EQ(card.size(), 6u);
  for (const auto& [name, section] : card.items()) expect_all_named(section, documented_section("### " + name));
}

TEST(ResultFormat, has_every_key_of_the_drawing) {
  const DrawingNotes notes{
      .pieces = 2, .notes = {{"disc", DrawnFrom::thumbnail, "lost", 1}, {"ring", DrawnFrom::silhouette, "bad", 1}}};
  const json section = json::parse(drawing_json(notes));
  const std::string text = documented_section("### drawing");
  expect_all_named(section, text);
  for (const char* list : {"from_thumbnails", "as_silhouettes"}) expect_all_named(section[list][0], text);
}

TEST(ResultFormat, has_every_key_of_what_is_seen_from_afar) {
  const std::string text = documented_section("### from_afar");
  expect_all_named(json::parse(afar_json({SeenFromAfar{{}, AfarFigures{}}, {}})), text);
  expect_all_named(json::parse(afar_json({{}, "why"})), text);
}

TEST(ResultFormat, has_every_key_of_the_manifest) {
  const test::ScratchFolder folder;
  ResultManifest manifest;
  manifest.pictures.resize(1);
  manifest.pictures[0].shift = 1;
  manifest.pictures[0].harmony = Harmony{};
  manifest.colours = {"#000000"};
  write_manifest(folder.path(""), manifest);
  std::ifstream file(folder.path("manifest.json"));
  const json written = json::parse(file);
  const std::string text = documented_section("## manifest.json");
  expect_all_named(written, text);
  expect_all_named(written["pictures"][0], text);
}

TEST(ResultFormat, has_every_property_of_a_piece) {
  const test::SampleCollage sample;
  const json pieces = json::parse(geojson_text(sample.report));
  expect_all_named(pieces["features"][0]["properties"], documented_section("## pieces.geojson"));
}

TEST(ResultFormat, has_every_file) {
  for (const char* name : {"pieces.geojson", "card.json", "card.txt", "job.toml", "manifest.json", "collage.svg",
                           "collage.png", "collage.pdf", "collage.tiff", "run.log"}) {
    EXPECT_TRUE(names(documented_section("# The result"), name)) << name;
  }
}

TEST(ResultFormat, has_every_reason_for_the_end) {
  for (const StopReason reason : kStopReasons) {
    const std::string word(stop_word(reason));
    EXPECT_NE(documented_section("### run").find("\n| `" + word + "` | "), std::string::npos) << word;
  }
}

TEST(ResultFormat, has_every_column_of_a_ranking) {
  const std::string text = documented_section("## A ranking") + documented_section("### quality");
  std::istringstream header(ranking_csv({}));
  for (std::string column; std::getline(header, column, ',');) {
    while (column.ends_with('\n')) column.pop_back();
    EXPECT_TRUE(names(text, column)) << column;
  }
}

}  // namespace test_result_format
}  // namespace tessera
