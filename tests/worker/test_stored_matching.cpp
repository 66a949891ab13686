// A device that reads models from a library file gives the same results as the reference with models made from its shapes.
#include <gtest/gtest.h>

#include "core/matching/reference_matcher.h"
#include "library/storage/shape_models.h"
#include "support/many_shapes.h"
#include "support/matcher_round.h"
#include "support/scratch_folder.h"
#include "worker/devices/opencl_devices.h"
#include "worker/opencl_matcher.h"

namespace tessera::test {
namespace test_stored_matching {

constexpr std::uint32_t kShapes = kSegmentShapes + 150;

/// The shapes are a part of one segment and all of the next. They are more than go to the device at a time; nothing that can be read is
/// kept.
TEST(StoredMatching, IsTheSameAsForTheReference) {
  const test::ScratchFolder folder;
  write_many_shapes(folder.path("many.h5"), kShapes);
  const LibraryFile library(folder.path("many.h5"));
  for (const bool limits_rotations : {false, true}) {
    CollageSettings settings = scene_settings();
    if (limits_rotations) settings.pieces.max_rotation_rad = 0.4f;
    MatchingScene scene = make_scene(settings, {10, 200, 3, 4});
    scene.context = make_matching_context(settings, kShapes);
    const ShapeRange range{kSegmentShapes - 500, kShapes};
    const auto stored = library.stored_models(scene.context);
    ASSERT_NE(stored, nullptr);
    worker::OpenCLMatcher matcher(worker::opencl_devices().front(), scene.context, range, stored,
                                  worker::BetweenLaunches(), worker::kStageBytes,
                                  worker::HeldShapes{.most_whole = 0, .contours = 40});
    const std::vector<ShapeModel> made = read_models(library, range, scene.context);
    ReferenceMatcher reference(scene.context, range.begin, made);
    set_field(matcher, scene.field);
    set_field(reference, scene.field);
    const Round expected = run_round(reference, scene);
    EXPECT_FALSE(expected.refined.empty());
    expect_same_round(run_round(matcher, scene), expected);
  }
}

}  // namespace test_stored_matching
}  // namespace tessera::test
