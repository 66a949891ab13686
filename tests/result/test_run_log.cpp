// The log of all runs that worked on a result.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "result/folder/run_log.h"
#include "result/folder/run_record.h"
#include "support/file_size_limit.h"
#include "support/planted_files.h"
#include "support/scratch_folder.h"
#include "text/utc_time.h"

namespace tessera {
namespace test_run_log {

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

TEST(RunLog, is_appended_with_time_and_kind) {
  const test::ScratchFolder scratch;
  {
    RunLog log(scratch.path(""));
    log.info("one");
    log.warning("two {}");
    EXPECT_EQ(lines_of(scratch.path("run.log")).size(), 2u) << "before the log is closed";
  }
  RunLog again(scratch.path(""));
  again.error("three");
  EXPECT_EQ(again.problem(), "");
  const std::vector<std::string> lines = lines_of(scratch.path("run.log"));
  ASSERT_EQ(lines.size(), 3u);
  const std::string time = "\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ ";
  EXPECT_TRUE(std::regex_match(lines[0], std::regex(time + "info: one"))) << lines[0];
  EXPECT_TRUE(std::regex_match(lines[1], std::regex(time + "warning: two \\{\\}"))) << lines[1];
  EXPECT_TRUE(std::regex_match(lines[2], std::regex(time + "error: three"))) << lines[2];
}

TEST(RunLog, an_event_is_one_line) {
  const test::ScratchFolder scratch;
  RunLog log(scratch.path(""));
  log.info("a\n2026-01-01T00:00:00Z info: b\x1b[2J");
  const std::vector<std::string> lines = lines_of(scratch.path("run.log"));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("a_2026-01-01T00:00:00Z info: b_[2J"), std::string::npos) << lines[0];
}

TEST(RunLog, that_cannot_be_opened_is_a_problem_and_no_error) {
  const test::ScratchFolder scratch;
  scratch.write("blocked", "");
  RunLog blocked(scratch.path("blocked"));
  blocked.info("lost");
  EXPECT_NE(blocked.problem().find("blocked/run.log"), std::string::npos) << blocked.problem();
  std::filesystem::create_directory(scratch.path("fifo"));
  ASSERT_EQ(mkfifo(scratch.path("fifo/run.log").c_str(), 0600), 0);
  EXPECT_EQ(RunLog(scratch.path("fifo")).problem(),
            "cannot write " + scratch.path("fifo/run.log") +
                ": found a pipe, allowed: a regular file with this one name; remove it");
}

TEST(RunLog, follows_nothing_that_others_put_there) {
  for (const test::Plant plant : test::kPlants) {
    if (plant == test::Plant::file) continue;
    const test::ScratchFolder scratch;
    const test::PlantedFiles planted;
    planted.put(plant, scratch.path("run.log"));
    RunLog log(scratch.path(""));
    log.info("lost");
    EXPECT_NE(log.problem().find("allowed: a regular file with this one name"), std::string::npos) << log.problem();
    planted.expect_untouched();
  }
}

TEST(RunLog, that_cannot_be_written_any_more_is_a_problem_and_no_error) {
  const test::ScratchFolder scratch;
  RunLog log(scratch.path(""));
  log.info("first");
  const test::FileSizeLimit limit(64);
  for (int i = 0; i < 3; ++i) log.info(std::string(100, 'x'));
  EXPECT_NE(log.problem().find("run.log"), std::string::npos);
}

TEST(RunRecord, texts) {
  EXPECT_EQ(devices_text({}), "no devices");
  EXPECT_EQ(devices_text({{"cpu", "Xeon", "PoCL", "3.1", 40}, {"gpu", "G", "P", "2", 80}}),
            "cpu \"Xeon\" of PoCL, driver 3.1: 40 shapes, gpu \"G\" of P, driver 2: 80 shapes");
}

TEST(UtcText, is_iso_8601) {
  EXPECT_EQ(utc_text(0), "1970-01-01T00:00:00Z");
  EXPECT_EQ(utc_text(1795301587), "2026-11-21T22:53:07Z");
}

}  // namespace test_run_log
}  // namespace tessera
