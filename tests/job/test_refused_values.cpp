// Values that no key accepts, in the job file and as an argument.
#include "job_file_fixture.h"

namespace tessera {
namespace test_refused_values {

class RefusedValue : public JobFile, public testing::WithParamInterface<const char*> {};

TEST_P(RefusedValue, in_file_and_argument) {
  const std::string assignment = GetParam();
  const auto dot = assignment.find('.');
  EXPECT_NE(mistake("[" + assignment.substr(0, dot) + "]\n" + assignment.substr(dot + 1)).find(", allowed: "),
            std::string::npos);
  const std::string message = mistake(minimal_, {assignment});
  EXPECT_EQ(message.find("--set " + assignment + ": "), 0u) << message;
  EXPECT_NE(message.find(", allowed: "), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    WrongTypeOrRange, RefusedValue,
    testing::Values(
        "canvas.size_px = 1000", "canvas.size_px = [1000]", "canvas.size_px = [10.5, 1000]",
        "canvas.size_px = [15, 1000]", "canvas.size_px = [20001, 1000]", "canvas.size_px = [20000, 20000]",
        "canvas.size_px = [\"a\", 1000]", "canvas.file = 3", "canvas.seamless = \"X\"", "canvas.seamless = true",
        "canvas.file = \"a\\u0000b\"", "library.file = true", "library.file = [\"a\", \"b\"]", "pieces.scale_px = []",
        "pieces.scale_px = [30, 20]", "pieces.scale_px = [[20, 30, 40]]", "pieces.scale_px = [[]]",
        "pieces.scale_px = [1, 20]", "pieces.scale_px = [20, 1e9]", "pieces.scale_px = [nan, 20]",
        "pieces.scale_px = [1, 2, 3]", "pieces.rotation_deg = [[0, 90], [90, -90]]", "pieces.rotation_deg = [0, \"x\"]",
        "pieces.rotation_deg = [1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1]", "pieces.rotation_deg = [90, -90]",
        "pieces.rotation_deg = [-400, 0]", "pieces.uses = -1", "pieces.uses = 1.5", "pieces.padding_px = -0.1",
        "pieces.balance = -0.1", "pieces.balance = 1.1", "pieces.balance = \"even\"", "pieces.overlap_px = -1",
        "pieces.overlap_px = 2.6", "match.levels = 1", "match.levels = 7", "match.levels = \"5\"",
        "match.delta_tau = 0", "match.top_percent = 0", "match.top_percent = 101", "match.beta = nan",
        "match.beta = inf", "match.tangent_dockings = 1e5", "match.delta_px = 0", "objective.kind = \"Paper\"",
        "objective.kind = 1", "objective.near_twin_factor = 1.1", "objective.scale_exponent = -1", "stop.coverage = 0",
        "stop.coverage = 1.01", "stop.seconds = -1", "stop.pieces = false", "devices.use = \"cpux\"",
        "colour.harmony = \"v\"", "colour.harmony = \"N\"", "colour.harmony = \"\"", "colour.harmony = 1",
        "colour.harmony = true", "colour.harmony = [\"V\"]", "devices.use = \"\"", "devices.use = \"0;1\"",
        "devices.use = [0, 0]", "devices.use = []", "devices.use = [0.5]", "devices.use = -1", "devices.use = \"0,99\"",
        "output.width_px = 63", "output.width_px = 1e4", "output.background = \"red\"", "output.background = \"#ffff\"",
        "output.background = \"#gggggg\"", "output.background = 1979-05-27", "output.background = {r = 1}",
        "output.background = \"None\"", "output.width_mm = -1", "output.width_mm = 1e6", "output.dpi = 0",
        "output.dpi = \"300\"", "output.outline_px = -1", "output.outline_colour = \"none\"",
        "output.shadow_strength = 1.1", "output.shadow_offset_px = 3", "output.shadow_offset_px = [1, 2, 3]",
        "output.shadow_offset_px = [0, 1e3]", "output.shadow_blur_px = 0", "output.clip = \"box\"", "output.ground = 3",
        "output.ground_px = -1", "output.ground_px = 20001", "output.ground_px = \"512\"", "output.labels = 1",
        "output.labels = \"true\"", "output.labels = []"));

}  // namespace test_refused_values
}  // namespace tessera
