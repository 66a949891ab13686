#include "worker/shard/index_rows.h"

#include <algorithm>
#include <bit>

namespace tessera::worker {
namespace {

static_assert(kIndexFanOut == kFilterLanes);

int elements_of(int pad_levels) { return 2 * (pad_levels - 1); }

std::size_t box_rows(int pad_levels) { return std::size_t(2 * elements_of(pad_levels) + 3); }
std::size_t filter_rows(int pad_levels) { return std::size_t(elements_of(pad_levels) + 2); }

/// kLowNumbers and kPlaceNumbers of kernels/pad_index.cl.
std::size_t low_numbers(int pad_levels) { return std::size_t((elements_of(pad_levels) + 3) / 4); }
std::size_t place_numbers(int pad_levels) { return low_numbers(pad_levels) + 3; }

/// The numbers of one PAD in the index, beside its source.
struct PlaceNumbers {
  std::array<std::uint16_t, (kMaxPadElements + 3) / 4> low{};
  std::uint16_t scale = 0;
};

PlaceNumbers place_numbers_of(const LibraryPad& pad) {
  PlaceNumbers numbers;
  for (std::size_t e = 0; e < pad.pad.element.size(); ++e) {
    const u32 low_bits = pad.pad.element[e] / kLibraryPadSteps % 16;
    numbers.low[e / 4] = std::uint16_t(numbers.low[e / 4] | low_bits << 4 * (e % 4));
  }
  numbers.scale = std::uint16_t(std::bit_cast<u32>(pad.scale_length) >> 16);
  return numbers;
}

void put_place(std::uint16_t* place, const PlaceNumbers& numbers, u32 source, std::size_t low_numbers) {
  for (std::size_t k = 0; k < numbers.low.size(); ++k) {
    if (k < low_numbers) place[k] = numbers.low[k];
  }
  place += low_numbers;
  place[0] = numbers.scale;
  place[1] = std::uint16_t(source);
  place[2] = std::uint16_t(source >> 16);
}

/// Writes a PAD's bytes into one lane of the rows of a block.
void put_bytes(std::uint8_t* lane, const PadBytes& pad, int elements) {
  for (int e = 0; e < elements; ++e) lane[std::size_t(e) * kFilterLanes] = pad.element[std::size_t(e)];
  lane[std::size_t(elements) * kFilterLanes] = pad.scale;
  lane[std::size_t(elements + 1) * kFilterLanes] = pad.sign;
}

u32 divided_up(u32 count, u32 by) { return (count + by - 1) / by; }

/// The rows of `places` boxes, in groups of 64. Places beyond `boxes` hold nothing.
std::vector<std::uint8_t> rows_of(const std::vector<PadBox>& boxes, std::size_t places, int pad_levels) {
  const std::size_t elements = std::size_t(elements_of(pad_levels));
  std::vector<std::uint8_t> rows(places * box_rows(pad_levels));
  for (std::size_t i = 0; i < places; ++i) {
    const PadBox box = i < boxes.size() ? boxes[i] : PadBox();
    std::uint8_t* const row = rows.data() + i / kFilterLanes * kFilterLanes * box_rows(pad_levels) + i % kFilterLanes;
    for (std::size_t e = 0; e < elements; ++e) {
      row[e * kFilterLanes] = box.low[e];
      row[(elements + e) * kFilterLanes] = box.high[e];
    }
    row[2 * elements * kFilterLanes] = box.scale_low;
    row[(2 * elements + 1) * kFilterLanes] = box.scale_high;
    row[(2 * elements + 2) * kFilterLanes] = box.signs;
  }
  return rows;
}

}  // namespace

IndexKind index_kind(const MatchingContext& context) {
  return {context.pad.levels, context.stances.limits_rotations()};
}

std::vector<IndexPart> index_parts(const MatchRecord& match) {
  std::vector<IndexPart> parts;
  u32 node = 0;
  u32 root = 0;
  for (u32 first = 0, shapes = 0; first < match.shapes; first += shapes) {
    shapes = std::min(kSegmentShapes - (match.first_shape + first) % kSegmentShapes, match.shapes - first);
    for (u32 level = 0; level < match.level_count; ++level) {
      const u32 nodes = divided_up(shapes * match.level[level].count, kFilterLanes * kFilterLanes);
      const u32 roots = divided_up(nodes, kFilterLanes);
      parts.push_back({first, shapes, level, node, nodes, root, roots});
      node += nodes;
      root += roots;
    }
  }
  return parts;
}

IndexRows make_index_rows(const IndexPart& part, const MatchRecord& match, const IndexedPads& of_segment,
                          const IndexKind& kind, std::vector<u32> order) {
  const int pad_levels = kind.pad_levels;
  const LevelRecord& level = match.level[part.level];
  /// The i-th source of the level, as a source of the segment.
  const auto source_of = [&](u32 i) { return i / level.count * match.sources + level.first + i % level.count; };
  std::vector<PadBytes> bytes;
  std::vector<PlaceNumbers> numbers;
  bytes.reserve(std::size_t(part.shapes) * level.count);
  numbers.reserve(bytes.capacity());
  for (u32 shape = 0; shape < part.shapes; ++shape) {
    const LibraryPad* const pads = of_segment.pads.data() + shape * match.sources + level.first;
    for (u32 i = 0; i < level.count; ++i) {
      bytes.push_back(pad_bytes(pads[i].pad, pads[i].scale_length, pads[i].convexity));
      numbers.push_back(place_numbers_of(pads[i]));
    }
  }
  if (order.empty()) order = pad_order(bytes, elements_of(pad_levels));
  const PadIndex index = boxed(std::move(order), bytes);

  IndexRows result;
  for (u32 root = 0; root < part.roots; ++root) {
    const u32 segment = (match.first_shape + part.first_shape) / kSegmentShapes;
    result.roots.push_back({part.first_node + root * kFilterLanes, part.level, segment});
  }
  const std::size_t blocks = std::size_t(part.nodes) * kFilterLanes;
  result.node_boxes = rows_of(index.nodes, std::size_t(part.roots) * kFilterLanes, pad_levels);
  result.block_boxes = rows_of(index.blocks, blocks, pad_levels);
  result.rows.resize(blocks * kFilterLanes * filter_rows(pad_levels));
  result.places.resize(blocks * kFilterLanes * place_numbers(pad_levels));
  if (kind.with_chords) result.chords.resize(blocks * kFilterLanes);
  for (std::size_t i = 0; i < index.order.size(); ++i) {
    const u32 pad = index.order[i];
    put_bytes(result.rows.data() + i / kFilterLanes * kFilterLanes * filter_rows(pad_levels) + i % kFilterLanes,
              bytes[pad], elements_of(pad_levels));
    const u32 source = source_of(pad);
    put_place(result.places.data() + i * place_numbers(pad_levels), numbers[pad],
              part.first_shape * match.sources + source, low_numbers(pad_levels));
    if (kind.with_chords) result.chords[i] = of_segment.chords[source];
  }
  return result;
}

BufferBytes index_bytes(const MatchRecord& match, const IndexKind& kind) {
  std::size_t roots = 0, nodes = 0;
  for (const IndexPart& part : index_parts(match)) {
    roots += part.roots;
    nodes += part.nodes;
  }
  const std::size_t lanes_of_nodes = roots * kFilterLanes;
  const std::size_t lanes_of_blocks = nodes * kFilterLanes;
  const std::size_t pads = lanes_of_blocks * kFilterLanes;
  BufferBytes buffers;
  buffers.add(roots * sizeof(RootRecord));
  buffers.add(lanes_of_nodes * box_rows(kind.pad_levels));
  buffers.add(lanes_of_blocks * box_rows(kind.pad_levels));
  buffers.add(pads * filter_rows(kind.pad_levels));
  buffers.add(pads * place_numbers(kind.pad_levels) * sizeof(std::uint16_t));
  if (kind.with_chords) buffers.add(pads * sizeof(ChordRecord));
  return buffers;
}

}  // namespace tessera::worker
