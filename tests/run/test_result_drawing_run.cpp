// The messages of drawing a result about the layers around foreign drawings.
#include "run/result_drawing_run.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "support/scratch_folder.h"

namespace tessera::cli {
namespace test_result_drawing_run {

class ToldLayers : public testing::Test {
 protected:
  /// The text on stderr.
  std::string told(const DrawerLayers& layers) {
    testing::internal::CaptureStderr();
    tell_layers("result", layers, log_);
    return testing::internal::GetCapturedStderr();
  }
  std::string log() const {
    std::ifstream file(scratch_.path("run.log"));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  test::ScratchFolder scratch_;
  RunLog log_{scratch_.path("")};
};

TEST_F(ToldLayers, NothingWhereAllHold) {
  EXPECT_EQ(told({}), "");
  EXPECT_EQ(log(), "");
}

TEST_F(ToldLayers, InTheLogAloneWhereTheKernelLacksOne) {
  EXPECT_EQ(told({.files = LayerState::missing}), "");
  EXPECT_NE(log().find(" info: Landlock, which this kernel lacks, "), std::string::npos) << log();
}

TEST_F(ToldLayers, AsAWarningWhereOneFailed) {
  EXPECT_TRUE(
      told({.system_calls = LayerState::failed}).starts_with("tessera: warning: result: seccomp, which failed here, "));
  EXPECT_NE(log().find(" warning: seccomp, which failed here, "), std::string::npos) << log();
}

}  // namespace test_result_drawing_run
}  // namespace tessera::cli
