// The result that a folder already holds, and whether a job would make another one.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/error.h"
#include "job/job_difference.h"
#include "result/folder/finished_result.h"
#include "result/folder/result_manifest.h"
#include "support/input_error.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_finished_result {

namespace fs = std::filesystem;

class FinishedResult : public testing::Test {
 protected:
  std::string write_result(bool finished) {
    const std::string dir = scratch_.path("out");
    prepare_output_directory(dir);
    publish_result(dir, sample_.report, sample_.source(), finished);
    return dir;
  }

  test::ScratchFolder scratch_;
  test::SampleCollage sample_;
};

TEST_F(FinishedResult, has_its_job) {
  sample_.job.settings.seed = 12;
  const EarlierResult earlier = find_earlier_result(write_result(true));
  ASSERT_TRUE(earlier.finished());
  EXPECT_EQ(to_toml(earlier.whole->job), to_toml(sample_.job));
  EXPECT_TRUE(is_finished_result_of(earlier, sample_.job));
}

TEST(JobDifferences, of_lists_tell_what_came_and_went) {
  const auto difference = [](const std::vector<std::string>& then_excluded, const std::vector<std::string>& excluded) {
    Job then, now;
    then.library_exclude = then_excluded;
    now.library_exclude = excluded;
    return job_differences(then, now, [](const JobKey&) { return true; });
  };
  EXPECT_EQ(difference({"a", "b"}, {"a", "b"}), "");
  EXPECT_EQ(difference({"a", "b"}, {"b", "c", "d"}), R"(; library.exclude: now with "c", "d", now without "a")");
  EXPECT_EQ(difference({"a", "b"}, {"b"}), R"(; library.exclude: now without "a")");
  EXPECT_EQ(difference({"a", "b"}, {"b", "a"}), "; library.exclude: in another order now");
  EXPECT_EQ(difference({}, {"a"}), R"(; library.exclude: then [], now ["a"])");
}

TEST_F(FinishedResult, is_none_where_it_was_ended_early) {
  const EarlierResult earlier = find_earlier_result(write_result(false));
  EXPECT_TRUE(earlier.whole);
  EXPECT_FALSE(earlier.finished());
}

TEST_F(FinishedResult, is_none_where_there_is_no_manifest) {
  const std::string dir = write_result(true);
  fs::remove(dir + "/manifest.json");
  for (const std::string& folder : {scratch_.path("none"), dir}) {
    const EarlierResult earlier = find_earlier_result(folder);
    EXPECT_FALSE(earlier.whole);
    EXPECT_EQ(earlier.damage, "");
    EXPECT_NE(test::message_of([&] { read_result(folder); }).find("manifest.json: not found"), std::string::npos);
  }
}

TEST_F(FinishedResult, says_which_file_is_missing_or_another_where_there_is_a_manifest) {
  const std::string dir = write_result(true);
  for (const char* name : {"job.toml", "pieces.geojson"}) {
    write_result(true);
    fs::remove(dir + "/" + name);
    const EarlierResult earlier = find_earlier_result(dir);
    EXPECT_FALSE(earlier.whole);
    EXPECT_TRUE(earlier.damage.starts_with(dir + "/" + name + ": not found")) << earlier.damage;
  }
  write_result(true);
  scratch_.write("out/job.toml", "[shapes]\nof = 'another version'\n");
  EXPECT_FALSE(find_earlier_result(dir).whole);
}

TEST_F(FinishedResult, is_whole_without_its_cards) {
  const std::string dir = write_result(true);
  scratch_.write("out/card.json", "{");
  EXPECT_TRUE(find_earlier_result(dir).finished());
  for (const char* name : {"card.json", "card.txt"}) fs::remove(dir + "/" + name);
  EXPECT_TRUE(find_earlier_result(dir).finished());
}

TEST_F(FinishedResult, that_cannot_be_read_is_no_reason_to_replace_it) {
  const std::string dir = scratch_.path("out");
  for (const char* name : {"manifest.json", "job.toml", "pieces.geojson"}) {
    write_result(true);
    fs::remove(dir + "/" + name);
    fs::create_directory(dir + "/" + name);
    EXPECT_THROW(find_earlier_result(dir), EnvironmentError) << name;
    fs::remove(dir + "/" + name);
  }
}

TEST_F(FinishedResult, is_checked_before_nothing_is_computed) {
  const std::string dir = write_result(true);
  CheckpointOrigin now = sample_.source().origin;
  check_finished_result(find_earlier_result(dir), now, 0);
  Job other = sample_.job;
  other.output.width_px = 64;
  now.job = to_toml(other);
  check_finished_result(find_earlier_result(dir), now, 0);
  other.settings.seed = 12;
  now.job = to_toml(other);
  const auto message = [&] {
    return test::message_of([&] { check_finished_result(find_earlier_result(dir), now, 0); });
  };
  EXPECT_EQ(message(),
            dir +
                ": holds the finished result of another job; seed: then 1, now 12; give what it was then, or "
                "leave --resume out to replace it");
  now.job = to_toml(sample_.job);
  now.library_digest = 12;
  EXPECT_NE(message().find("library.file: another content"), std::string::npos);
}

TEST_F(FinishedResult, has_pictures_when_the_manifest_says_so_and_they_are_there) {
  const std::string dir = write_result(true);
  EXPECT_FALSE(read_result(dir).drawn);
  ResultManifest manifest = read_manifest(dir);
  manifest.pictures = {{"collage.svg"}, {"collage.png"}};
  write_manifest(dir, manifest);
  EXPECT_FALSE(read_result(dir).drawn);
  scratch_.write("out/collage.svg", "");
  scratch_.write("out/collage.png", "");
  EXPECT_TRUE(read_result(dir).drawn);
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

TEST(ResultDifferences, TablesCountByTheirColumns) {
  Job then, now;
  then.tables["regions"] = now.tables["regions"] = {{{"name", {{}, "sky"}}, {"colour", {{}, "#000000"}}}};
  now.tables["regions"][0]["background"] = {{}, "#ffffff"};
  EXPECT_EQ(result_differences(then, now), "; [[regions]]: others than then");
  EXPECT_EQ(job_differences(then, now, [](const JobKey& key) { return key.decides; }), "");
  now.tables["regions"][0]["scale_px"] = {{9, 9}, {}};
  EXPECT_NE(job_differences(then, now, [](const JobKey& key) { return key.decides; }), "");
}

TEST(ResultDifferences, are_none_in_what_the_result_does_not_show) {
  Job then, now;
  now.devices = "gpu";
  now.checkpoint.every_s = 1;
  EXPECT_EQ(result_differences(then, now), "");
}

}  // namespace test_finished_result
}  // namespace tessera
