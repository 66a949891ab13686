// The job of a first collage, made from a folder.
#include <gtest/gtest.h>

#include <toml++/toml.h>

#include "products/first_collage/first_job.h"

namespace tessera {
namespace test_first_job {

TEST(FirstJob, SizesFollowTheCanvasAndTheNumberOfShapes) {
  EXPECT_EQ(first_sizes(1'000'000, 193).smallest_px, 28) << "about as jobs/animals.toml has it";
  for (const std::size_t few : {1, 150}) EXPECT_EQ(first_sizes(1'000'000, few).smallest_px, 32) << few;
  for (const std::size_t many : {300, 100'000}) EXPECT_EQ(first_sizes(1'000'000, many).smallest_px, 24) << many;
  EXPECT_EQ(first_sizes(4'000'000, 193).smallest_px, 58);
  EXPECT_EQ(first_sizes(1'000, 193).smallest_px, 8);
  EXPECT_EQ(first_sizes(1'000'000, 193).largest_px, 5 * 28);
}

TEST(FirstJob, NamesWhatItWasGiven) {
  const FirstCanvas heart{.file = "a \"heart\".svg", .width_px = 800, .height_px = 600, .area_px2 = 300'000};
  const toml::table job = toml::parse(first_job("cats\n[x]", "out/cats.h5", 80, heart));
  EXPECT_EQ(job["library"]["file"].value<std::string>(), "out/cats.h5");
  EXPECT_EQ(job["canvas"]["file"].value<std::string>(), "a \"heart\".svg");
  EXPECT_EQ(job["canvas"]["size_px"][0].value<int>(), 800);
  EXPECT_EQ(job["canvas"]["size_px"][1].value<int>(), 600);
  EXPECT_EQ(job["pieces"]["scale_px"][0].value<double>(), first_sizes(300'000, 80).smallest_px);
  EXPECT_FALSE(job.contains("x")) << "a name with a line end is a comment still";
  EXPECT_FALSE(toml::parse(first_job("cats", "out/cats.h5", 80, {}))["canvas"].as_table()->contains("file"));
}

TEST(FirstJob, AChangeOfAnyKindIsSeen) {
  const std::string text = first_job("cats", "out/cats.h5", 80, {.file = {}, .area_px2 = 1'080'000});
  EXPECT_TRUE(is_unedited_first_job(text));
  for (std::size_t at = 0; at < text.size(); at += 7) {
    std::string changed = text;
    changed[at] = changed[at] == '1' ? '2' : '1';
    EXPECT_FALSE(is_unedited_first_job(changed)) << at;
  }
  EXPECT_FALSE(is_unedited_first_job(text + "\n"));
  EXPECT_FALSE(is_unedited_first_job(""));
  EXPECT_FALSE(is_unedited_first_job("seed = 1\n"));
}

}  // namespace test_first_job
}  // namespace tessera
