// What a folder holds already, and whether a job would make something else of it.
#include <gtest/gtest.h>

#include <filesystem>

#include "io/result/finished_result.h"
#include "io/result/result_manifest.h"
#include "sample_collage.h"
#include "scratch_folder.h"
#include "support/input_error.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

class FinishedResult : public testing::Test {
 protected:
  std::string write_result(bool finished) {
    const std::string dir = scratch_.path("out");
    prepare_output_directory(dir);
    publish_result(dir, sample_.report, sample_.origin(), finished);
    return dir;
  }

  test::ScratchFolder scratch_;
  test::SampleCollage sample_;
};

TEST_F(FinishedResult, has_its_job) {
  sample_.job.settings.seed = 12;
  const auto then = job_of_finished_result(write_result(true));
  ASSERT_TRUE(then.has_value());
  EXPECT_EQ(to_toml(*then), to_toml(sample_.job));
  EXPECT_EQ(result_differences(*then, sample_.job), "");
}

TEST_F(FinishedResult, is_none_where_it_was_ended_early) { EXPECT_FALSE(job_of_finished_result(write_result(false))); }

TEST_F(FinishedResult, is_none_where_a_file_is_missing_or_not_ours) {
  EXPECT_FALSE(job_of_finished_result(scratch_.path("none")));
  for (const char* name : {"manifest.json", "job.toml", "pieces.geojson", "card.json", "card.txt"}) {
    const std::string dir = write_result(true);
    fs::remove(dir + "/" + name);
    EXPECT_FALSE(job_of_finished_result(dir)) << name;
    EXPECT_NE(test::message_of([&] { read_result(dir); }).find(name), std::string::npos);
  }
  const std::string dir = write_result(true);
  scratch_.write("out/job.toml", "[shapes]\nof = 'another version'\n");
  EXPECT_FALSE(job_of_finished_result(dir));
}

TEST_F(FinishedResult, says_which_file_is_missing_or_another_where_there_is_a_manifest) {
  EXPECT_EQ(damage_of_result(scratch_.path("none")), "");
  const std::string dir = write_result(true);
  EXPECT_EQ(damage_of_result(dir), "");
  for (const char* name : {"job.toml", "pieces.geojson", "card.json", "card.txt"}) {
    write_result(false);
    fs::remove(dir + "/" + name);
    EXPECT_TRUE(damage_of_result(dir).starts_with(dir + "/" + name + ": not found")) << damage_of_result(dir);
  }
  write_result(true);
  scratch_.write("out/card.json", "{");
  EXPECT_TRUE(damage_of_result(dir).starts_with(dir + "/card.json: not JSON"));
  fs::remove(dir + "/manifest.json");
  EXPECT_EQ(damage_of_result(dir), "") << "no result at all";
}

TEST_F(FinishedResult, is_checked_before_nothing_is_computed) {
  const std::string dir = write_result(true);
  CheckpointOrigin now = sample_.origin();
  check_finished_result(dir, now);
  Job other = sample_.job;
  other.output.width_px = 64;
  now.job = &other;
  check_finished_result(dir, now);
  other.settings.seed = 12;
  const auto message = [&] { return test::message_of([&] { check_finished_result(dir, now); }); };
  EXPECT_EQ(message(),
            dir +
                ": holds the finished result of another job; seed: then 1, now 12; give what it was then, or "
                "leave --resume out to replace it");
  other = sample_.job;
  now.library_digest = 12;
  EXPECT_NE(message().find("library.file: another content"), std::string::npos);
}

TEST_F(FinishedResult, has_pictures_when_the_manifest_says_so_and_they_are_there) {
  const std::string dir = write_result(true);
  EXPECT_FALSE(is_drawn(dir));
  ResultManifest manifest = read_manifest(dir);
  manifest.pictures = {{"collage.svg", 400, "#ffffff"}, {"collage.png", 400, "#ffffff"}};
  write_manifest(dir, manifest);
  EXPECT_FALSE(is_drawn(dir));
  scratch_.write("out/collage.svg", "");
  scratch_.write("out/collage.png", "");
  EXPECT_TRUE(is_drawn(dir));
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
