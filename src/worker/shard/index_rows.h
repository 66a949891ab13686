// The index of a shard's PADs (core/pad/pad_index.h) in the form that the kernels read (kernels/pad_index.cl): rows of 64
// bytes. A segment is some thousand consecutive shapes. Each level of a segment has an index of its own, so that the index
// can be made in parts and kept with its shapes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/matching/matching_context.h"
#include "core/pad/pad_index.h"
#include "core/shape/model_sample.h"
#include "records.h"

namespace tessera::worker {

/// One level of a segment, or of the part of a segment that is in the shard, and its place in the shard's index. A root has
/// up to 64 nodes, a node 64 blocks, a block 64 PADs. Nodes are filled up with empty blocks; roots are not filled up with
/// nodes.
struct IndexPart {
  u32 first_shape;  // first shape of the segment, counted in the shard
  u32 shapes;
  u32 level;  // number among the levels in use
  u32 first_node;
  u32 nodes;
  u32 first_root;
  u32 roots;
};

/// The parts of a shard's index, segment by segment. Segments begin at multiples of kSegmentShapes of the library.
std::vector<IndexPart> index_parts(const MatchRecord& match);

struct IndexRows {
  std::vector<RootRecord> roots;
  std::vector<std::uint8_t> node_boxes;   // by root: kBoxRows rows with the boxes of its nodes
  std::vector<std::uint8_t> block_boxes;  // by node: the boxes of its blocks
  std::vector<std::uint8_t> rows;         // by block: a row for each element, the scales, the signs; sign 0: no PAD
  std::vector<std::uint16_t> places;      // by block and lane: kPlaceNumbers numbers; the source is one of the shard
  std::vector<ChordRecord> chords;        // by block and lane, where rotations are limited
};

/// The features that an index has to support.
struct IndexKind {
  int pad_levels = 5;
  bool with_chords = false;
};
IndexKind index_kind(const MatchingContext& context);

/// The PADs of some shapes, all sources of each shape.
struct IndexedPads {
  std::vector<LibraryPad> pads;
  std::vector<ChordRecord> chords;  // only where the index has chords
};

/// `of_segment`: the PADs of the segment's shapes. `order`: the order of the level's PADs, which are numbered shape by
/// shape; where it is empty, it is computed.
IndexRows make_index_rows(const IndexPart& part, const MatchRecord& match, const IndexedPads& of_segment,
                          const IndexKind& kind, std::vector<u32> order = {});

/// The sizes of buffers on a device.
struct BufferBytes {
  std::size_t all = 0;
  std::size_t largest = 0;

  void add(std::size_t buffer) {
    all += buffer;
    largest = std::max(largest, buffer);
  }
};

/// The sizes of the buffers that a shard's index takes on its device.
BufferBytes index_bytes(const MatchRecord& match, const IndexKind& kind);

}  // namespace tessera::worker
