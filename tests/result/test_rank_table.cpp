// The table of the ranks: its values follow from the measurements, and its shares add up.
#include "result/rank_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "result/card_output.h"

namespace tessera {
namespace test_rank_table {

/// Two workers: one counts for 1 s, the other for 3 s of 10 s.
RankStatistics sample_ranks() {
  RankStatistics ranks;
  ranks.asked = 2;
  ranks.rounds = 50;
  ranks.target_samples = 700;
  ranks.master.objective_s = 1;
  ranks.master.merge_s = 2;
  ranks.master.questions_s = 0.5;
  ranks.master.waiting_s = 6;
  ranks.master.other_s = 0.5;
  ranks.master.loop_s = 10;
  ranks.master.sent = {400, 2'000'000};
  for (const double count_s : {1., 3.}) {
    WorkerTimes worker;
    worker.count_s = count_s;
    worker.dock_s = 2;
    worker.refine_s = 1;
    worker.field_s = 0.25;
    worker.messages_s = 0.75;
    worker.waiting_s = 5 - count_s;
    worker.loop_s = 9;
    worker.sent = {150, 500'000};
    ranks.workers.push_back(worker);
  }
  return ranks;
}

TEST(RankTable, HasLeastAverageGreatestShareAndImbalance) {
  const auto json = ranks_json(sample_ranks());
  const auto& count = json["worker"]["count"];
  EXPECT_EQ(count["min_s"], 1);
  EXPECT_EQ(count["average_s"], 2);
  EXPECT_EQ(count["max_s"], 3);
  EXPECT_EQ(count["share_percent"], 20);
  EXPECT_EQ(count["imbalance_percent"], 50);
  EXPECT_EQ(json["worker"]["dock"]["imbalance_percent"], 0);
  EXPECT_EQ(json["bytes_to_a_worker_a_round"], 20000);
  EXPECT_EQ(json["bytes_from_a_worker_a_round"], 10000);
}

TEST(RankTable, OfATreeSaysHowManyTheMasterAsks) {
  RankStatistics ranks = sample_ranks();
  ranks.asked = 1;
  EXPECT_EQ(ranks_json(ranks)["asked_by_master"], 1);
  EXPECT_EQ(ranks_json(ranks)["bytes_to_a_worker_a_round"], 40000);
  EXPECT_NE(ranks_text(ranks).find("a master and 2 workers, 1 asked by it, 50 rounds"), std::string::npos);
}

TEST(RankTable, SharesAddUp) {
  const RankStatistics ranks = sample_ranks();
  const auto json = ranks_json(ranks);
  double master_percent = 0;
  for (const auto& stage : kMasterStages) {
    master_percent += json["master"][std::string(stage.name)]["share_percent"].get<double>();
  }
  EXPECT_NEAR(master_percent, 100, 1e-6);
  EXPECT_EQ(json["master"]["serial"]["share_percent"], 40);
  double worker_s = 0;
  for (const auto& stage : kWorkerStages) {
    worker_s += json["worker"][std::string(stage.name)]["average_s"].get<double>();
  }
  EXPECT_NEAR(worker_s, ranks.workers.front().loop_s, 1e-6);
}

TEST(RankTable, TextFitsATerminal) {
  const std::string text = ranks_text(sample_ranks());
  for (const char* part : {"a master and 2 workers, 50 rounds, 10.000 s", "worker: count", "worker: waiting",
                           "master: objective", "master: waiting", "50.0 %", "400 messages", "20000 B"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 80u) << line;
}

TEST(RankTable, IsASectionOfTheCardWhereThereWereWorkers) {
  EXPECT_EQ(ranks_text({}), "");
  EXPECT_FALSE(nlohmann::json::parse(card_json({}, {}, {})).contains("ranks"));
  EXPECT_EQ(nlohmann::json::parse(card_json({}, {}, {}, sample_ranks()))["ranks"]["workers"], 2);
}

TEST(RankTable, ALoopOfNoTime) {
  RankStatistics nothing;
  nothing.workers.resize(1);
  EXPECT_EQ(ranks_json(nothing)["worker"]["count"]["share_percent"], 0);
  EXPECT_FALSE(ranks_text(nothing).empty());
}

}  // namespace test_rank_table
}  // namespace tessera
