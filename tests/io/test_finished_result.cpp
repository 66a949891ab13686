// What a folder holds already, and whether a job would make something else of it.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "io/result/finished_result.h"
#include "sample_collage.h"
#include "scratch_folder.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

class FinishedResult : public testing::Test {
 protected:
  std::string write_result(const std::string& stopped_by) {
    sample_.report.statistics.stopped_by = stopped_by;
    const std::string dir = scratch_.path("out");
    prepare_output_directory(dir);
    write_collage(dir, sample_.report, true);
    return dir;
  }

  test::ScratchFolder scratch_;
  test::SampleCollage sample_;
};

TEST_F(FinishedResult, has_its_job) {
  sample_.job.settings.seed = 12;
  const auto then = job_of_finished_result(write_result("full"));
  ASSERT_TRUE(then.has_value());
  EXPECT_EQ(to_toml(*then), to_toml(sample_.job));
  EXPECT_EQ(result_differences(*then, sample_.job), "");
}

TEST_F(FinishedResult, is_none_where_it_was_ended_early) {
  EXPECT_FALSE(job_of_finished_result(write_result("signal")));
  EXPECT_FALSE(job_of_finished_result(write_result("time_limit")));
  EXPECT_FALSE(job_of_finished_result(write_result("lost_rank")));
}

TEST_F(FinishedResult, is_none_where_a_file_is_missing_or_not_ours) {
  EXPECT_FALSE(job_of_finished_result(scratch_.path("none")));
  for (const char* name : {"card.json", "job.toml", "collage.png"}) {
    const std::string dir = write_result("full");
    fs::remove(dir + "/" + name);
    EXPECT_FALSE(job_of_finished_result(dir)) << name;
  }
  const std::string dir = write_result("full");
  scratch_.write("out/job.toml", "[shapes]\nof = 'another version'\n");
  fs::last_write_time(dir + "/job.toml", fs::last_write_time(dir + "/collage.png"));
  EXPECT_FALSE(job_of_finished_result(dir));
}

TEST_F(FinishedResult, is_none_where_the_picture_is_older_than_the_job) {
  const std::string dir = write_result("full");
  fs::last_write_time(dir + "/collage.png", fs::last_write_time(dir + "/job.toml") - std::chrono::seconds(1));
  EXPECT_FALSE(job_of_finished_result(dir));
}

TEST(ResultDifferences, name_each_key_with_both_values) {
  Job then, now;
  now.settings.pieces.padding_px = 2.5f;
  now.output.width_px = 500;
  now.settings.stop.seconds = 9;
  now.library = "/b.h5";
  EXPECT_EQ(
      result_differences(then, now),
      "; library.file: then \"\", now \"/b.h5\"; pieces.padding_px: then 0, now 2.5; stop.seconds: then 0, now 9; "
      "output.width_px: then 2000, now 500");
}

TEST(ResultDifferences, are_none_in_what_the_result_does_not_show) {
  Job then, now;
  now.devices = "gpu";
  now.checkpoint.every_s = 1;
  EXPECT_EQ(result_differences(then, now), "");
}

}  // namespace
}  // namespace tessera::io
