// The records of a run about itself, for the card and in run.log.
#include "core/base/stop.h"
#include "run/collage_journal.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "support/scratch_folder.h"

namespace tessera::cli {
namespace test_collage_journal {

class Journal : public testing::Test {
 protected:
  static RunRecord start() {
    RunRecord record;
    record.version = "1.2";
    record.commit = "abc";
    record.command_line = "tessera collage my.toml";
    return record;
  }
  bool log_has(const std::string& text) const {
    std::ifstream file(scratch_.path("run.log"));
    const std::string log{std::istreambuf_iterator<char>(file), {}};
    return log.find(text) != std::string::npos;
  }

  test::ScratchFolder scratch_;
  CollageJournal journal_{scratch_.path(""), start()};
};

TEST_F(Journal, keeps_what_happens_in_the_record_and_in_the_log) {
  journal_.set_rank_sites({{"node1", {}}, {"node2", {{"gpu", "G", "P", "D", 80}}}});
  CheckpointState from;
  from.name = "out/checkpoint.h5";
  from.placements.resize(3);
  journal_.resumed(from);
  journal_.warn("");
  journal_.keep_warning("no checkpoint");
  const RunRecord& record = journal_.ended(StopReason::full, 7);
  EXPECT_EQ(record.ranks.size(), 2u);
  EXPECT_EQ(record.resumed_from, "out/checkpoint.h5");
  EXPECT_EQ(record.resumed_pieces, 3u);
  EXPECT_EQ(record.warnings, std::vector<std::string>{"no checkpoint"});
  EXPECT_FALSE(record.ended_utc.empty());
  for (const char* text :
       {"start: tessera 1.2, commit abc", "command: tessera collage my.toml", "rank 0 of 2 on node1: no devices",
        "rank 1 of 2 on node2: gpu \"G\" of P, driver D: 80 shapes", "going on from out/checkpoint.h5, 3 pieces",
        "warning: no checkpoint", "end: stopped by full, 7 pieces"}) {
    EXPECT_TRUE(log_has(text)) << text;
  }
}

TEST_F(Journal, writes_down_what_ends_the_work_and_passes_it_on) {
  EXPECT_EQ(journal_.watch([] { return 5; }), 5);
  EXPECT_THROW(journal_.watch([]() -> int { throw EnvironmentError("disk full"); }), EnvironmentError);
  EXPECT_TRUE(log_has("error: disk full"));
  EXPECT_THROW(journal_.watch([]() -> int { throw Interrupted{StopReason::lost_rank}; }), Interrupted);
  EXPECT_TRUE(log_has("end: stopped by lost_rank before the first round"));
}

}  // namespace test_collage_journal
}  // namespace tessera::cli
