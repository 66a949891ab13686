// The index finds the same PADs as a look at every PAD, and looks at few of them; the room for results grows.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "core/matching/match_round.h"
#include "support/matching_scene.h"
#include "worker/devices/opencl_devices.h"
#include "worker/pair_search.h"
#include "worker/sample_records.h"

namespace tessera::worker {
namespace test_pair_search {

using Found = std::vector<std::tuple<u32, u32, u32>>;

Found sorted(const std::vector<PairRecord>& pairs) {
  Found found;
  for (const PairRecord& pair : pairs) found.emplace_back(pair.sample, pair.source, pair.distance);
  std::sort(found.begin(), found.end());
  return found;
}

/// Searches in the PADs of real outlines.
class PairSearchTest : public testing::Test {
 protected:
  PairSearchTest()
      : scene_(test::make_scene(test::scene_settings(), {40, 300, 6, 40})),
        library_(opencl_devices().front(), scene_.context, all_of(scene_.models), given(scene_.models)),
        samples_(library_.session()) {}

  /// Sample t searches up to `steps`, or twice as far.
  void reach(u32 steps) {
    std::vector<SampleRecord> records = make_sample_records(scene_.samples, library_.match(), library_.pad_levels());
    for (std::size_t t = 0; t < records.size(); ++t) set_reach(records[t], t % 2 == 0 ? steps : 2 * steps);
    samples_.write(records);
  }

  Found found(PairSearch& search) {
    search.post(samples_, u32(scene_.samples.size()));
    return sorted(search.take().value());
  }

  test::MatchingScene scene_;
  DeviceLibrary library_;
  DeviceBuffer<SampleRecord> samples_;
};

TEST_F(PairSearchTest, FindsWhatAScanFinds) {
  PairSearch by_index(library_, 1 << 20);
  PairSearch scan(library_, 1 << 20);
  scan.scan_all();
  std::size_t pairs = 0;
  for (const u32 steps : {1u, 100u, 700u, 3000u, kPadSteps + 1}) {
    reach(steps);
    const std::uint64_t before = by_index.blocks_visited();
    const std::uint64_t scan_before = scan.blocks_visited();
    const Found expected = found(scan);
    EXPECT_EQ(found(by_index), expected) << steps << " steps";
    EXPECT_LE(by_index.blocks_visited() - before, scan.blocks_visited() - scan_before);
    pairs += expected.size();
  }
  EXPECT_GT(pairs, 10'000u);
}

TEST_F(PairSearchTest, LooksAtFewBlocks) {
  PairSearch by_index(library_, 1 << 20);
  PairSearch scan(library_, 1 << 20);
  scan.scan_all();
  reach(300);
  EXPECT_FALSE(found(by_index).empty());
  found(scan);
  EXPECT_EQ(scan.blocks_visited(), scene_.samples.size() * 40 * library_.match().sources / kFilterLanes);
  EXPECT_LT(by_index.blocks_visited(), scan.blocks_visited() / 4);
}

TEST_F(PairSearchTest, MakesRoomForWhatItFinds) {
  constexpr std::size_t kRoom = 1 << 12;  // half of it is for blocks
  PairSearch roomy(library_, 1 << 22);
  PairSearch tight(library_, kRoom);
  std::uint64_t most_blocks = 0;
  for (const u32 steps : {20u, 600u, 100u}) {
    reach(steps);
    const std::uint64_t before = tight.blocks_visited();
    EXPECT_EQ(found(tight), found(roomy)) << steps << " steps";
    most_blocks = std::max(most_blocks, tight.blocks_visited() - before);
  }
  EXPECT_GT(most_blocks, kRoom / 2 / sizeof(BlockRecord)) << "there was room for all from the first";
}

/// Several samples give up, and the caller divides them. A single sample gets all the room that it needs.
TEST_F(PairSearchTest, GivesUpWhereThereAreTooMany) {
  PairSearch roomy(library_, 1 << 22);
  PairSearch tight(library_, 1);
  reach(kPadSteps + 1);
  tight.post(samples_, u32(scene_.samples.size()));
  EXPECT_FALSE(tight.take().has_value());
  roomy.post(samples_, 1);
  tight.post(samples_, 1);
  const auto of_one = tight.take();
  ASSERT_TRUE(of_one.has_value());
  EXPECT_GT(of_one->size() * sizeof(PairRecord), kMostGrowth);
  EXPECT_EQ(sorted(*of_one), sorted(roomy.take().value()));
}

}  // namespace test_pair_search
}  // namespace tessera::worker
