// The ranking of several collages: weights, order, and files.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/stop.h"
#include "render/ranking.h"
#include "result/card_output.h"
#include "result/folder/result_manifest.h"
#include "support/images.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_ranking {

namespace fs = std::filesystem;
using test::message_of;

ResultCard card(const std::string& folder, double coverage, double overlap = 0) {
  ResultCard result;
  result.folder = folder;
  result.quality.coverage = coverage;
  result.quality.overlap = overlap;
  result.quality.pieces = 4;
  result.quality.distinct_shapes = 2;
  result.quality.effective_shapes = 1;
  result.stopped_by = StopReason::full;
  return result;
}

std::vector<std::string> order_of(const std::vector<RankedResult>& results) {
  std::vector<std::string> folders;
  for (const RankedResult& result : results) folders.push_back(result.card.folder);
  return folders;
}

TEST(Ranking, best_first_and_equal_ones_by_folder) {
  const auto results =
      ranked({card("b", 0.9), card("worse", 0.8), card("a", 0.9), card("laps", 0.91, 0.1)}, ranking_weights({}));
  EXPECT_EQ(order_of(results), (std::vector<std::string>{"a", "b", "worse", "laps"}));
  EXPECT_NEAR(results.front().score, 90 + 0.1 * 25, 1e-9);
}

TEST(Ranking, equal_scores_share_a_rank) {
  const RankingWeights weights = ranking_weights({});
  const auto results = ranked({card("c", 0.9), card("a", 0.9), card("first", 0.95), card("last", 0.8)}, weights);
  std::vector<std::size_t> ranks;
  for (const RankedResult& result : results) ranks.push_back(result.rank);
  EXPECT_EQ(ranks, (std::vector<std::size_t>{1, 2, 2, 4}));
  EXPECT_NE(ranking_csv(results).find("\n2,a,92.500,"), std::string::npos) << ranking_csv(results);
  EXPECT_NE(ranking_csv(results).find("\n2,c,92.500,"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(ranking_json(results, weights))["ranking"][2]["rank"], 2);
}

TEST(Ranking, weights_change_the_order) {
  const RankingWeights weights = ranking_weights({"overlap=0", "coverage=-1"});
  EXPECT_EQ(order_of(ranked({card("high", 0.9), card("low", 0.1)}, weights)),
            (std::vector<std::string>{"low", "high"}));
  EXPECT_EQ(score_formula(weights), "score = - coverage - 2 outside + 0.1 shared_boundary + 0.1 variety, in percent");
}

TEST(Ranking, a_wrong_weight_is_named_with_what_is_allowed) {
  EXPECT_EQ(
      message_of([] { ranking_weights({"cover=2"}); }),
      "--weight cover=2: allowed: NAME=NUMBER with a name of coverage, overlap, outside, shared_boundary, variety, "
      "balance, dwarfs, copies_apart, alone, colour_from_afar, structure_from_afar");
  EXPECT_EQ(message_of([] { ranking_weights({"overlap=much"}); }),
            "--weight overlap=much: found \"much\", allowed: a number from -1000 to 1000");
  EXPECT_NE(message_of([] { ranking_weights({"overlap"}); }), "");
  EXPECT_NE(message_of([] { ranking_weights({"overlap=nan"}); }), "");
}

TEST(Ranking, its_picture_marks_what_is_unfinished) {
  const RankingWeights weights = ranking_weights({});
  const auto picture = [&](StopReason stopped_by) {
    ResultCard one = card("a", 0.9);
    one.stopped_by = stopped_by;
    return ranking_files(ranked({one}, weights), weights).png;
  };
  EXPECT_EQ(picture(StopReason::full), picture(StopReason::seconds));  // this is a limit of the job
  EXPECT_NE(picture(StopReason::full), picture(StopReason::time_limit));
  EXPECT_EQ(picture(StopReason::signal), picture(StopReason::time_limit));
}

ResultCard seen_card(const std::string& folder, double balance, double dwarfs, double copies_apart, double alone) {
  ResultCard result = card(folder, 0.9);
  result.quality.balance = SizeBalance{balance, dwarfs};
  result.quality.copies_apart = copies_apart;
  result.quality.alone = alone;
  return result;
}

TEST(Ranking, what_an_eye_sees_counts_where_it_is_asked_for) {
  const ResultCard even = seen_card("even", 0.9, 0.2, 0.1, 0.1), far = seen_card("far", 0.5, 0.1, 0.4, 0.2);
  const auto order = [&](const std::string& weight) {
    return order_of(ranked({far, even}, ranking_weights({"coverage=0", weight})));
  };
  const std::vector<std::string> even_first = {"even", "far"}, far_first = {"far", "even"};
  EXPECT_EQ(order("overlap=0"), even_first) << "alike, by name";
  EXPECT_EQ(order("balance=1"), even_first);
  EXPECT_EQ(order("balance=-1"), far_first);
  EXPECT_EQ(order("dwarfs=-1"), far_first);
  EXPECT_EQ(order("copies_apart=1"), far_first);
  EXPECT_EQ(order("alone=1"), far_first);
}

TEST(Ranking, nothing_is_as_far_off_as_a_copy_that_is_not_there) {
  const auto results =
      ranked({seen_card("copies", 0.9, 0, 0.9, 0), card("none", 0.9)}, ranking_weights({"copies_apart=1"}));
  EXPECT_EQ(order_of(results), (std::vector<std::string>{"none", "copies"}));
}

TEST(Ranking, a_collage_without_pieces_does_not_lead) {
  ResultCard bare = card("bare", 0);
  bare.quality = {};
  for (const char* weight : {"copies_apart=1", "dwarfs=-1"}) {
    const auto results = ranked({bare, seen_card("laid", 0.9, 0.5, 0.1, 0)}, ranking_weights({"coverage=0", weight}));
    EXPECT_EQ(order_of(results), (std::vector<std::string>{"laid", "bare"})) << weight;
  }
}

TEST(Ranking, older_cards_count_nothing_of_what_they_lack_and_it_is_said) {
  ResultCard older = card("older", 0.9);
  older.age = CardAge::first;
  older.quality.effective_shapes = std::nullopt;
  const RankingWeights weights = ranking_weights({"alone=0.1", "copies_apart=1"});
  const auto results = ranked({older, seen_card("new", 0.9, 0.5, 0.1, 0)}, weights);
  EXPECT_EQ(order_of(results), (std::vector<std::string>{"new", "older"}));
  EXPECT_EQ(lacking_measures(results, weights),
            std::vector<std::string>{
                "older/card.json: lacks variety (counts as 0 %), copies_apart (counts as 0 %), alone (counts as "
                "0 %)"});
  EXPECT_TRUE(lacking_measures(results, ranking_weights({"variety=0"})).empty());
  EXPECT_TRUE(nlohmann::json::parse(ranking_json(results, weights))["ranking"][1]["alone_fraction"].is_null());
  EXPECT_NE(ranking_csv(results).find(",0.000,,,,,,,,,,0.000,full\n"), std::string::npos) << ranking_csv(results);
}

TEST(Ranking, of_what_a_card_lacks_only_that_counts_nothing) {
  ResultCard mid = seen_card("mid", 0.9, 0.5, 0.1, 0);
  mid.age = CardAge::picture;
  const RankingWeights weights = ranking_weights({"balance=1"});
  const auto results = ranked({mid}, weights);
  EXPECT_NEAR(results[0].score, 90 + 90, 1e-9) << "no variety";
  EXPECT_EQ(lacking_measures(results, weights),
            std::vector<std::string>{"mid/card.json: lacks variety (counts as 0 %)"});
}

ResultCard shown_card(const std::string& folder, double colour_difference, double structure) {
  ResultCard result = card(folder, 0.9);
  result.afar = SeenFromAfar{{100, 75, colour_difference, structure}, {}};
  return result;
}

TEST(Ranking, mosaics_are_weighed_by_what_is_seen_from_afar) {
  const ResultCard near = shown_card("near", 5, 0.4), like = shown_card("like", 8, 0.7), none = card("a_none", 0.9);
  const auto order = [&](const std::string& weight) {
    return order_of(ranked({none, near, like}, ranking_weights({"coverage=0", weight})));
  };
  EXPECT_EQ(order("colour_from_afar=-1"), (std::vector<std::string>{"near", "like", "a_none"}));
  EXPECT_EQ(order("structure_from_afar=1"), (std::vector<std::string>{"like", "near", "a_none"}));
  const RankingWeights weights = ranking_weights({"colour_from_afar=-2", "structure_from_afar=0.5"});
  const auto results = ranked({near, none}, weights);
  EXPECT_NEAR(results[0].score, 90 + 0.1 * 25 - 2 * 5 + 0.5 * 40, 1e-9);
  EXPECT_EQ(lacking_measures(results, weights),
            std::vector<std::string>{"a_none/card.json: lacks colour_from_afar (counts as 100 %), structure_from_afar "
                                     "(counts as 0 %)"});
  EXPECT_NE(ranking_csv(results).find(",alone_fraction,from_afar_ciede2000,from_afar_ssim,total_s,"),
            std::string::npos);
  EXPECT_NE(ranking_csv(results).find(",5.000,0.400,0.000,full\n"), std::string::npos) << ranking_csv(results);
  EXPECT_TRUE(nlohmann::json::parse(ranking_json(results, weights))["ranking"][1]["from_afar_ssim"].is_null());
}

TEST(Ranking, a_tenth_of_variety_by_area_speaks_between_collages_that_cover_alike) {
  ResultCard rich = card("rich", 0.89), copies = card("copies", 0.9);
  rich.quality.effective_shapes = 2;
  EXPECT_EQ(order_of(ranked({copies, rich}, ranking_weights({}))), (std::vector<std::string>{"rich", "copies"}));
  EXPECT_EQ(order_of(ranked({copies, rich}, ranking_weights({"variety=0.01"}))).front(), "copies");
}

RC_GTEST_PROP(Ranking, scores_never_rise, ()) {
  std::vector<ResultCard> cards;
  const int count = *rc::gen::inRange(1, 20);
  for (int i = 0; i < count; ++i) {
    cards.push_back(card(std::to_string(i), *rc::gen::inRange(0, 11) / 10., *rc::gen::inRange(0, 3) / 10.));
  }
  const auto results = ranked(cards, ranking_weights({}));
  RC_ASSERT(results.size() == cards.size());
  for (std::size_t i = 1; i < results.size(); ++i) RC_ASSERT(results[i - 1].score >= results[i].score);
}

TEST(Ranking, csv_quotes_what_would_break_it) {
  const std::string csv = ranking_csv(ranked({card("a, \"b\"", 0.5)}, ranking_weights({})));
  EXPECT_NE(csv.find("\n1,\"a, \"\"b\"\"\",52.500,0.500000,0.000000,"), std::string::npos) << csv;
}

class ResultFolders : public testing::Test {
 protected:
  void make_result(const std::string& name, double coverage) {
    fs::create_directories(scratch_.path(name));
    Quality quality;
    quality.coverage = coverage;
    quality.pieces = 10;
    quality.distinct_shapes = 5;
    quality.effective_shapes = 4.25;
    quality.largest_gap_px = 3.5;
    quality.balance = SizeBalance{0.75, 0.125};
    quality.copies_px = 50;
    quality.alone = 0.25;
    RunStatistics run;
    run.total_s = 12.5;
    run.stopped_by = StopReason::full;
    scratch_.write(name + "/card.json", card_json(quality, run, {}));
    ResultManifest manifest;
    for (const char* file : {"pieces.geojson", "card.txt"}) scratch_.write(name + "/" + file, "");
    scratch_.write(name + "/job.toml", kJob);
    manifest.shapes.resize(10);
    manifest.pieces_digest = text_digest("");
    manifest.job_digest = text_digest(kJob);
    write_manifest(scratch_.path(name), manifest);
  }

  std::vector<std::string> folders_in(const char* argument) {
    std::vector<std::string> folders;
    for (const ResultCard& card : find_results(scratch_.path(argument)).cards) folders.push_back(card.folder);
    return folders;
  }

  static constexpr const char* kJob = "[library]\nfile = '/a.h5'\n";

  test::ScratchFolder scratch_;
};

TEST_F(ResultFolders, a_card_is_read_as_it_was_written) {
  make_result("a", 0.93);
  const ResultCard card = read_card(scratch_.path("a"));
  EXPECT_EQ(card.quality.coverage, 0.93);
  EXPECT_EQ(card.quality.pieces, 10u);
  EXPECT_EQ(card.quality.distinct_shapes, 5u);
  EXPECT_EQ(card.quality.effective_shapes, 4.25);
  EXPECT_EQ(card.quality.largest_gap_px, 3.5);
  EXPECT_EQ(card.age, CardAge::variety);
  EXPECT_EQ(card.quality.balance.value().evenness, 0.75);
  EXPECT_EQ(card.quality.balance.value().dwarfs, 0.125);
  EXPECT_EQ(card.quality.copies_px, 50);
  EXPECT_FALSE(card.quality.copies_apart);
  EXPECT_FALSE(card.quality.between_px);
  EXPECT_EQ(card.quality.alone, 0.25);
  EXPECT_EQ(card.total_s, 12.5);
  EXPECT_EQ(card.stopped_by, StopReason::full);
}

TEST_F(ResultFolders, an_unknown_end_is_named_with_those_that_there_are) {
  scratch_.write("card.json", R"({"quality": {"coverage_fraction": 0.9, "overlap_fraction": 0, "outside_fraction": 0,
      "pieces": 3, "distinct_shapes": 2, "shared_boundary_fraction": 0.5, "largest_gap_radius_px": 4},
      "run": {"total_s": 1, "stopped_by": "Full"}})");
  const std::string said = test::message_of([&] { read_card(scratch_.path("")); });
  EXPECT_NE(said.find("run.stopped_by: found \"Full\", allowed: full, used_up, pieces"), std::string::npos) << said;
}

TEST_F(ResultFolders, older_cards_are_read) {
  scratch_.write("card.json", R"({"quality": {"coverage_fraction": 0.9, "overlap_fraction": 0, "outside_fraction": 0,
      "pieces": 3, "distinct_shapes": 2, "shared_boundary_fraction": 0.5, "largest_gap_radius_px": 4},
      "run": {"total_s": 1, "stopped_by": "full"}})");
  const ResultCard card = read_card(scratch_.path(""));
  EXPECT_EQ(card.age, CardAge::first);
  EXPECT_EQ(card.quality.pieces, 3u);
  EXPECT_FALSE(card.quality.balance);
}

TEST_F(ResultFolders, cards_from_before_variety_keep_what_they_tell) {
  make_result("a", 0.93);
  auto card = nlohmann::json::parse(std::ifstream(scratch_.path("a/card.json")));
  card["quality"].erase("effective_shapes");
  scratch_.write("a/card.json", card.dump());
  const ResultCard read = read_card(scratch_.path("a"));
  EXPECT_EQ(read.age, CardAge::picture);
  EXPECT_EQ(read.quality.balance.value().evenness, 0.75);
  EXPECT_FALSE(read.quality.effective_shapes);
}

TEST_F(ResultFolders, what_is_wrong_with_a_card_is_said) {
  const std::string path = scratch_.path("card.json");
  const auto message = [&](const std::string& bytes) {
    scratch_.write("card.json", bytes);
    return message_of([&] { read_card(scratch_.path("")); });
  };
  EXPECT_EQ(message("{"), path + ": not JSON; allowed: a card.json of tessera collage");
  EXPECT_EQ(message("[1]"), path + ": quality.coverage_fraction is missing; allowed: a card.json of tessera collage");
  EXPECT_EQ(message(R"({"quality": {"coverage_fraction": "high"}})"),
            path + ": quality.coverage_fraction: found \"high\", allowed: a number from 0 to 1.1");
  EXPECT_NE(message_of([&] { read_card(scratch_.path("none")); }).find("none/card.json: not found"), std::string::npos);
}

TEST_F(ResultFolders, numbers_that_cannot_be_are_refused) {
  make_result("forged", 0.9);
  const std::string path = scratch_.path("forged/card.json");
  const auto whole = nlohmann::json::parse(std::ifstream(path));
  const auto damage = [&](const char* section, const char* key, double value) {
    auto card = whole;
    card[section][key] = value;
    scratch_.write("forged/card.json", card.dump());
    const FoundResults found = find_results(scratch_.path("forged"));
    return found.damages.empty() ? "ranked" : found.damages.front();
  };
  EXPECT_EQ(damage("quality", "coverage_fraction", 1e308),
            path + ": quality.coverage_fraction: found 1e+308, allowed: a number from 0 to 1.1");
  EXPECT_EQ(damage("quality", "pieces", 1e300), path +
                                                    ": quality.pieces: found 1e+300, allowed: a number from 0 to "
                                                    "1000000000");
  EXPECT_EQ(damage("quality", "pieces", 1000),
            path + ": quality.pieces: found 1000, allowed: 10, as many as pieces.geojson has");
  for (const char* key : {"overlap_fraction", "outside_fraction", "shared_boundary_fraction", "distinct_shapes",
                          "largest_gap_radius_px", "effective_shapes", "size_balance", "dwarfs_fraction",
                          "nearest_copy_px", "nearest_copy_fraction", "between_pieces_px", "alone_fraction"}) {
    EXPECT_NE(damage("quality", key, 1e7).find(std::string(key) + ": found 1"), std::string::npos) << key;
    EXPECT_NE(damage("quality", key, -1).find(std::string(key) + ": found -1"), std::string::npos) << key;
  }
  EXPECT_NE(damage("run", "total_s", 1e300).find("run.total_s"), std::string::npos);
  EXPECT_EQ(damage("quality", "coverage_fraction", 1), "ranked");
}

TEST_F(ResultFolders, are_the_folder_or_its_folders) {
  make_result("all/b", 0.9);
  make_result("all/a", 0.8);
  fs::create_directories(scratch_.path("all/unfinished"));
  make_result("all/crashed", 0.95);
  fs::remove(scratch_.path("all/crashed/manifest.json"));
  EXPECT_EQ(folders_in("all/b"), std::vector<std::string>{scratch_.path("all/b")});
  EXPECT_EQ(folders_in("all"), (std::vector<std::string>{scratch_.path("all/a"), scratch_.path("all/b")}));
  const auto message = [&](const char* folder) { return message_of([&] { find_results(scratch_.path(folder)); }); };
  for (const char* folder : {"all/crashed", "all/unfinished"}) {
    EXPECT_EQ(message(folder),
              scratch_.path(folder) + ": no result of tessera collage, neither in this folder nor in those within it");
  }
  EXPECT_EQ(message("none"), scratch_.path("none") + ": no such folder");
  EXPECT_EQ(message("all/a/job.toml"), scratch_.path("all/a/job.toml") + ": not a folder");
}

TEST_F(ResultFolders, what_cannot_be_ranked_is_left_out_and_said) {
  for (const char* name : {"all/a", "all/lost", "all/unreadable"}) make_result(name, 0.8);
  fs::remove(scratch_.path("all/lost/card.json"));
  fs::remove(scratch_.path("all/unreadable/card.json"));
  fs::create_directory(scratch_.path("all/unreadable/card.json"));
  EXPECT_EQ(folders_in("all"), std::vector<std::string>{scratch_.path("all/a")});
  const std::vector<std::string> damages = find_results(scratch_.path("all")).damages;
  ASSERT_EQ(damages.size(), 2u);
  EXPECT_TRUE(damages[0].starts_with(scratch_.path("all/lost/card.json") + ": not found"));
  EXPECT_TRUE(damages[1].starts_with(scratch_.path("all/unreadable/card.json") + ": not a readable file"));
  EXPECT_EQ(find_results(scratch_.path("all/lost")).damages.size(), 1u);
}

TEST_F(ResultFolders, the_files_of_a_ranking) {
  make_result("a", 0.8);
  make_result("b", 0.9);
  test::write_image(scratch_.path("b/collage.png"), cv::Mat(100, 640, CV_8UC3, cv::Scalar(0, 0, 255)));  // a has none
  const RankingWeights weights = ranking_weights({});
  const auto results = ranked({read_card(scratch_.path("a")), read_card(scratch_.path("b"))}, weights);
  write_ranking(scratch_.path(""), ranking_files(results, weights));
  std::ifstream file(scratch_.path("ranking.json"));
  const auto json = nlohmann::json::parse(file);
  EXPECT_EQ(json["weights"]["overlap"], -2);
  EXPECT_EQ(json["ranking"][0]["folder"], scratch_.path("b"));
  EXPECT_EQ(json["ranking"][1]["rank"], 2);
  const cv::Mat sheet = test::bgr_of_image(test::read_image(scratch_.path("ranking.png")));
  ASSERT_FALSE(sheet.empty());
  const cv::Vec3b red(0, 0, 255);
  EXPECT_EQ(sheet.at<cv::Vec3b>(28 + 44 + 25, 28 + 160), red);  // the middle of the first cell, 320 x 50 px
}

}  // namespace test_ranking
}  // namespace tessera
