// The values of a job's keys once its library and canvas are known.
#include "run/collage_problem.h"

#include <gtest/gtest.h>

#include "job/pieces/size_factor.h"
#include "support/many_shapes.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_collage_problem {

class ProblemOfJob : public testing::Test {
 protected:
  ProblemOfJob() { test::write_many_shapes(folder_.path("library.h5"), 12); }

  Job job(const std::string& keys, const std::vector<std::string>& overrides = {}) const {
    const std::string head = "[library]\nfile = \"library.h5\"\n[canvas]\nsize_px = [300, 200]\n";
    return load_job(folder_.write("job.toml", head + keys), overrides);
  }

  int trials(const std::string& keys, const std::vector<std::string>& overrides = {}) const {
    return CanvasProblem(job(keys, overrides)).job().settings.improve.trials;
  }

 private:
  test::ScratchFolder folder_;
};

/// With fit = "all" the sizes of the job only compare pieces with each other.
TEST_F(ProblemOfJob, trials_of_a_quality_go_by_the_sizes_that_are_found) {
  const int small = trials("[pieces]\nfit = \"all\"\nuses = 1\nscale_px = [20, 40]\n");
  EXPECT_EQ(trials("[pieces]\nfit = \"all\"\nuses = 1\nscale_px = [2000, 4000]\n"), small);
  EXPECT_GE(small, 12) << "1.35 for each of twelve pieces, but for what the canvas has beside them";
  EXPECT_LE(small, 30);
  const int best = trials("[pieces]\nfit = \"all\"\nuses = 1\nscale_px = [20, 40]\n", {"quality=best"});
  EXPECT_NEAR(best, 8 * small, 0.05 * best + 4) << "two digits each";
}

TEST_F(ProblemOfJob, other_trials_are_those_of_the_job) {
  EXPECT_EQ(trials("[pieces]\nscale_px = [20, 40]\n"), 100) << "300 x 200 / (20 x 40) x 1.35";
  EXPECT_EQ(trials("[pieces]\nfit = \"all\"\n[improve]\ntrials = 7\n"), 7);
  EXPECT_EQ(trials("[pieces]\nfit = \"all\"\n", {"quality=draft"}), 0);
  EXPECT_EQ(trials("[pieces]\nfit = \"all\"\n", {"quality="}), 0);
}

/// The other ranks, checkpoints and results get the number.
TEST_F(ProblemOfJob, the_effective_job_has_trials_instead_of_a_quality) {
  const CanvasProblem problem(job("[pieces]\nfit = \"all\"\nuses = 1\n"));
  const std::string written = to_toml(problem.job());
  EXPECT_NE(written.find("\nquality = \"\"\n"), std::string::npos);
  EXPECT_EQ(job_from_toml(written, "job.toml").settings.improve.trials, problem.job().settings.improve.trials);
  EXPECT_EQ(to_toml(job_from_toml(written, "job.toml")), written);
}

/// tessera draw reads a result's picture as finely as the run did.
TEST_F(ProblemOfJob, the_smallest_size_follows_from_a_written_job) {
  for (const char* keys :
       {"[pieces]\nscale_px = [20, 40]\n", "[pieces]\nfit = \"all\"\nuses = 1\nscale_px = [200, 400]\n",
        "[pieces]\nfit = \"all\"\nsizes = \"drawn\"\n", "[[shapes]]\nnames = \"*1*\"\nscale_px = [5, 9]\n"}) {
    const CanvasProblem problem(job(keys));
    const Job written = job_from_toml(to_toml(problem.job()), "job.toml");
    EXPECT_EQ(smallest_size_px(problem.canvas(), problem.library(), written), problem.settings().pieces.min_scale_px)
        << keys;
  }
}

}  // namespace test_collage_problem
}  // namespace tessera
