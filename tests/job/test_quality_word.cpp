// The key `quality`: the number of trials for each word, and what takes precedence over it.
#include "job/quality_word.h"

#include "job/pieces/variations.h"
#include "job_file_fixture.h"

namespace tessera {
namespace test_quality_word {

using Texts = std::vector<std::string>;

class QualityOfAJob : public JobFile {
 protected:
  /// Loads a job of 1000 x 1000 px, with the lines `top` at top level.
  Job load(const std::string& top, const std::string& sections = "", const Texts& overrides = {}) const {
    return JobFile::load(top + minimal_ + kSizes_ + sections, overrides);
  }

  /// The trials of a job with "good".
  int trials(const std::string& sections, const Texts& overrides = {}) const {
    return JobFile::load("quality = 'good'\n" + minimal_ + sections, overrides).settings.improve.trials;
  }

  static constexpr const char* kSizes_ = "[pieces]\nscale_px = [30, 150]\n";
};

TEST_F(QualityOfAJob, is_a_number_of_trials) {
  EXPECT_EQ(load("quality = 'draft'\n").settings.improve.trials, 0);
  EXPECT_EQ(load("quality = 'good'\n").settings.improve.trials, 300);
  EXPECT_EQ(load("quality = 'best'\n").settings.improve.trials, 2400);
  EXPECT_EQ(load("quality = ''\n").settings.improve.trials, 0);
}

TEST_F(QualityOfAJob, goes_by_the_pieces_to_be_expected) {
  EXPECT_EQ(trials("[canvas]\nsize_px = [2000, 1500]\n[pieces]\nscale_px = [30, 150]\n"), 900);
  EXPECT_EQ(trials("[pieces]\nscale_px = [15, 75]\n"), 1200);
  EXPECT_EQ(trials("[pieces]\nscale_px = [[60, 150], [30, 45], 100]\n"), 300) << "from the least to the greatest";
  EXPECT_EQ(trials("[pieces]\nscale_px = 60\n"), 380) << "375 to two digits";
  EXPECT_EQ(trials(""), 420) << "421.9 of the default sizes";
  EXPECT_EQ(trials("[canvas]\nsize_px = [100, 100]\n[pieces]\nscale_px = 60\n"), 4) << "3.75";
  EXPECT_EQ(trials("[canvas]\nsize_px = [998, 1000]\n[pieces]\nscale_px = [36.9, 36.9]\n"), 990) << "989.5";
  EXPECT_EQ(trials("[canvas]\nsize_px = [998, 1000]\n[pieces]\nscale_px = [36.75, 36.75]\n"), 1000) << "997.6";
}

TEST_F(QualityOfAJob, is_one_trial_at_least_and_no_more_than_the_key_allows) {
  EXPECT_EQ(trials("[canvas]\nsize_px = [16, 16]\n[pieces]\nscale_px = 5000\n"), 1);
  EXPECT_EQ(trials("[canvas]\nsize_px = [10000, 10000]\n[pieces]\nscale_px = 2\n"), 10'000'000);
}

TEST_F(QualityOfAJob, goes_by_the_box_of_a_mask) {
  EXPECT_EQ(trials("[canvas]\nfile = 'heart.svg'\n[pieces]\nscale_px = [30, 150]\n"), 300);
}

TEST_F(QualityOfAJob, knows_sizes_in_mm) {
  const std::string in_mm = "[pieces]\nscale_mm = [15, 75]\n[canvas]\nsize_mm = [600, 400]\n";
  EXPECT_EQ(trials(in_mm + "size_px = [1200, 800]\n"), 290) << "288";
  EXPECT_EQ(trials(in_mm), 290) << "a longer side of 2000 px";
  EXPECT_EQ(trials(in_mm, {"pieces.scale_mm=[7.5, 37.5]"}), 1200) << "1152";
}

TEST_F(QualityOfAJob, goes_by_what_the_command_line_says_of_canvas_and_sizes) {
  EXPECT_EQ(trials("[pieces]\nscale_px = [30, 150]\n", {"canvas.size_px=[2000, 2000]"}), 1200);
  EXPECT_EQ(trials("", {"pieces.scale_px=[30, 150]"}), 300);
}

struct Case {
  std::string of_file;  // the word; "-": the key is missing
  std::string keys;     // lines of [improve]
  Texts overrides;
  int trials;
  double seconds;
};

TEST_F(QualityOfAJob, yields_to_numbers_beside_it_and_to_the_command_line) {
  const std::string few = "trials = 50\n", brief = "seconds = 9\n";
  const std::vector<Case> cases = {
      // The file alone.
      {"-", "", {}, 300, 0},
      {"-", "relax = false\n", {}, 300, 0},
      {"-", few, {}, 50, 0},
      {"-", "trials = 0\n", {}, 0, 0},
      {"-", brief, {}, 0, 9},
      {"-", "seconds = 0\n", {}, 0, 0},
      {"", "", {}, 0, 0},
      {"", "relax = false\n", {}, 0, 0},
      {"good", few, {}, 50, 0},
      {"draft", few, {}, 50, 0},
      {"good", "trials = 0\n", {}, 0, 0},
      {"good", brief, {}, 0, 9},
      {"draft", brief, {}, 0, 9},
      {"good", few + brief, {}, 50, 9},
      {"", few + brief, {}, 50, 9},
      {"good", "relax = false\n", {}, 300, 0},
      // A word on the command line takes precedence over the whole file.
      {"-", "", {"quality=best"}, 2400, 0},
      {"-", few, {"quality=best"}, 2400, 0},
      {"-", brief, {"quality=best"}, 2400, 0},
      {"-", few + brief, {"quality=best"}, 2400, 0},
      {"-", few + brief, {"quality=draft"}, 0, 0},
      {"draft", "", {"quality=good"}, 300, 0},
      {"draft", few, {"quality=good"}, 300, 0},
      {"-", few, {"quality=best", " quality = 'good' "}, 300, 0},
      // An empty word leaves the number to [improve].
      {"-", "", {"quality="}, 0, 0},
      {"good", "", {"quality="}, 0, 0},
      {"good", "", {"quality=''"}, 0, 0},
      {"good", few, {"quality="}, 50, 0},
      {"-", few, {"quality=best", "quality="}, 50, 0},
      {"good", few, {"quality=", "quality=best"}, 2400, 0},
      // Numbers on the command line take precedence over every word, and also work without a word.
      {"-", "", {"improve.trials=7"}, 7, 0},
      {"-", "", {"improve.trials=0"}, 0, 0},
      {"-", "", {"improve.seconds=3"}, 0, 3},
      {"-", "", {"improve.relax=false"}, 300, 0},
      {"best", "", {"improve.trials=7"}, 7, 0},
      {"best", few, {"improve.trials=7"}, 7, 0},
      {"best", "", {"improve.trials=0"}, 0, 0},
      {"best", "", {"improve.seconds=3"}, 0, 3},
      {"best", few, {"improve.seconds=3"}, 50, 3},
      {"-", "", {"quality=best", "improve.trials=7"}, 7, 0},
      {"-", "", {"improve.trials=7", "quality=best"}, 7, 0},
      {"good", brief, {"improve.trials=7", "quality=draft"}, 7, 9},
      {"-", "", {"quality=best", "improve.seconds=3"}, 0, 3},
      {"-", few, {"improve.seconds=3", "quality=best"}, 50, 3},
      {"good", "", {"quality=", "improve.trials=7"}, 7, 0},
      {"-", few, {"quality=good", "improve.relax=false"}, 300, 0}};
  for (const Case& c : cases) {
    const std::string top = c.of_file == "-" ? "" : "quality = '" + c.of_file + "'\n";
    const ImproveSettings improve = load(top, "[improve]\n" + c.keys, c.overrides).settings.improve;
    std::string name = top + c.keys;
    for (const std::string& text : c.overrides) name += " --set " + text;
    EXPECT_EQ(improve.trials, c.trials) << name;
    EXPECT_EQ(improve.seconds, c.seconds) << name;
  }
}

TEST_F(QualityOfAJob, is_a_number_in_the_job_that_is_written) {
  for (const Job& job : {load("quality = 'best'\n"), load("", "[improve]\ntrials = 50\n", {"quality=best"})}) {
    const std::string written = to_toml(job);
    EXPECT_NE(written.find("\nquality = \"\"\n"), std::string::npos) << written;
    EXPECT_NE(written.find("\ntrials = 2400\n"), std::string::npos) << written;
    EXPECT_EQ(to_toml(JobFile::load(written)), written);
    EXPECT_EQ(to_toml(job_from_toml(written, "elsewhere/job.toml")), written);
  }
  EXPECT_EQ(to_toml(load("quality = 'good'\n", "[improve]\ntrials = 50\n")),
            to_toml(load("", "[improve]\ntrials = 50\n")))
      << "a word that had no say";
}

/// Results of versions without this key hold only the number.
TEST_F(QualityOfAJob, does_not_count_in_a_written_job_without_the_key) {
  for (const char* word : {"draft", "good", "best"}) {
    const Job job = load(std::string("quality = '") + word + "'\n");
    std::string written = to_toml(job);
    const std::string line = "\nquality = \"\"\n";
    ASSERT_NE(written.find(line), std::string::npos);
    written.replace(written.find(line), line.size(), "\n");
    EXPECT_EQ(JobFile::load(written).settings.improve.trials, job.settings.improve.trials) << word;
    EXPECT_EQ(to_toml(job_from_toml(written, "elsewhere/job.toml")), to_toml(job)) << word;
  }
}

TEST_F(QualityOfAJob, of_the_command_line_wins_over_the_number_of_a_written_job) {
  const std::string written = to_toml(load("quality = 'good'\n"));
  EXPECT_EQ(JobFile::load(written, {"quality=draft"}).settings.improve.trials, 0);
}

TEST_F(QualityOfAJob, is_one_of_three_words) {
  const std::string allowed = ", allowed: \"\" or \"draft\" or \"good\" or \"best\"";
  EXPECT_EQ(mistake("quality = 'great'\n" + minimal_), "job.toml:1: quality: found \"great\"" + allowed);
  EXPECT_EQ(mistake("quality = 3\n" + minimal_), "job.toml:1: quality: found 3" + allowed);
  EXPECT_EQ(mistake("quality = ['good']\n" + minimal_), "job.toml:1: quality: found [ \"good\" ]" + allowed);
  EXPECT_EQ(mistake(minimal_, {"quality=Good"}), "--set quality=Good: quality: found \"Good\"" + allowed);
  EXPECT_EQ(mistake("quality = good\n" + minimal_).substr(0, 21), "job.toml:1: not TOML:");
  EXPECT_EQ(mistake("quality = 'great'\n" + minimal_, {"improve.trials=7"}),
            "job.toml:1: quality: found \"great\"" + allowed)
      << "where it has no say, too";
}

TEST_F(QualityOfAJob, decides_where_pieces_lie) {
  Job job = load("");
  EXPECT_EQ(test::message_of([&] { set_drawing_keys(job, {"quality=best"}); }),
            "--set quality=best: allowed where a result is drawn: output.key=value or colour.key=value");
}

TEST_F(QualityOfAJob, varies_in_a_campaign) {
  const std::vector<Variation> variations = make_variations("", {"quality=draft,good"});
  ASSERT_EQ(variations.size(), 2u);
  EXPECT_EQ(variations[0].name, "quality_draft");
  EXPECT_EQ(variations[1].name, "quality_good");
  EXPECT_EQ(load("", "", variations[0].overrides).settings.improve.trials, 0);
  EXPECT_EQ(load("", "", variations[1].overrides).settings.improve.trials, 300);
}

/// docs/gallery shows the job with this number.
TEST(DemosJob, has_300_trials) {
  EXPECT_EQ(load_job(TESSERA_SOURCE_DIR "/jobs/animals.toml", {}).settings.improve.trials, 300);
}

}  // namespace test_quality_word
}  // namespace tessera
