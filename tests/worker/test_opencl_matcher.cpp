// It runs once as it is, and once with two devices (tests/worker/CMakeLists.txt).
#include "core/matcher_suite.h"

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "core/base/lanes.h"
#include "core/base/stop.h"
#include "core/base/stopwatch.h"
#include "core/matching/pair_limits.h"
#include "core/pad/pad_index.h"
#include "support/single_models.h"
#include "worker/device_group.h"
#include "worker/devices/opencl_devices.h"
#include "worker/opencl_matcher.h"

namespace tessera::test {
namespace test_opencl_matcher {

std::unique_ptr<Matcher> make_on_all_devices(const MatchingContext& context, std::uint32_t first,
                                             std::vector<ShapeModel> models) {
  return worker::make_device_matcher("all", context, all_of(models, first), given(models, first));
}

/// At first the device has room for only one pair and one docking.
std::unique_ptr<Matcher> make_with_little_room(const MatchingContext& context, std::uint32_t first,
                                               std::vector<ShapeModel> models) {
  return std::make_unique<worker::OpenCLMatcher>(worker::opencl_devices().front(), context, all_of(models, first),
                                                 given(models, first), worker::BetweenLaunches(), 1);
}

/// Contours and key points are read when needed, and few contours are kept.
std::unique_ptr<Matcher> make_that_reads(const MatchingContext& context, std::uint32_t first,
                                         std::vector<ShapeModel> models) {
  const ShapeRange shapes = all_of(models, first);
  return std::make_unique<worker::OpenCLMatcher>(
      worker::opencl_devices().front(), context, shapes,
      std::make_shared<SingleModels>(std::move(models), first, context.pad.levels), worker::BetweenLaunches(),
      worker::kStageBytes, worker::HeldShapes{.most_whole = 0, .contours = 3});
}

/// Uses work items as lanes, as on a GPU.
std::unique_ptr<Matcher> make_with_items_for_lanes(const MatchingContext& context, std::uint32_t first,
                                                   std::vector<ShapeModel> models) {
  return std::make_unique<worker::OpenCLMatcher>(worker::opencl_devices().front(), context, all_of(models, first),
                                                 given(models, first), worker::BetweenLaunches(), worker::kStageBytes,
                                                 worker::HeldShapes(), worker::DockingLanes::items);
}

std::vector<MatcherKind> matcher_kinds() {
  std::vector<MatcherKind> kinds = {
      {"AllDevices", make_on_all_devices}, {"LittleRoom", make_with_little_room}, {"Reads", make_that_reads}};
  if (worker::opencl_devices().front().getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>() >= kLanes) {
    kinds.push_back({"ItemsForLanes", make_with_items_for_lanes});
  }
  return kinds;
}

INSTANTIATE_TEST_SUITE_P(OpenCL, MatcherSuite, testing::ValuesIn(matcher_kinds()),
                         [](const auto& info) { return info.param.name; });

TEST(DockingLanes, AreVectorsOnACpu) {
  const cl::Device device = worker::opencl_devices().front();
  if (!(device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU)) GTEST_SKIP() << "the first device is no CPU";
  EXPECT_EQ(worker::lanes_for(device), worker::DockingLanes::vectors);
}

/// For a device that allows only groups of 8 (tests/worker/CMakeLists.txt).
TEST(DockingLanes, AreNoItemsWhereGroupsOf16AreNotAllowed) {
  if (worker::opencl_devices().front().getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>() >= kLanes) {
    GTEST_SKIP() << "runs where groups are limited";
  }
  const MatchingScene scene = make_scene(scene_settings(), {2, 150, 0, 2});
  const auto matcher = make_with_items_for_lanes(scene.context, 0, scene.models);
  set_field(*matcher, scene.field);
  try {
    run_round(*matcher, scene);
    FAIL() << "groups of 32 ran";
  } catch (const EnvironmentError& error) {
    EXPECT_NE(std::string(error.what()).find("needs work groups of 32, and the device allows 8"), std::string::npos)
        << error.what();
  }
}

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

/// Repeated samples, more than are searched at a time.
std::vector<TargetSample> repeated(const std::vector<TargetSample>& samples, std::size_t count) {
  std::vector<TargetSample> many;
  while (many.size() < count) many.push_back(samples[many.size() % samples.size()]);
  return many;
}

TEST(OpenCLMatcher, ManySamplesAreTheSameAsForTheReference) {
  MatchingScene scene = make_scene(scene_settings(), {6, 700, 9, 300});
  scene.settings.match.tangent_dockings = 5;
  scene.samples = repeated(scene.samples, 4500);
  const auto matcher = make_on_all_devices(scene.context, 0, scene.models);
  ReferenceMatcher reference(scene.context, 0, scene.models);
  set_field(*matcher, scene.field);
  set_field(reference, scene.field);
  expect_same_round(run_round(*matcher, scene), run_round(reference, scene));
}

TEST(OpenCLMatcher, BinsOfOtherSamplesThanTheLastAreRefused) {
  const MatchingScene scene = make_scene(scene_settings(), {2, 150, 0, 3});
  const CountRequest others{{}, std::vector<std::uint32_t>(scene.samples.size() + 1, 5)};
  const auto refuses = [&](Matcher& matcher) {
    matcher.post_count(count_all(scene.samples));
    matcher.take_count();
    EXPECT_THROW(matcher.post_count(others), std::logic_error);
  };
  refuses(*make_on_all_devices(scene.context, 0, scene.models));
  ReferenceMatcher reference(scene.context, 0, scene.models);
  refuses(reference);
}

/// One step searches 4,096 samples: it waits for one launch and posts the next, so that a caller keeps several devices busy.
/// take_count has nothing left to wait for.
TEST(OpenCLMatcher, CountsInSteps) {
  const MatchingScene scene = make_scene(scene_settings(), {6, 700, 9, 300});
  const CountRequest request{repeated(scene.samples, 9000), std::vector<std::uint32_t>(9000, 9)};
  int launches = 0;
  worker::OpenCLMatcher matcher(worker::opencl_devices().front(), scene.context, all_of(scene.models),
                                given(scene.models), [&] { ++launches; });
  matcher.post_count(request);
  int steps = 1;
  for (int before = launches; matcher.step_count(); before = launches, ++steps) EXPECT_LE(launches - before, 2);
  EXPECT_EQ(steps, 3);
  const int launches_of_steps = launches;
  const std::vector<DistanceHistogram> counted = matcher.take_count();
  EXPECT_EQ(launches, launches_of_steps);
  ReferenceMatcher reference(scene.context, 0, scene.models);
  reference.post_count(request);
  EXPECT_EQ(counted, reference.take_count());
}

/// `count` models, which differ by their discs.
std::vector<ShapeModel> copies(const std::vector<ShapeModel>& models, int count) {
  std::vector<ShapeModel> many;
  for (int i = 0; i < count; ++i) {
    many.push_back(models[std::size_t(i * 7) % models.size()]);
    many.back().disc_radius *= 0.5f + 0.0002f * float(i);
  }
  return many;
}

/// There are more shapes than go to the device at a time, and more than one segment of the index holds.
TEST(OpenCLMatcher, ALargeLibraryIsTheSameAsForTheReference) {
  MatchingScene scene = make_scene(scene_settings(), {10, 200, 3, 3});
  scene.models = copies(scene.models, 2200);
  scene.context = make_matching_context(scene.settings, std::uint32_t(scene.models.size()));
  const auto matcher = make_on_all_devices(scene.context, 0, scene.models);
  ReferenceMatcher reference(scene.context, 0, scene.models);
  set_field(*matcher, scene.field);
  set_field(reference, scene.field);
  expect_same_round(run_round(*matcher, scene), run_round(reference, scene));

  // Only the first segment, for samples that the device already has.
  CountRequest first_segment = count_all(scene.samples);
  first_segment.segment_stride = 2;
  matcher->post_count(first_segment);
  reference.post_count(first_segment);
  const std::vector<DistanceHistogram> counted = matcher->take_count();
  EXPECT_EQ(counted, reference.take_count());
  reference.post_count(count_all(scene.samples));
  EXPECT_NE(counted, reference.take_count());
  expect_same_round(run_round(*matcher, scene), run_round(reference, scene));
}

/// Each of two ranks has some shapes of a large library, within two segments.
/// First the pairs are estimated from every 16th segment, for which the samples are sent. Then all ranks are asked, as far as each sample
/// looks.
TEST(OpenCLMatcher, PairLimitsOfALargeLibraryAreThoseOfAllItsPairs) {
  MatchingScene scene = make_scene(scene_settings(), {10, 200, 3, 5});
  constexpr std::uint32_t kShapes = 200 * kSegmentShapes;
  constexpr std::uint64_t kPairs = 50;
  scene.context = make_matching_context(scene.settings, kShapes);
  const std::vector<ShapeModel> models = copies(scene.models, 400);
  std::vector<std::unique_ptr<Matcher>> parts;
  std::vector<DistanceHistogram> all(scene.samples.size());
  const auto add = [](std::vector<DistanceHistogram>& sum, const std::vector<DistanceHistogram>& more) {
    ASSERT_EQ(sum.size(), more.size());
    for (std::size_t t = 0; t < sum.size(); ++t) {
      std::transform(more[t].begin(), more[t].end(), sum[t].begin(), sum[t].begin(), std::plus<>());
    }
  };
  for (const std::uint32_t first : {kSegmentShapes - 300, 16 * kSegmentShapes - 150}) {
    parts.push_back(make_on_all_devices(scene.context, first, models));
    ReferenceMatcher reference(scene.context, first, models);
    reference.post_count(count_all(scene.samples));
    add(all, reference.take_count());
  }
  std::vector<std::uint32_t> strides;
  const auto count = [&](const std::vector<std::uint32_t>& bins, std::uint32_t stride) {
    const std::vector<TargetSample> sent = strides.empty() ? scene.samples : std::vector<TargetSample>();
    strides.push_back(stride);
    std::vector<DistanceHistogram> sum(
        std::size_t(std::count_if(bins.begin(), bins.end(), [](auto b) { return b > 0; })));
    for (const auto& part : parts) {
      part->post_count({sent, bins, stride});
      add(sum, part->take_count());
    }
    return sum;
  };
  const std::vector<std::uint32_t> limits = pair_limits(scene.samples.size(), kPairs, kShapes, count);
  ASSERT_EQ(limits.size(), all.size());
  for (std::size_t t = 0; t < all.size(); ++t) EXPECT_EQ(limits[t], bin_limit_for(all[t], kPairs));
  EXPECT_EQ(strides.front(), 16u);
  EXPECT_EQ(strides.back(), 1u);
}

/// A caller with several devices posts to one after the other, and must not wait for the work of an earlier one.
TEST(OpenCLMatcher, PostingPairsDoesNotWaitForRandomDraws) {
  const MatchingScene scene = make_scene(scene_settings(), {6, 700, 9, 300});
  const std::vector<TargetSample> samples = repeated(scene.samples, 300);
  worker::OpenCLMatcher matcher(worker::opencl_devices().front(), scene.context, all_of(scene.models),
                                given(scene.models));
  set_field(matcher, scene.field);
  matcher.post_count(count_all(samples));
  matcher.take_count();
  struct Least {
    double posting_s = 1e9;  // the best of several times, as other work may disturb one of them
    double whole_s = 1e9;
  };
  const auto dock = [&](std::uint32_t bins, Least& least) {
    const Stopwatch watch;
    matcher.post_dock({samples, std::vector<std::uint32_t>(samples.size(), bins), 5000});
    least.posting_s = std::min(least.posting_s, watch.seconds());
    const std::vector<Docking> docked = matcher.take_dock().dockings;
    least.whole_s = std::min(least.whole_s, watch.seconds());
    EXPECT_EQ(std::any_of(docked.begin(), docked.end(), [](const Docking& d) { return d.source < kTangentSource; }),
              bins > 0);
  };
  Least draws, pairs_and_draws;
  for (int i = 0; i < 5; ++i) {  // in turns, so that other work disturbs both
    dock(0, draws);
    dock(30, pairs_and_draws);
  }
  if (draws.whole_s < 0.1) GTEST_SKIP() << "this device is so fast that it shows nothing";
  if (draws.posting_s > 0.1 * draws.whole_s) GTEST_SKIP() << "this device does its work within the post";
  EXPECT_LT(pairs_and_draws.posting_s, draws.posting_s + 0.3 * draws.whole_s);
}

/// A scene of a library so large that draws come from a deck. The matchers have ten of the deck's shapes.
MatchingScene scene_of_a_large_library(bool with_colours, std::uint32_t& first_shape) {
  constexpr std::uint32_t kShapes = kWholeDeck + 5000;
  CollageSettings settings = scene_settings();
  settings.match.tangent_dockings = 3000;
  if (with_colours) {
    std::vector<Lab> of_shapes;
    for (std::uint32_t i = 0; i < kShapes; ++i) of_shapes.push_back(numbered_colour(i / 16));
    settings.colour = wish_for(picture(260, 260, [](Vec2) { return opaque(numbered_colour(3)); }), of_shapes);
  }
  MatchingScene scene = make_scene(settings, {.samples = 4});
  scene.context = make_matching_context(settings, kShapes);
  const Deck deck = draw_deck(scene.context.seed, scene.samples, kShapes, kShapes, 0);
  first_shape = deck.open[deck.open.size() / 2] / kDeckRun * kDeckRun;
  return scene;
}

TEST(OpenCLMatcher, ADeckIsTheSameAsForTheReference) {
  for (const bool with_colours : {false, true}) {
    std::uint32_t first = 0;
    const MatchingScene scene = scene_of_a_large_library(with_colours, first);
    ReferenceMatcher reference(scene.context, first, scene.models);
    set_field(reference, scene.field);
    const Round expected = run_round(reference, scene);
    EXPECT_TRUE(std::any_of(expected.docked.dockings.begin(), expected.docked.dockings.end(),
                            [](const Docking& d) { return d.source >= kTangentSource; }));
    for (const auto& make : {make_on_all_devices, make_that_reads}) {
      const auto matcher = make(scene.context, first, scene.models);
      set_field(*matcher, scene.field);
      expect_same_round(run_round(*matcher, scene), expected);
    }
  }
}

/// A contour that is kept is not read again. A contour of another part of the library is never read.
TEST(DeviceContours, AreReadOnce) {
  const MatchingScene scene = make_scene(scene_settings(), {6, 150, 0, 2});
  const auto models = std::make_shared<SingleModels>(scene.models, 100, scene.context.pad.levels);
  worker::DeviceLibrary library(worker::opencl_devices().front(), scene.context, {100, 106}, models, {},
                                {.most_whole = 0, .contours = 4});
  const auto need = [&](std::vector<std::uint32_t> shapes) {
    std::vector<ShapeId> ids;
    for (const std::uint32_t shape : shapes) ids.push_back(ShapeId{shape});
    const std::size_t before = models->contours_read();
    library.contours().need(ids);
    return models->contours_read() - before;
  };
  EXPECT_EQ(need({100, 103, 103, 99, 106}), 2u);
  EXPECT_EQ(need({103, 100}), 0u);
  EXPECT_EQ(need({100, 101, 102}), 2u);
  EXPECT_EQ(need({100, 103, 104}), 1u) << "one that is not needed makes room";
  EXPECT_EQ(need({100, 103, 104}), 0u);
  EXPECT_EQ(need({100, 101, 102, 103, 104, 105}), 6u) << "more than there are places: all are read anew";
  EXPECT_EQ(need({105, 101}), 0u);
}

TEST(OpenCLMatcher, AQuestionIsGivenUpBetweenLaunches) {
  const MatchingScene scene = make_scene(scene_settings(), {2, 150, 0, 2});
  int calls = 0;
  int left = -1;
  const auto between_launches = [&] {
    ++calls;
    if (--left == 0) throw Interrupted{StopReason::signal};
  };
  worker::OpenCLMatcher matcher(worker::opencl_devices().front(), scene.context, all_of(scene.models),
                                given(scene.models), between_launches);
  set_field(matcher, scene.field);
  run_round(matcher, scene);
  const int calls_of_a_round = calls - 1;  // one call was that of the upload
  ASSERT_GT(calls_of_a_round, 5);
  left = calls_of_a_round / 2;
  matcher.limit({});  // otherwise the matcher would remember the pairs
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

}  // namespace test_opencl_matcher
}  // namespace tessera::test
