// The kernels against core, bit for bit. Small probe kernels test their building blocks.
// The rest runs on random numbers, which reach more special cases of the arithmetic than real shapes do.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <memory>
#include <random>

#include "core/base/lanes.h"
#include "core/base/portable_math.h"
#include "core/matching/reference_matcher.h"
#include "support/matcher_round.h"
#include "worker/devices/device_kernel.h"
#include "worker/devices/kernel_options.h"
#include "worker/devices/opencl_devices.h"
#include "worker/opencl_matcher.h"

namespace tessera::worker {
namespace test_kernels {

const char* const kProbes = R"(
kernel void probe_exp2(global const float* x, global float* result) {
  result[get_global_id(0)] = portable_exp2(x[get_global_id(0)]);
}

kernel void probe_mix_bits(global const ulong* key, global ulong* bits, global float* unit) {
  const size_t i = get_global_id(0);
  bits[i] = mix_bits(key[i]);
  unit[i] = unit_float((uint)(bits[i] >> 32));
}

// Work items of a docking: 16 points.
DOCKING_KERNEL void probe_field(constant MatchRecord* match, global const float* value, global const float* x,
                        global const float* y, global float* looked_up, global float* sampled, global float* slope_x,
                        global float* slope_y) {
  SHARED int scratch[kScratch];
  const Lanes lanes = lanes_of_docking(scratch);
  const int i = (int)get_global_id(0) / kItems;
  const Field field = free_field(match, value);
  const LaneFloat px = load_lanes(lanes, i, x);
  const LaneFloat py = load_lanes(lanes, i, y);
  const FieldSamples samples = field_samples(&field, px, py);
  const float16 all_looked_up = floats_of_lanes(lanes, field_values(&field, px, py));
  const float16 all_sampled = floats_of_lanes(lanes, samples.value);
  const float16 all_slopes_x = floats_of_lanes(lanes, samples.gradient_x);
  const float16 all_slopes_y = floats_of_lanes(lanes, samples.gradient_y);
  if (lanes.item != 0) return;
  vstore16(all_looked_up, i, looked_up);
  vstore16(all_sampled, i, sampled);
  vstore16(all_slopes_x, i, slope_x);
  vstore16(all_slopes_y, i, slope_y);
}

// For each 16 numbers, writes the ten numbers that the lanes compute together.
DOCKING_KERNEL void probe_lanes(global const float* numbers, global float* said) {
  SHARED int scratch[kScratch];
  SHARED float shared_numbers[kLanes];
  const Lanes lanes = lanes_of_docking(scratch);
  const int i = (int)get_global_id(0) / kItems;
  const LaneFloat v = load_lanes(lanes, i, numbers);
  store_lanes(lanes, v, 0, shared_numbers);
  sync_lanes();
  const LaneFloat several[3] = {v, v * 3, v * v};
  float sums[3];
  sums_of_lanes(lanes, 3, several, sums);
  const float sum = sum_of_lanes(lanes, v);
  const LaneInt set = v > 0;
  const int count = count_lanes(lanes, set);
  const int any = any_lane(lanes, v > 0.9f) ? 1 : 0;
  int before = count - 1;
  const int last = set_lane(lanes, set, &before);
  const float smallest = smallest_lane(lanes, v);
  const float largest = largest_lane(lanes, v);
  const int numbered = int_sum_of_lanes(lanes, numbers_of_block(lanes, 2));
  if (lanes.item != 0) return;
  const float16 all = (float16)(sum, sums[0], sums[1], sums[2], count, any, last, smallest, largest, numbered,
                                shared_numbers[13], 0, 0, 0, 0, 0);
  vstore16(all, i, said);
}
)";

std::string name_of(DockingLanes lanes) { return lanes == DockingLanes::items ? "items" : "vectors"; }

constexpr std::array kBothLanes = {DockingLanes::vectors, DockingLanes::items};

/// The program with the probes, built once in both ways. It is freed before main ends, because the OpenCL runtime may end then.
class Kernels : public testing::TestWithParam<DockingLanes> {
 protected:
  static void SetUpTestSuite() {
    const cl::Device device = opencl_devices().front();
    for (const DockingLanes lanes : kBothLanes) {
      sessions_[lanes] =
          std::make_unique<DeviceSession>(device, std::string(kernel_source) + kProbes, kernel_options(5, lanes));
    }
  }
  static void TearDownTestSuite() { sessions_.clear(); }
  static const DeviceSession& session() { return *sessions_.at(GetParam()); }

  /// Work for blocks of 16 numbers each.
  static WorkSize blocks(std::size_t count) {
    const std::size_t items = items_of_docking(GetParam());
    return {count * items, 1, items};
  }

 private:
  inline static std::map<DockingLanes, std::unique_ptr<DeviceSession>> sessions_;
};

INSTANTIATE_TEST_SUITE_P(Lanes, Kernels, testing::ValuesIn(kBothLanes),
                         [](const auto& info) { return name_of(info.param); });

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  int below(int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(engine_); }
  std::uint64_t bits() { return std::uniform_int_distribution<std::uint64_t>()(engine_); }
  Vec2 point(float reach) { return {between(-reach, reach), between(-reach, reach)}; }

 private:
  std::mt19937 engine_;
};

/// Counts the floats that differ in their bits. The message shows one example.
void expect_same_bits(const std::vector<float>& found, const std::vector<float>& expected, const char* what) {
  ASSERT_EQ(found.size(), expected.size());
  std::size_t differing = 0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (std::bit_cast<std::uint32_t>(found[i]) == std::bit_cast<std::uint32_t>(expected[i])) continue;
    ++differing;
    if (std::abs(found[i] - expected[i]) >= std::abs(found[worst] - expected[worst])) worst = i;
  }
  EXPECT_EQ(differing, 0u) << what << ": " << differing << " of " << found.size() << " differ, the most at " << worst
                           << ": " << found[worst] << " for " << expected[worst];
}

TEST_P(Kernels, Exp2) {
  Random random(1);
  std::vector<float> x = {0.f, -0.f, 1.f, -1.f, 63.9f, -63.9f, 0.99999994f, -1e-20f};
  while (x.size() < 4096) x.push_back(random.between(-64, 64));
  std::vector<float> expected;
  for (const float v : x) expected.push_back(portable_exp2(v));
  DeviceBuffer<float> input(session(), x);
  DeviceBuffer<float> output(session());
  output.reserve(x.size());
  DeviceKernel(session(), "probe_exp2").launch({x.size()}, {{"x", input}, {"result", output}});
  expect_same_bits(output.read(x.size()), expected, "portable_exp2");
}

TEST_P(Kernels, RandomBits) {
  Random random(2);
  std::vector<std::uint64_t> keys = {0, 1, ~std::uint64_t(0), std::uint64_t(1) << 63};
  while (keys.size() < 4096) keys.push_back(random.bits());
  std::vector<std::uint64_t> expected_bits;
  std::vector<float> expected_unit;
  for (const std::uint64_t key : keys) {
    expected_bits.push_back(mix_bits(key));
    expected_unit.push_back(unit_float(std::uint32_t(expected_bits.back() >> 32)));
  }
  DeviceBuffer<std::uint64_t> input(session(), keys);
  DeviceBuffer<std::uint64_t> bits(session());
  DeviceBuffer<float> unit(session());
  bits.reserve(keys.size());
  unit.reserve(keys.size());
  DeviceKernel(session(), "probe_mix_bits").launch({keys.size()}, {{"key", input}, {"bits", bits}, {"unit", unit}});
  EXPECT_EQ(bits.read(keys.size()), expected_bits);
  expect_same_bits(unit.read(keys.size()), expected_unit, "unit_float");
}

TEST_P(Kernels, WhatLanesSayTogether) {
  Random random(4);
  std::vector<float> numbers(16, -0.5f), expected;
  while (numbers.size() < 4096) numbers.push_back(random.between(-1, 1));
  for (std::size_t first = 0; first < numbers.size(); first += kLanes) {
    Lanes v, three, square;
    int count = 0, last = -1;
    for (int i = 0; i < kLanes; ++i) {
      v[i] = numbers[first + std::size_t(i)];
      three[i] = v[i] * 3;
      square[i] = v[i] * v[i];
      if (v[i] > 0) ++count, last = i;
    }
    const auto [smallest, largest] = std::minmax_element(v.begin(), v.end());
    for (const float said :
         {sum_of_lanes(v), sum_of_lanes(v), sum_of_lanes(three), sum_of_lanes(square), float(count),
          float(*largest > 0.9f), float(last), *smallest, *largest, 2 * 256 + 120.f, v[13], 0.f, 0.f, 0.f, 0.f, 0.f}) {
      expected.push_back(said);
    }
  }
  const DeviceBuffer<float> input(session(), numbers);
  DeviceBuffer<float> output(session());
  output.reserve(numbers.size());
  DeviceKernel(session(), "probe_lanes")
      .launch(blocks(numbers.size() / kLanes), {{"numbers", input}, {"said", output}});
  expect_same_bits(output.read(numbers.size()), expected, "what lanes say");
}

CanvasField random_field(Random& random, int width, int height, float reach_px) {
  CanvasField field{Grid<float>(width, height), {-5.5f, -5.5f}};
  for (float& value : field.value.data()) value = random.between(-reach_px, reach_px);
  return field;
}

/// Points mostly on the grid, also on its nodes, on its rim and far away.
std::vector<Vec2> points_on(const CanvasField& field, Random& random, std::size_t count) {
  const float width = float(field.value.width());
  const float height = float(field.value.height());
  std::vector<Vec2> points = {field.origin,
                              field.origin + Vec2{width - 1, 3},
                              field.origin + Vec2{3, height - 1},
                              field.origin + Vec2{width - 1.00001f, 3},
                              field.origin + Vec2{-1e-6f, 2},
                              {1e9f, 0},
                              {0, -1e9f}};
  for (int k = 0; k < 100; ++k) points.push_back(field.origin + Vec2{float(random.below(50)), float(random.below(40))});
  while (points.size() < count) {
    points.push_back(field.origin + Vec2{random.between(-8, width + 8), random.between(-8, height + 8)});
  }
  return points;
}

TEST_P(Kernels, FieldLookUps) {
  Random random(3);
  const CanvasField field = random_field(random, 71, 53, 30);
  const std::size_t count = 4096;
  std::vector<float> x, y, value, slope_x, slope_y;
  for (const Vec2 p : points_on(field, random, count)) {
    x.push_back(p.x);
    y.push_back(p.y);
    const FieldSample sample = field_sample(FieldView(field), p);
    ASSERT_EQ(sample.value, field_value(FieldView(field), p));
    value.push_back(sample.value);
    slope_x.push_back(sample.gradient.x);
    slope_y.push_back(sample.gradient.y);
  }
  MatchRecord match{};
  match.field_width = field.value.width();
  match.field_height = field.value.height();
  match.field_origin_x = field.origin.x;
  match.field_origin_y = field.origin.y;
  const DeviceBuffer<MatchRecord> match_buffer(session(), {match});
  const DeviceBuffer<float> field_buffer(session(), field.value.data());
  const DeviceBuffer<float> x_buffer(session(), x);
  const DeviceBuffer<float> y_buffer(session(), y);
  std::vector<DeviceBuffer<float>> results(4, DeviceBuffer<float>(session()));
  for (DeviceBuffer<float>& result : results) result.reserve(count);
  DeviceKernel(session(), "probe_field")
      .launch(blocks(count / kLanes), {{"match", match_buffer},
                                       {"value", field_buffer},
                                       {"x", x_buffer},
                                       {"y", y_buffer},
                                       {"looked_up", results[0]},
                                       {"sampled", results[1]},
                                       {"slope_x", results[2]},
                                       {"slope_y", results[3]}});
  expect_same_bits(results[0].read(count), value, "field_value");
  expect_same_bits(results[1].read(count), value, "value of field_sample");
  expect_same_bits(results[2].read(count), slope_x, "gradient x");
  expect_same_bits(results[3].read(count), slope_y, "gradient y");
}

ArclengthPyramid random_pyramid(Random& random, float unit) {
  ArclengthPyramid pyramid;
  float left = 0;
  float right = 0;
  for (int i = 0; i < kMaxPadLevels; ++i) {
    // There are few different lengths, so that equal distances are common and their order is tested.
    pyramid.left[i] = left += unit * 0.125f * float(1 + random.below(3));
    pyramid.right[i] = right += unit * 0.125f * float(1 + random.below(3));
  }
  for (int i = 0; i < int(pyramid.keypoint.size()); ++i) {
    const float angle = 0.45f * float(i);
    pyramid.keypoint[i] = Vec2{std::cos(angle), std::sin(angle)} * unit + random.point(0.08f * unit);
  }
  pyramid.convexity = float(random.below(3) - 1);
  return pyramid;
}

ShapeModel random_model(Random& random, const MatchingContext& context) {
  ShapeModel model;
  for (int i = 0; i < kBoundaryPoints; ++i) {
    const float angle = test::kTwoPi * float(i) / kBoundaryPoints;
    model.boundary[i] = Vec2{std::cos(angle), std::sin(angle)} * random.between(0.5f, 0.6f);
    model.tangent[i] = {-std::sin(angle), std::cos(angle)};
  }
  for (int i = random.below(kMaxInteriorPoints + 1); i > 0; --i) model.interior.push_back(random.point(0.4f));
  model.perimeter = random.between(3.5f, 5);
  model.radius = 0.6f;
  for (const int level : context.levels) {
    ModelLevel made;
    made.level = level;
    for (int j = 0; j < kSmoothingLevels[level].samples; ++j) {
      made.samples.push_back(
          make_model_sample(random_pyramid(random, 1), context.pad.levels, keypoint_step(model.radius)));
    }
    // These samples are equal to the bit, as on a regular polygon: equal distances and equal keys.
    for (int j = 0; j < 12; ++j) made.samples[20 + j] = made.samples[random.below(3)];
    model.levels.push_back(made);
  }
  return model;
}

/// A field with hills and hollows some ten px wide.
CanvasField wavy_field(Random& random, int size) {
  CanvasField field{Grid<float>(size, size), {-5.5f, -5.5f}};
  const float phase = random.between(0, 6);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      field.value(x, y) = 14 * std::sin(0.05f * float(x) + phase) * std::cos(0.04f * float(y)) + 2;
    }
  }
  return field;
}

test::MatchingScene random_scene(std::uint32_t seed) {
  Random random(seed);
  test::MatchingScene scene;
  scene.settings = test::scene_settings();
  scene.settings.seed = random.bits() >> 11;
  scene.settings.match.beta = 0.4f;
  scene.settings.pieces.max_scale_px = random.between(60, 250);
  scene.settings.pieces.max_rotation_rad = seed % 2 ? 1.f : 3.1415927f;
  if (seed == 7) scene.settings.pieces.min_rotation_rad = scene.settings.pieces.max_rotation_rad = 0.05f;
  scene.context = make_matching_context(scene.settings, 7);
  for (int i = 0; i < 7; ++i) scene.models.push_back(random_model(random, scene.context));
  scene.models[5] = scene.models[2];  // makes twins
  scene.field = wavy_field(random, 220);
  for (int t = 0; t < 9; ++t) {
    TargetSample sample;
    sample.id = SampleId(random.bits());
    sample.pass = std::uint32_t(random.below(4));
    sample.position = random.point(100) + Vec2{100, 100};
    const float angle = random.between(-3, 3);
    sample.tangent = {std::cos(angle), std::sin(angle)};
    sample.pyramid = random_pyramid(random, random.between(20, 80));
    for (Vec2& p : sample.pyramid.keypoint) p = p + sample.position;
    scene.samples.push_back(sample);
  }
  return scene;
}

class RandomScenes : public testing::TestWithParam<std::tuple<std::uint32_t, DockingLanes>> {
 protected:
  RandomScenes()
      : scene(random_scene(seed())),
        kernels(opencl_devices().front(), scene.context, all_of(scene.models), given(scene.models), {}, kStageBytes, {},
                std::get<DockingLanes>(GetParam())),
        reference(scene.context, 0, scene.models) {
    test::set_field(kernels, scene.field);
    test::set_field(reference, scene.field);
  }

  static std::uint32_t seed() { return std::get<std::uint32_t>(GetParam()); }

  const test::MatchingScene scene;
  OpenCLMatcher kernels;
  ReferenceMatcher reference;
};

TEST_P(RandomScenes, WholeRound) {
  const test::Round expected = test::run_round(reference, scene);
  EXPECT_FALSE(expected.docked.dockings.empty());
  EXPECT_NE(expected.histograms.front(), DistanceHistogram{});
  test::expect_same_round(test::run_round(kernels, scene), expected);
}

TEST_P(RandomScenes, AllPairs) {
  const DockRequest request{scene.samples, std::vector<std::uint32_t>(scene.samples.size(), kDistanceBins), 0};
  reference.post_dock(request);
  const DockReply expected = reference.take_dock();
  EXPECT_GT(expected.evaluated, 20u);
  kernels.post_dock(request);
  const DockReply found = kernels.take_dock();
  EXPECT_EQ(found.evaluated, expected.evaluated);
  test::expect_same_dockings(found.dockings, expected.dockings);
}

/// Dockings at random places, also outside the canvas. They reach more branches of the descent than good dockings do.
TEST_P(RandomScenes, RefinementFromAnywhere) {
  Random random(seed() + 1000);
  std::vector<Docking> dockings(200);
  for (Docking& docking : dockings) {
    docking.shape = ShapeId(random.below(int(scene.models.size())));
    const float scale = random.between(10, 260);
    const float angle = random.between(-3, 3);
    const Vec2 at = random.point(140) + Vec2{100, 100};
    docking.canvas_from_shape = {scale * std::cos(angle), scale * std::sin(angle), at.x, at.y};
  }
  reference.post_refine(dockings);
  const std::vector<RefinedDocking> expected = reference.take_refine();
  const auto is_feasible = [](const RefinedDocking& d) { return d.feasible; };
  const auto feasible = std::count_if(expected.begin(), expected.end(), is_feasible);
  EXPECT_GT(feasible, 0);
  EXPECT_LT(feasible, std::ssize(expected));
  kernels.post_refine(dockings);
  test::expect_same_refined(kernels.take_refine(), expected);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScenes, testing::Combine(testing::Range(1u, 9u), testing::ValuesIn(kBothLanes)),
                         [](const auto& info) {
                           return "seed" + std::to_string(std::get<0>(info.param)) + name_of(std::get<1>(info.param));
                         });

}  // namespace test_kernels
}  // namespace tessera::worker
