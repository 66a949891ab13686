// Runs as it is, and once more with two devices (tests/worker/CMakeLists.txt).
#include "core/matcher_suite.h"

#include <cstdlib>

#include "core/base/interrupted.h"
#include "worker/device_group.h"
#include "worker/opencl_devices.h"
#include "worker/opencl_matcher.h"

namespace tessera::test {
namespace {

std::unique_ptr<Matcher> make_on_all_devices(const MatchingContext& context, std::uint32_t first,
                                             std::vector<ShapeModel> models) {
  return worker::make_device_matcher("all", context, all_of(models, first), given(models, first));
}

/// Room on the device for one pair and one docking at first.
std::unique_ptr<Matcher> make_with_little_room(const MatchingContext& context, std::uint32_t first,
                                               std::vector<ShapeModel> models) {
  return std::make_unique<worker::OpenCLMatcher>(worker::opencl_devices().front(), context, all_of(models, first),
                                                 given(models, first), worker::BetweenLaunches(), 1);
}

INSTANTIATE_TEST_SUITE_P(OpenCL, MatcherSuite,
                         testing::Values(MatcherKind{"AllDevices", make_on_all_devices},
                                         MatcherKind{"LittleRoom", make_with_little_room}),
                         [](const auto& info) { return info.param.name; });

TEST(DeviceGroup, UsesAllDevicesThatThereAre) {
  const char* const expected = std::getenv("TESSERA_TEST_DEVICES");
  if (!expected) GTEST_SKIP() << "runs where the number of devices is set";
  EXPECT_EQ(worker::opencl_devices().size(), std::size_t(std::atoi(expected)));
  const MatchingScene scene = make_scene(scene_settings(), {2, 150, 1, 2});
  const auto matcher = make_on_all_devices(scene.context, 0, scene.models);
  EXPECT_NE(dynamic_cast<CompositeMatcher*>(matcher.get()), nullptr);
}

TEST(DeviceGroup, ManagesWithFewerShapesThanDevices) {
  const MatchingScene scene = make_scene(scene_settings(), {1, 150, 0, 2});
  const auto matcher = make_on_all_devices(scene.context, 5, scene.models);
  EXPECT_EQ(matcher->shapes().begin, 5u);
  EXPECT_EQ(matcher->shapes().end, 6u);
}

/// More than are searched at a time.
TEST(OpenCLMatcher, ManySamplesAreTheSameAsForTheReference) {
  const MatchingScene scene = make_scene(scene_settings(), {6, 700, 9, 300});
  ASSERT_GT(scene.samples.size(), 256u);
  const auto matcher = make_on_all_devices(scene.context, 0, scene.models);
  ReferenceMatcher reference(scene.context, 0, scene.models);
  set_field(*matcher, scene.field);
  set_field(reference, scene.field);
  expect_same_round(run_round(*matcher, scene), run_round(reference, scene));
}

/// 256 samples at a time, some of them farther than at first: a step waits for one launch of the search and posts the
/// next, so that whoever has several devices keeps all of them busy. Nothing is left for take_count to wait for.
TEST(OpenCLMatcher, CountsInSteps) {
  const MatchingScene scene = make_scene(scene_settings(), {6, 700, 9, 300});
  const CountRequest request{scene.samples, 50};
  int launches = 0;
  worker::OpenCLMatcher matcher(worker::opencl_devices().front(), scene.context, all_of(scene.models),
                                given(scene.models), [&] { ++launches; });
  matcher.post_count(request);
  int steps = 1;
  for (int before = launches; matcher.step_count(); before = launches, ++steps) EXPECT_LE(launches - before, 2);
  EXPECT_GT(steps, 3);
  const int launches_of_steps = launches;
  const std::vector<DistanceHistogram> counted = matcher.take_count();
  EXPECT_EQ(launches, launches_of_steps);
  ReferenceMatcher reference(scene.context, 0, scene.models);
  reference.post_count(request);
  EXPECT_EQ(counted, reference.take_count());
}

/// More shapes than go to the device at a time, and than a segment of the index has.
TEST(OpenCLMatcher, ALargeLibraryIsTheSameAsForTheReference) {
  MatchingScene scene = make_scene(scene_settings(), {10, 200, 3, 3});
  const std::vector<ShapeModel> ten = scene.models;
  for (int i = 10; i < 2200; ++i) {
    scene.models.push_back(ten[std::size_t(i * 7 % 10)]);
    scene.models.back().disc_radius *= 0.5f + 0.0002f * float(i);  // tells them apart
  }
  scene.context = make_matching_context(scene.settings, std::uint32_t(scene.models.size()));
  const auto matcher = make_on_all_devices(scene.context, 0, scene.models);
  ReferenceMatcher reference(scene.context, 0, scene.models);
  set_field(*matcher, scene.field);
  set_field(reference, scene.field);
  expect_same_round(run_round(*matcher, scene), run_round(reference, scene));
}

TEST(OpenCLMatcher, AQuestionIsGivenUpBetweenLaunches) {
  const MatchingScene scene = make_scene(scene_settings(), {2, 150, 0, 2});
  int calls = 0;
  int left = -1;
  const auto between_launches = [&] {
    ++calls;
    if (--left == 0) throw Interrupted{"signal"};
  };
  worker::OpenCLMatcher matcher(worker::opencl_devices().front(), scene.context, all_of(scene.models),
                                given(scene.models), between_launches);
  set_field(matcher, scene.field);
  run_round(matcher, scene);
  const int calls_of_a_round = calls - 1;  // one was that of the upload
  ASSERT_GT(calls_of_a_round, 5);
  left = calls_of_a_round / 2;
  matcher.limit({});  // or it would remember the pairs
  EXPECT_THROW(run_round(matcher, scene), Interrupted);
}

TEST(OpenCLMatcher, RefusesToRefineAnotherPartsShape) {
  const MatchingScene scene = make_scene(scene_settings(), {2, 150, 0, 2});
  worker::OpenCLMatcher matcher(worker::opencl_devices().front(), scene.context, all_of(scene.models, 5),
                                given(scene.models, 5));
  Docking docking;
  for (const std::uint32_t shape : {4u, 7u}) {
    docking.shape = ShapeId{shape};
    EXPECT_THROW(matcher.post_refine({docking}), std::out_of_range);
  }
}

TEST(OpenCLMatcher, RefusesModelsOfOtherLevels) {
  MatchingScene scene = make_scene(scene_settings(), {1, 150, 0, 2});
  scene.models.front().levels.pop_back();
  EXPECT_THROW(
      worker::OpenCLMatcher(worker::opencl_devices().front(), scene.context, all_of(scene.models), given(scene.models)),
      std::logic_error);
}

}  // namespace
}  // namespace tessera::test
