// tessera plan estimates from the resolved problem, not from the text of the job file.
#include "plan/plan_input.h"

#include <gtest/gtest.h>

#include "support/many_shapes.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_plan_input {

class PlanOfJob : public testing::Test {
 protected:
  PlanOfJob() { test::write_many_shapes(folder_.path("library.h5"), 12); }

  PlanInput input(const std::string& keys) const {
    const std::string job =
        "quality = \"draft\"\n[library]\nfile = \"library.h5\"\n[canvas]\nsize_px = [300, 200]\n" + keys;
    return plan_input(CanvasProblem(load_job(folder_.write("job.toml", job), {})), {});
  }

 private:
  test::ScratchFolder folder_;
};

/// With fit = "all" the sizes of the job only compare pieces. Sizes as large as the canvas, or larger, are planned like sizes that fit.
TEST_F(PlanOfJob, goes_by_the_sizes_that_are_found) {
  const PlanInput small = input("[pieces]\nfit = \"all\"\nuses = 1\nscale_px = [20, 40]\n");
  const PlanInput large = input("[pieces]\nfit = \"all\"\nuses = 1\nscale_px = [2000, 4000]\n");
  EXPECT_LT(large.settings.pieces.max_scale_px, 200);
  EXPECT_NEAR(large.settings.pieces.max_scale_px, small.settings.pieces.max_scale_px, 1e-2);
  const PlanEstimate plan = estimate(large), wanted = estimate(small);
  EXPECT_EQ(plan.pieces, 12 * double(large.settings.stop.coverage));
  EXPECT_EQ(plan.levels, wanted.levels);
  EXPECT_EQ(plan.pads_per_shape, wanted.pads_per_shape);
  EXPECT_EQ(plan.device_bytes, wanted.device_bytes);
  EXPECT_NEAR(plan.total_s, wanted.total_s, 1e-3 * wanted.total_s);
}

TEST_F(PlanOfJob, leaves_other_sizes_as_they_are) {
  const PlanInput plan = input("[pieces]\nscale_px = [20, 40]\n");
  EXPECT_EQ(plan.settings.pieces.min_scale_px, 20);
  EXPECT_EQ(plan.settings.pieces.max_scale_px, 40);
  EXPECT_EQ(plan.canvas_px2, 300 * 200);
}

}  // namespace test_plan_input
}  // namespace tessera
