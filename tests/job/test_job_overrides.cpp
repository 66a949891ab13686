// Keys given besides the job file: for a run, and to draw a result.
#include <filesystem>

#include "job_file_fixture.h"

namespace tessera {
namespace test_job_overrides {

TEST_F(JobFile, overrides_win_and_the_last_one_most) {
  const Job job = load(minimal_ + "[pieces]\nscale_px = [20, 160]\n",
                       {"pieces.scale_px=[14,180]", "seed=5", "seed = 6", "stop.coverage=0.5"});
  EXPECT_EQ(job.settings.pieces.min_scale_px, 14);
  EXPECT_EQ(job.settings.pieces.max_scale_px, 180);
  EXPECT_EQ(job.settings.seed, 6u);
  EXPECT_EQ(job.settings.stop.coverage, 0.5f);
}

TEST_F(JobFile, overrides_need_no_quotes) {
  const Job job = load(minimal_, {"devices.use=0,2", "output.background=#102030", "objective.kind=paper",
                                  "canvas.seamless=y", "library.file=\"a b.h5\""});
  EXPECT_EQ(job.devices, "0,2");
  EXPECT_EQ(job.output.background, "#102030");
  EXPECT_EQ(job.settings.objective.kind, Objective::paper);
  EXPECT_EQ(job.canvas.seamless, Seamless::y);
  EXPECT_EQ(job.library, std::filesystem::current_path() / "a b.h5");
}

TEST_F(JobFile, a_background_may_be_none) {
  EXPECT_EQ(load(minimal_, {"output.background=none"}).output.background, kNoColour);
}

TEST_F(JobFile, a_shadow_may_lie_on_any_side) {
  const Job job = load(minimal_, {"output.shadow_offset_px=[3.5,-200]"});
  EXPECT_EQ(job.output.shadow_offset_px[0], 3.5);
  EXPECT_EQ(job.output.shadow_offset_px[1], -200);
}

TEST_F(JobFile, of_a_result_only_output_and_colours_may_change) {
  Job job = load(minimal_, {});
  EXPECT_TRUE(set_drawing_keys(
      job, {"output.width_mm=100", "output.width_mm = 200", "output.background=none", " colour . palette=ink"}))
      << "colours are asked for";
  EXPECT_FALSE(set_drawing_keys(job, {"output.outline_colour=#000000", "output.background=none", "colour.shift=3"}))
      << "of lines and tones, not of silhouettes";
  EXPECT_EQ(job.output.width_mm, 200);
  EXPECT_EQ(job.colour.palette, std::vector<std::string>{"ink"});
  EXPECT_EQ(job.output.background, kNoColour);
  EXPECT_EQ(test::message_of([&] { set_drawing_keys(job, {"seed=2"}); }),
            "--set seed=2: allowed where a result is drawn: output.key=value or colour.key=value");
  EXPECT_EQ(test::message_of([&] { set_drawing_keys(job, {"output.dpi=x"}); }),
            "--set output.dpi=x: output.dpi: found \"x\", allowed: a number from 1 to 4800 px per inch");
}

TEST_F(JobFile, override_mistakes_name_the_argument) {
  EXPECT_EQ(mistake(minimal_, {"pieces.scale=3"}).substr(0, 77),
            "--set pieces.scale=3: unknown key pieces.scale (did you mean pieces.scale_px?");
  EXPECT_EQ(mistake(minimal_, {"seed"}), "--set seed: allowed: section.key=value");
  EXPECT_EQ(mistake(minimal_, {"=1"}), "--set =1: allowed: section.key=value");
  EXPECT_NE(mistake(minimal_, {"seed=1\nx=2"}).find("seed: found \"1\\nx=2\""), std::string::npos);
  EXPECT_NE(mistake(minimal_, {"pieces.uses.more=1"}).find("unknown key pieces.uses.more"), std::string::npos);
  EXPECT_NE(mistake(minimal_, {"seed=" + std::string(100000, '{')}).find("longer than"), std::string::npos);
}

TEST_F(JobFile, paths_are_relative_to_the_file_or_the_working_directory) {
  EXPECT_EQ(load("[library]\nfile = \"../x/./y.h5\"").library,
            std::filesystem::path(folder_.path("../x/y.h5")).lexically_normal());
  EXPECT_EQ(load(minimal_, {"library.file=y.h5"}).library, std::filesystem::current_path() / "y.h5");
}

}  // namespace test_job_overrides
}  // namespace tessera
