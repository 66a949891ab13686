// Every value comes out of a message bit for bit, also not-a-number and negative zero.
#include "comm/messages.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <system_error>

#include "comm/encode.h"
#include "core/base/error.h"

namespace tessera::comm {
namespace test_messages {

float any_float() { return std::bit_cast<float>(*rc::gen::arbitrary<std::uint32_t>()); }
Vec2 any_vec2() { return {any_float(), any_float()}; }
std::uint32_t any_index() { return *rc::gen::arbitrary<std::uint32_t>(); }

template <class Make>
auto any_vector(Make make, int most = 40) {
  std::vector<decltype(make())> values(std::size_t(*rc::gen::inRange(0, most)));
  for (auto& value : values) value = make();
  return values;
}

TargetSample any_sample() {
  TargetSample sample;
  sample.id = SampleId{any_index()};
  sample.pass = any_index();
  sample.position = any_vec2();
  sample.tangent = any_vec2();
  for (float& length : sample.pyramid.left) length = any_float();
  for (float& length : sample.pyramid.right) length = any_float();
  for (Vec2& p : sample.pyramid.keypoint) p = any_vec2();
  sample.pyramid.convexity = any_float();
  return sample;
}

Docking any_docking() {
  return {any_index(), ShapeId{any_index()}, any_index(),
          any_index(), any_float(),          {any_float(), any_float(), any_float(), any_float()}};
}

RefinedDocking any_refined() {
  return {
      any_docking(), {any_float(), any_float(), any_float(), any_float(), any_float()}, *rc::gen::arbitrary<bool>()};
}

DistanceHistogram any_histogram() {
  DistanceHistogram histogram;
  for (std::uint32_t& count : histogram) count = any_index();
  return histogram;
}

/// Compares bits: operator== calls -0 and 0 equal and no NaN equal to itself. It is only for types without padding.
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  static_assert(sizeof(T) % sizeof(float) == 0);
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_bits(const RefinedDocking& a, const RefinedDocking& b) {
  return std::memcmp(&a.docking, &b.docking, sizeof a.docking) == 0 &&
         std::memcmp(&a.terms, &b.terms, sizeof a.terms) == 0 && a.feasible == b.feasible;
}

template <class T>
T there_and_back(const T& value) {
  return decode<T>(encode(value));
}

TEST(Messages, TargetSamplesAndHistograms) {
  EXPECT_TRUE(rc::check([] {
    const auto samples = any_vector(any_sample);
    RC_ASSERT(same_bits(there_and_back(samples), samples));
    const auto histograms = any_vector(any_histogram, 4);
    RC_ASSERT(same_bits(there_and_back(histograms), histograms));
  }));
}

TEST(Messages, DockRequestsAndReplies) {
  EXPECT_TRUE(rc::check([] {
    const DockRequest request{any_vector(any_sample), any_vector(any_index), any_index(), *rc::gen::arbitrary<bool>()};
    const DockRequest same_request = there_and_back(request);
    RC_ASSERT(same_bits(same_request.samples, request.samples));
    RC_ASSERT(same_request.bin_limit == request.bin_limit);
    RC_ASSERT(same_request.tangent_dockings == request.tangent_dockings);
    RC_ASSERT(same_request.first_drawn == request.first_drawn);
    const DockReply reply{any_vector(any_docking), *rc::gen::arbitrary<std::uint64_t>()};
    const DockReply same_reply = there_and_back(reply);
    RC_ASSERT(same_bits(same_reply.dockings, reply.dockings));
    RC_ASSERT(same_reply.evaluated == reply.evaluated);
  }));
}

TEST(Messages, RefinedDockings) {
  EXPECT_TRUE(rc::check([] {
    const auto refined = any_vector(any_refined);
    const auto same = there_and_back(refined);
    RC_ASSERT(same.size() == refined.size());
    for (std::size_t i = 0; i < same.size(); ++i) RC_ASSERT(same_bits(same[i], refined[i]));
  }));
}

TEST(Messages, FieldPatches) {
  EXPECT_TRUE(rc::check([] {
    const FieldPatch patch{{*rc::gen::arbitrary<int>(), -3, 7, *rc::gen::arbitrary<int>()}, any_vector(any_float, 500)};
    const FieldPatch same = there_and_back(patch);
    RC_ASSERT(same.window == patch.window);
    RC_ASSERT(same_bits(same.value, patch.value));
  }));
}

Similarity any_similarity() { return {any_float(), any_float(), any_float(), any_float()}; }

PoseRange any_poses() { return {any_float(), any_float(), {any_vec2(), any_vec2()}}; }

WindowPiece any_piece() { return {ShapeId{any_index()}, ShapeId{any_index()}, any_similarity(), any_poses()}; }

ReplacementWindow any_window() {
  ReplacementWindow window;
  window.box = {any_vec2(), any_vec2()};
  const int width = *rc::gen::inRange(0, 20);
  window.edge = {{Grid<float>(width, *rc::gen::inRange(0, 20)), any_vec2()}, any_float()};
  for (float& value : window.edge.distance.value.data()) value = any_float();
  window.distances = {any_float(), any_float()};
  window.least_scale_px = any_float();
  window.most_scale_px = any_float();
  window.repetition = {double(any_index()) / 3, double(any_index()) / 5, double(any_index()) / 7, any_float()};
  window.moving = any_vector(any_piece);
  window.still = any_vector(any_piece);
  window.incoming = any_vector([] {
    return IncomingShape{ShapeId{any_index()}, ShapeId{any_index()}, any_poses(), any_float()};
  });
  window.drawn = any_vector([] { return DrawingArea{ShapeId{any_index()}, double(any_index()) / 7}; });
  window.elsewhere = any_vector([] { return PlacedDrawing{ShapeId{any_index()}, any_vec2(), any_float()}; });
  window.random = *rc::gen::arbitrary<std::uint64_t>();
  window.trials = any_index();
  window.first_temperature_px2 = any_float();
  window.last_temperature_px2 = any_float();
  return window;
}

bool same_bits(const EdgeField& a, const EdgeField& b) {
  const Grid<float>& nodes = a.distance.value;
  return nodes.bounds() == b.distance.value.bounds() && same_bits(nodes.data(), b.distance.value.data()) &&
         same_bits(std::vector{a.distance.origin}, std::vector{b.distance.origin}) &&
         same_bits(std::vector{a.node_px}, std::vector{b.node_px});
}

bool same_bits(const ReplacementWindow& a, const ReplacementWindow& b) {
  const auto numbers = [](const ReplacementWindow& w) {
    return std::vector{w.least_scale_px,       w.most_scale_px,     w.first_temperature_px2,
                       w.last_temperature_px2, w.distances.soft_px, w.distances.hard_px};
  };
  return same_bits(std::vector{a.box.low, a.box.high}, std::vector{b.box.low, b.box.high}) &&
         same_bits(a.edge, b.edge) && same_bits(numbers(a), numbers(b)) && same_bits(a.moving, b.moving) &&
         same_bits(a.still, b.still) && same_bits(a.incoming, b.incoming) && a.drawn == b.drawn &&
         same_bits(a.elsewhere, b.elsewhere) && a.repetition == b.repetition && a.random == b.random &&
         a.trials == b.trials;
}

TEST(Messages, ReplacementWindows) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<ReplacementWindow> windows = any_vector(any_window, 4);
    const std::vector<ReplacementWindow> same = there_and_back(windows);
    RC_ASSERT(same.size() == windows.size());
    for (std::size_t i = 0; i < same.size(); ++i) RC_ASSERT(same_bits(same[i], windows[i]));
  }));
}

TEST(Messages, ReplacementOutcomes) {
  EXPECT_TRUE(rc::check([] {
    const auto any_replaced = [] { return ReplacedPiece{ShapeId{any_index()}, any_similarity(), any_index()}; };
    const ReplacementOutcome outcome{any_vector(any_replaced), any_index()};
    const auto same = there_and_back(std::vector{outcome, {}});
    RC_ASSERT(same.size() == 2u);
    RC_ASSERT(same_bits(same[0].pieces, outcome.pieces));
    RC_ASSERT(same[0].kept == outcome.kept);
    RC_ASSERT(same[1] == ReplacementOutcome{});
  }));
}

TEST(Messages, SpecialFloatsKeepTheirBits) {
  const std::vector<float> special = {-0.f, std::nanf("0x123"), -std::numeric_limits<float>::infinity(),
                                      std::numeric_limits<float>::denorm_min(),
                                      std::numeric_limits<float>::signaling_NaN()};
  EXPECT_TRUE(same_bits(there_and_back(FieldPatch{{0, 0, 5, 1}, special}).value, special));
}

TEST(Messages, TheSmallOnes) {
  const ShapeRange range = there_and_back(ShapeRange{7, 4000000000u});
  EXPECT_EQ(range.begin, 7u);
  EXPECT_EQ(range.end, 4000000000u);
  const StanceLimits limits{3, 0.9f, 45.5f, {ShapeId{1}, ShapeId{4000000000u}}};
  EXPECT_EQ(there_and_back(limits), limits);
  EXPECT_EQ(there_and_back(StanceLimits{}), StanceLimits{}) << "infinity";
  const FieldStart start{1012, 1013, {-5.5f, -0.f}};
  EXPECT_EQ(there_and_back(start), start);
  const RankSite site{"node7", {{"gpu", "H100", "CUDA", "535.1", 4000000000u}, {"cpu", "", "PoCL", "3.1", 0}}};
  EXPECT_EQ(there_and_back(site), site);
  WorkerTimes times;
  times.dock_s = 0.1;
  times.sent = {7, 8};
  EXPECT_EQ(there_and_back(times), times);
  const Heartbeat beat = there_and_back(Heartbeat{true, 1.5});
  EXPECT_TRUE(beat.waiting);
  EXPECT_EQ(beat.for_s, 1.5);
  const CountRequest count{std::vector<TargetSample>(2), {7, 8}, 16};
  EXPECT_EQ(encode(there_and_back(count)), encode(count));
  const Failure failure{2, "library.h5: not ours"};
  EXPECT_EQ(there_and_back(failure), failure);
}

TEST(Messages, VectorsTravelInOneCopy) {
  // A field costs its own bytes and a few more, but none for each number.
  const FieldPatch patch{{0, 0, 100, 100}, std::vector<float>(10000, 1.f)};
  EXPECT_LT(encode(patch).size(), 40000u + 64u);
  ReplacementWindow window;
  window.edge.distance.value = Grid<float>(100, 100);
  EXPECT_LT(encode(window).size(), 40000u + 256u);
  EXPECT_LT(encode(std::vector<TargetSample>(100)).size(), 100 * sizeof(TargetSample) + 64);
}

/// Returns whether reading throws an EnvironmentError and no other exception.
template <class T>
bool is_refused(const Bytes& bytes) {
  try {
    decode<T>(bytes);
    return false;
  } catch (const EnvironmentError&) {
    return true;
  }
}

TEST(Messages, one_that_was_cut_off_is_refused_wherever_it_ends) {
  ReplacementWindow window;
  window.edge.distance.value = Grid<float>(2, 3, 1.f);
  window.moving.resize(2);
  window.still.resize(1);
  window.incoming.resize(1);
  window.drawn.resize(1);
  window.elsewhere.resize(1);
  const Bytes whole = encode(std::vector{window});
  ASSERT_FALSE(is_refused<std::vector<ReplacementWindow>>(whole));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes part(whole.begin(), whole.begin() + std::ptrdiff_t(size));
    EXPECT_TRUE(is_refused<std::vector<ReplacementWindow>>(part)) << size << " of " << whole.size() << " bytes";
  }
}

TEST(Messages, one_with_more_than_its_values_is_refused) {
  Bytes bytes = encode(Failure{2, "library.h5: not ours"});
  bytes.push_back(0);
  EXPECT_TRUE(is_refused<Failure>(bytes));
}

/// Any bytes end in a value or in the one kind of error.
TEST(Messages, any_bytes_are_read_or_refused) {
  EXPECT_TRUE(rc::check([] {
    const auto bytes = *rc::gen::arbitrary<Bytes>();
    is_refused<Failure>(bytes);
    is_refused<std::vector<ReplacementWindow>>(bytes);
    is_refused<std::vector<TargetSample>>(bytes);
    is_refused<RankSite>(bytes);
    Bytes changed = encode(std::vector{any_window()});
    for (int i = 0; i < 4; ++i)
      changed[*rc::gen::inRange<std::size_t>(0, changed.size())] = *rc::gen::arbitrary<char>();
    is_refused<std::vector<ReplacementWindow>>(changed);
  }));
}

/// A message may claim more elements than it holds. The reader allocates no memory for such a claim.
TEST(Messages, numbers_beyond_the_message_take_no_memory) {
  const auto claim = [](auto... numbers) {
    Bytes bytes;
    detail::AppendingBuffer buffer(bytes);
    MessageWriter writer(buffer);
    (writer << ... << numbers);
    return bytes;
  };
  for (const std::uint64_t count : {std::uint64_t(1) << 40, std::uint64_t(1) << 63, ~std::uint64_t(0)}) {
    EXPECT_TRUE(is_refused<std::vector<TargetSample>>(claim(count)));
    EXPECT_TRUE(is_refused<std::vector<ReplacementWindow>>(claim(count)));
    EXPECT_TRUE(is_refused<std::string>(claim(count)));
  }
  const std::uint64_t none = 0;
  EXPECT_TRUE(is_refused<Grid<float>>(claim(1 << 30, 1 << 30, none)));
  EXPECT_TRUE(is_refused<Grid<float>>(claim(-1, -1, none)));
  EXPECT_TRUE(is_refused<Grid<float>>(claim(1, 1, none, 0.f)));
  EXPECT_FALSE(is_refused<Grid<float>>(claim(1, 1, none + 1, 0.f)));
}

TEST(Messages, what_is_neither_true_nor_false_is_refused) {
  EXPECT_FALSE(is_refused<bool>({1}));
  EXPECT_TRUE(is_refused<bool>({2}));
}

Failure described(const std::function<void()>& thrower) {
  try {
    thrower();
  } catch (...) {
    return describe_current_exception();
  }
  return {0, ""};
}

TEST(Failures, KeepTheirKindAndText) {
  EXPECT_EQ(described([] { throw InputError("a"); }), (Failure{2, "a"}));
  EXPECT_EQ(described([] { throw EnvironmentError("b"); }), (Failure{1, "b"}));
  EXPECT_EQ(described([] { throw std::bad_alloc(); }), (Failure{1, "out of memory"}));
  EXPECT_EQ(described([] { throw std::logic_error("c"); }), (Failure{1, "internal error: c"}));
  const std::string refused = "the system starts no further thread or process: Resource temporarily unavailable";
  EXPECT_EQ(described([] { throw std::system_error(EAGAIN, std::generic_category()); }),
            (Failure{1, refused + " (ulimit -u, or the container's limit)"}));
  EXPECT_EQ(described([] { throw std::system_error(EIO, std::generic_category()); }),
            (Failure{1, "the system refused: Input/output error"}));
  const std::string long_name(300, 'x');
  EXPECT_EQ(described([&] { std::filesystem::remove(long_name); }), (Failure{1, long_name + ": File name too long"}));
  EXPECT_EQ(described([] { std::filesystem::rename("no a", "no b"); }),
            (Failure{1, "no a, no b: No such file or directory"}));
  EXPECT_EQ(described([] { throw 5; }), (Failure{1, "internal error of unknown kind"}));
  for (const Failure& failure : {Failure{2, "x"}, Failure{1, "y"}}) {
    EXPECT_EQ(described([&] { throw_failure(failure); }), failure);
  }
}

}  // namespace test_messages
}  // namespace tessera::comm
