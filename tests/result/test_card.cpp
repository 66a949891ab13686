// The quality card, for programs and for people.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/stop.h"
#include "result/card_output.h"

namespace tessera {
namespace test_card {

Quality sample_quality() {
  Quality q;
  q.coverage = 0.9123456789;
  q.overlap = 0.00412;
  q.outside = 0.0001;
  q.shared_boundary = 0.683;
  q.pieces = 1234;
  q.distinct_shapes = 118;
  q.effective_shapes = 64.25;
  q.scale_px_quantiles = {20, 24.5, 48.25, 110, 160};
  q.largest_gap_px = 9.75;
  q.size_range_px = {20, 160};
  q.balance = SizeBalance{0.8351234, 0.0567};
  q.copies_px = 341.2345;
  q.copies_apart = 0.2413;
  q.between_px = 0.75;
  q.alone = 0.0125;
  q.style_distance = 1.23449;
  return q;
}

RunStatistics sample_run() {
  RunStatistics r;
  r.shapes = 120;
  r.pads_per_shape = 512;
  r.rounds = 230;
  r.docking_choices = 12345678;
  r.dockings_evaluated = 1234568;
  r.prune_s = 1;
  r.dock_s = 2;
  r.objective_s = 4;
  r.merge_s = 3;
  r.total_s = 12.5;
  r.last_tenth = 0.0123;
  r.stopped_by = StopReason::full;
  return r;
}

TEST(Card, JsonHasEveryMeasureWithItsUnit) {
  const auto card = nlohmann::json::parse(card_json(sample_quality(), sample_run(), {}));
  const auto& quality = card["quality"];
  EXPECT_EQ(quality["coverage_fraction"], 0.912346);
  EXPECT_EQ(quality["overlap_fraction"], 0.00412);
  EXPECT_EQ(quality["outside_fraction"], 0.0001);
  EXPECT_EQ(quality["pieces"], 1234);
  EXPECT_EQ(quality["distinct_shapes"], 118);
  EXPECT_EQ(quality["effective_shapes"], 64.25);
  EXPECT_EQ(quality["shared_boundary_fraction"], 0.683);
  EXPECT_EQ(quality["scale_px"]["median"], 48.25);
  EXPECT_EQ(quality["largest_gap_radius_px"], 9.75);
  EXPECT_EQ(quality["size_range_px"]["max"], 160);
  EXPECT_EQ(quality["size_balance"], 0.835123);
  EXPECT_EQ(quality["dwarfs_fraction"], 0.0567);
  EXPECT_EQ(quality["nearest_copy_px"], 341.235);
  EXPECT_EQ(quality["nearest_copy_fraction"], 0.2413);
  EXPECT_EQ(quality["between_pieces_px"], 0.75);
  EXPECT_EQ(quality["alone_fraction"], 0.0125);
  EXPECT_EQ(quality["style_distance"], 1.234);
}

TEST(Card, WhatIsNotKnownIsNull) {
  Quality quality;
  quality.pieces = 1;
  const auto card = nlohmann::json::parse(card_json(quality, {}, {}));
  for (const char* key : {"effective_shapes", "size_balance", "dwarfs_fraction", "nearest_copy_px",
                          "nearest_copy_fraction", "between_pieces_px", "style_distance"}) {
    EXPECT_TRUE(card["quality"].at(key).is_null()) << key;
  }
  EXPECT_TRUE(card["run"].at("last_tenth_percent").is_null());
  EXPECT_EQ(card_text(quality, {}, {}).find("last tenth"), std::string::npos);
}

TEST(Card, OfAnybodysPiecesIsTheQualityAlone) {
  Quality quality = sample_quality();
  EXPECT_EQ(nlohmann::json::parse(score_json(quality)).size(), 1u);
  EXPECT_EQ(nlohmann::json::parse(score_json(quality))["quality"]["distinct_shapes"], 118);
  EXPECT_EQ(score_text(quality).find("Run"), std::string::npos);
  EXPECT_NE(score_text(quality).find("that of 64.2 shapes with equal shares of the area"), std::string::npos);
  quality.distinct_shapes = 0;
  quality.effective_shapes = std::nullopt;
  quality.copies_px = quality.copies_apart = std::nullopt;
  EXPECT_TRUE(nlohmann::json::parse(score_json(quality))["quality"]["distinct_shapes"].is_null());
  EXPECT_NE(score_text(quality).find("1,234, of shapes without a name"), std::string::npos);
}

TEST(Card, JsonTellsWhatMadeTheResult) {
  RunRecord record;
  record.version = "1.2";
  record.commit = "abc";
  record.command_line = "tessera collage 'caf\xe9.toml'";  // not UTF-8
  record.library_digest = 0xff;
  record.started_utc = "2026-11-21T22:53:07Z";
  record.resumed_from = "out/checkpoint.h5";
  record.resumed_pieces = 12;
  record.ranks = {{"node1", {}}, {"node2", {{"gpu", "G", "P", "D", 80}}}};
  record.warnings = {"no checkpoint"};
  const auto card = nlohmann::json::parse(card_json(sample_quality(), sample_run(), {}, {}, record))["provenance"];
  EXPECT_EQ(card["version"], "1.2");
  EXPECT_EQ(card["commit"], "abc");
  EXPECT_EQ(card["command_line"], "tessera collage 'caf\xEF\xBF\xBD.toml'");
  EXPECT_EQ(card["library_digest"], "00000000000000ff");
  EXPECT_EQ(card["started_utc"], "2026-11-21T22:53:07Z");
  EXPECT_EQ(card["resumed_pieces"], 12);
  EXPECT_EQ(card["warnings"][0], "no checkpoint");
  EXPECT_EQ(card["ranks"][0]["host"], "node1");
  EXPECT_TRUE(card["ranks"][0]["devices"].empty());
  EXPECT_EQ(card["ranks"][1]["devices"][0]["driver"], "D");
  EXPECT_EQ(card["ranks"][1]["devices"][0]["shapes"], 80);
}

TEST(Card, JsonHasTheColumnsOfTable2) {
  const auto run = nlohmann::json::parse(card_json(sample_quality(), sample_run(), {}))["run"];
  EXPECT_EQ(run["candidates"], 120);
  EXPECT_EQ(run["pads_per_shape"], 512);
  EXPECT_EQ(run["iterations"], 230);
  EXPECT_EQ(run["docking_choices"], 12345678);
  EXPECT_NEAR(run["pruned_percent"].get<double>(), 90, 1e-3);
  EXPECT_EQ(run["total_s"], 12.5);
  EXPECT_EQ(run["last_tenth_percent"], 1.23);
  EXPECT_EQ(run["prune_share_percent"], 10);
  EXPECT_EQ(run["dock_share_percent"], 20);
  EXPECT_EQ(run["objective_share_percent"], 40);
  EXPECT_EQ(run["merge_share_percent"], 30);
  EXPECT_EQ(run["stopped_by"], "full");
}

TEST(Card, TextIsATableThatFitsATerminal) {
  const std::string text = card_text(sample_quality(), sample_run(), {});
  for (const char* part :
       {"91.23 %", "0.412 %", "0.010 %", "1,234 of 118", "120  (shapes in the library)", "68.3 %", "12,345,678",
        "90.00 %", "12.5 s", "10.0 % / 20.0 %", "40.0 % / 30.0 %", "full", "0.84  (1 = even; over 20.0 to 160.0 px)",
        "5.7 %  (of the pieces' area; below 28.3 px)", "341.2 px away  (median; 24.1 % of the ",
        "0.750 px  (the nearest two", "1.2 %  (of the pieces; no other", "+1.23 % of the canvas"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 80u) << line;
}

/// The value beside a label of the table.
std::string value_of(const std::string& label, const RunStatistics& run, const CardSettings& settings) {
  const std::string text = card_text(sample_quality(), run, settings);
  const std::size_t begin = text.find_first_not_of(' ', text.find("  " + label + " ") + 2 + label.size());
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(Card, NamesWhatIsMissing) {
  EXPECT_EQ(card_text({}, {}, {}).find("Missing"), std::string::npos);
  EXPECT_FALSE(nlohmann::json::parse(card_json({}, {}, {})).contains("missing"));
  std::vector<MissingShape> missing = {{ShapeId{0}, "ant", 5, 3}, {ShapeId{7}, std::string(200, 'b') + "\x1b", 1, 0}};
  const auto card = nlohmann::json::parse(card_json({}, {}, {}, {}, {}, {}, missing));
  EXPECT_EQ(card["missing"]["pieces"], 3);
  EXPECT_EQ(card["missing"]["shapes"][0], (nlohmann::json{{"shape", "ant"}, {"wanted", 5}, {"standing", 3}}));
  const std::string text = card_text({}, {}, {}, {}, missing);
  EXPECT_NE(text.find("3 of 2 shapes\n"), std::string::npos);
  EXPECT_NE(text.find("ant (3 of 5)\n"), std::string::npos);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 80u) << line;
  missing.assign(200'000, {ShapeId{0}, "ant", 5, 3});
  EXPECT_EQ(nlohmann::json::parse(card_json({}, {}, {}, {}, {}, {}, missing))["missing"]["shapes"].size(), 1000u);
  EXPECT_EQ(nlohmann::json::parse(card_json({}, {}, {}, {}, {}, {}, missing))["missing"]["pieces"], 400'000);
  missing.assign(100, {ShapeId{0}, "ant", 5, 3});
  EXPECT_NE(card_text({}, {}, {}, {}, missing).find("and 80 more (card.json)\n"), std::string::npos);
  EXPECT_EQ(missing_text(missing, 2), "ant (3 of 5), ant (3 of 5) and 98 more shapes");
  EXPECT_EQ(missing_text({{ShapeId{0}, "a\x1b[31m\n", 1, 0}}, 2), "a_[31m_ (0 of 1)");
}

TEST(Card, TellsWhatEndedFillingAndHowFarImprovingCame) {
  CardSettings settings;
  RunStatistics run = sample_run();
  EXPECT_EQ(value_of("stopped by", run, settings), "full");
  run.trials = 1200;
  EXPECT_EQ(value_of("stopped by", run, settings), "full, then 1,200 trials") << "improve.seconds alone limits them";
  settings.trials = 1500;
  EXPECT_EQ(value_of("stopped by", run, settings), "full, then 1,200 of 1,500 trials");
  run.stopped_by = StopReason::signal;
  EXPECT_EQ(value_of("stopped by", run, settings), "signal after 1,200 of 1,500 trials");
  const auto json = nlohmann::json::parse(card_json(sample_quality(), run, settings))["run"];
  EXPECT_EQ(json["stopped_by"], "signal");
  EXPECT_EQ(json["trials"], 1200);
  EXPECT_EQ(json["trials_limit"], 1500);
}

TEST(Card, SaysWherePaddingLeavesNoBoundaryToShare) {
  CardSettings settings;
  EXPECT_EQ(value_of("shared boundary", sample_run(), settings), "68.3 %  (within 2 px)");
  settings.padding_px = 5;
  EXPECT_EQ(value_of("shared boundary", sample_run(), settings), "68.3 %  (within 2 px; padding keeps 5.0 px)");
}

TEST(Card, ARunThatDidNothing) {
  const auto card = nlohmann::json::parse(card_json({}, {}, {}));
  EXPECT_EQ(card["run"]["prune_share_percent"], 0);
  EXPECT_EQ(card["run"]["pruned_percent"], 0);
  const std::string text = card_text({}, {}, {});
  EXPECT_NE(text.find("candidates"), std::string::npos);
  for (const char* line : {"PADs", "iterations", "docking choices", "pruned", "prune / dock", "objective / merge"}) {
    EXPECT_EQ(text.find(line), std::string::npos) << line;
    EXPECT_NE(card_text({}, sample_run(), {}).find(line), std::string::npos) << line;
  }
}

}  // namespace test_card
}  // namespace tessera
