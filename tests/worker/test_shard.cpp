// The part of the library on a device. Its size in bytes is known before it is made, and the index loses no PAD.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "support/synthetic_library.h"
#include "worker/shard/shard.h"

namespace tessera::worker {
namespace test_shard {

std::size_t bytes_of(const IndexRows& rows) {
  return rows.roots.size() * sizeof(RootRecord) + rows.node_boxes.size() + rows.block_boxes.size() + rows.rows.size() +
         rows.places.size() * sizeof(std::uint16_t) + rows.chords.size() * sizeof(ChordRecord);
}

TEST(Shard, bytes_are_known_beforehand) {
  const std::vector<Shape> shapes = test::synthetic_library(3);
  for (const float max_scale_px : {40.f, 160.f, 600.f}) {
    CollageSettings settings;
    settings.pieces.max_scale_px = max_scale_px;
    if (max_scale_px > 500) settings.pieces.max_rotation_rad = 0.5f;  // gives an index with chords
    const MatchingContext context = make_matching_context(settings, 3);
    const MatchRecord match = make_match_record(context, {0, 3});
    const std::vector<ShapeModel> models = test::models_of(shapes, context, 0, 3);
    const Shard shard = make_shard(match, index_kind(context), models);
    std::vector<float> contours;
    for (const ShapeModel& model : models) append_contour(contours, model);
    std::size_t bytes = shard.bytes() + contours.size() * sizeof(float);
    std::size_t rows = 0;
    for (const IndexPart& part : index_parts(match)) {
      const IndexRows made = make_index_rows(part, match, shard.pads, index_kind(context));
      bytes += bytes_of(made);
      rows += made.rows.size();
    }
    std::vector<std::int16_t> keypoints;
    for (const ShapeModel& model : models) append_keypoints(keypoints, model, context.pad.levels);
    for (const bool reads : {false, true}) {
      EXPECT_EQ(shard_bytes(context, 3, reads).device, bytes);
      EXPECT_EQ(shard_bytes(context, 3, reads).largest_buffer, std::max(rows, contours.size() * sizeof(float)));
      EXPECT_EQ(shard_bytes(context, 3, reads).host, keypoints.size() * sizeof keypoints[0]);
    }
  }
  EXPECT_EQ(shard_bytes(make_matching_context(CollageSettings(), 1), 0, true).device, 0u);
}

/// In a large part that can be read, contours and key points are loaded when they are needed.
TEST(Shard, a_large_one_holds_few_contours) {
  const MatchingContext context = make_matching_context(CollageSettings(), 1);
  const std::size_t shapes = HeldShapes().most_whole + 1;
  EXPECT_EQ(shard_bytes(context, shapes - 1, true).device, shard_bytes(context, shapes - 1, false).device);
  const ShardBytes reads = shard_bytes(context, shapes, true);
  const ShardBytes holds = shard_bytes(context, shapes, false);
  EXPECT_EQ(reads.host, 0u);
  EXPECT_EQ(holds.device - reads.device, (shapes - HeldShapes().contours) * kContourFloats * sizeof(float));
}

/// Models without levels, and their PADs read separately.
TEST(Shard, takes_pads_that_are_given) {
  const MatchingContext context = make_matching_context(CollageSettings(), 2);
  const MatchRecord match = make_match_record(context, {0, 2});
  std::vector<ShapeModel> models = test::models_of(test::synthetic_library(2), context, 0, 2);
  const Shard expected = make_shard(match, index_kind(context), models);
  std::vector<LibraryPad> pads = expected.pads.pads;
  for (ShapeModel& model : models) model.levels.clear();
  EXPECT_EQ(make_shard(match, index_kind(context), models, pads).pads.pads, expected.pads.pads);
  EXPECT_THROW(make_shard(match, index_kind(context), models), std::logic_error);
  EXPECT_THROW(make_shard(match, {context.pad.levels, true}, models, pads), std::logic_error) << "without chords";
  pads.pop_back();
  EXPECT_THROW(make_shard(match, index_kind(context), models, pads), std::logic_error);
}

MatchRecord two_levels(u32 shapes) {
  MatchRecord match{};
  match.shapes = shapes;
  match.level_count = 2;
  match.level[0] = {0, 64, 0, 0};
  match.level[1] = {64, 128, 0, 0};
  match.sources = 192;
  return match;
}

IndexedPads random_pads(const MatchRecord& match) {
  std::mt19937 random(11);
  IndexedPads all;
  all.pads.resize(std::size_t(std::min(match.shapes, kSegmentShapes)) * match.sources);
  for (LibraryPad& pad : all.pads) {
    for (std::uint16_t& element : pad.pad.element) element = std::uint16_t(random());
    pad.pad = library_pad(pad.pad);
    pad.scale_length = library_length(0.01f + float(random() % 1000) / 100);
    pad.convexity = float(int(random() % 3) - 1);
    all.chords.push_back({float(random() % 60000), 0});
  }
  return all;
}

/// Each number of levels gives rows of another length.
TEST(IndexRows, hold_each_pad_once) {
  for (const int pad_levels : {2, 5, 6}) {
    const MatchRecord match = two_levels(70);
    const IndexedPads of_segment = random_pads(match);
    const std::vector<LibraryPad>& pads = of_segment.pads;
    const std::size_t elements = std::size_t(2 * (pad_levels - 1));
    const std::size_t low_numbers = (elements + 3) / 4;
    const std::size_t numbers = low_numbers + 3;
    std::vector<int> seen(pads.size(), 0);
    for (const IndexPart& part : index_parts(match)) {
      const IndexRows rows = make_index_rows(part, match, of_segment, {pad_levels, true});
      for (std::size_t place = 0; place < rows.places.size() / numbers; ++place) {
        const std::uint8_t* const row =
            rows.rows.data() + place / kFilterLanes * kFilterLanes * (elements + 2) + place % kFilterLanes;
        if (row[(elements + 1) * kFilterLanes] == 0) continue;  // this lane holds no PAD
        const std::uint16_t* const low = rows.places.data() + place * numbers;
        const std::uint16_t* const rest = low + low_numbers;
        const u32 source = rest[1] | u32(rest[2]) << 16;
        ++seen.at(source);
        for (std::size_t e = 0; e < elements; ++e) {
          const int low_bits = low[e / 4] >> 4 * (e % 4) & 15;
          EXPECT_EQ(row[e * kFilterLanes] << 8 | low_bits << 4, pads[source].pad.element[e]);
        }
        EXPECT_EQ(std::bit_cast<float>(u32(rest[0]) << 16), pads[source].scale_length);
        EXPECT_EQ(rows.chords[place].x, of_segment.chords[source].x);
        EXPECT_EQ(row[elements * kFilterLanes], scale_byte(pads[source].scale_length));
        EXPECT_EQ(row[(elements + 1) * kFilterLanes], sign_byte(pads[source].convexity));
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(pads.size()));
  }
}

/// The parts follow one another, segment by segment and level by level.
TEST(IndexRows, parts_follow_one_another) {
  const MatchRecord match = two_levels(2 * kSegmentShapes + 5);
  const std::vector<IndexPart> parts = index_parts(match);
  ASSERT_EQ(parts.size(), 6u);
  u32 nodes = 0;
  u32 roots = 0;
  for (const IndexPart& part : parts) {
    EXPECT_EQ(part.first_node, nodes);
    EXPECT_EQ(part.first_root, roots);
    nodes += part.nodes;
    roots += part.roots;
  }
  EXPECT_EQ(parts[3].nodes, kSegmentShapes * 128 / (kFilterLanes * kFilterLanes));
  EXPECT_EQ(parts[3].roots, parts[3].nodes / kFilterLanes) << "a whole segment's level of 128 samples fills its roots";
  EXPECT_EQ(parts.back().shapes, 5u);
  EXPECT_EQ(parts.back().first_shape, 2 * kSegmentShapes);
}

/// A part of a segment takes its order from the whole segment's order, wherever the shard begins.
TEST(IndexRows, segments_are_those_of_the_library) {
  MatchRecord match = two_levels(kSegmentShapes);
  match.first_shape = 3 * kSegmentShapes - 5;
  const std::vector<IndexPart> parts = index_parts(match);
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(parts[0].shapes, 5u);
  EXPECT_EQ(parts[2].first_shape, 5u);
  EXPECT_EQ(parts[2].shapes, kSegmentShapes - 5);
  const IndexedPads pads = random_pads(match);
  EXPECT_EQ(make_index_rows(parts[1], match, pads, {5, false}, {}).roots.front().segment, 2u);
  EXPECT_EQ(make_index_rows(parts[2], match, pads, {5, false}, {}).roots.back().segment, 3u);
}

/// Gives another order of the same PADs.
TEST(IndexRows, take_an_order_that_is_given) {
  const MatchRecord match = two_levels(70);
  const IndexedPads pads = random_pads(match);
  const IndexPart part = index_parts(match).front();
  std::vector<u32> order(part.shapes * match.level[0].count);
  std::iota(order.rbegin(), order.rend(), 0u);
  const IndexRows rows = make_index_rows(part, match, pads, {5, false}, order);
  const u32 last = part.shapes - 1;
  EXPECT_EQ(rows.places[3], last * match.sources + match.level[0].count - 1);
  EXPECT_EQ(rows.places[5 * (order.size() - 1) + 3], 0u);
}

}  // namespace test_shard
}  // namespace tessera::worker
