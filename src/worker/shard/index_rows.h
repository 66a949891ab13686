// The index of a shard's PADs (core/pad/pad_index.h) as the kernels read it (kernels/pad_index.cl): rows of 64 bytes.
// Each level of each segment, some thousand shapes that follow one another, has an index of its own, so that it can be
// made piece by piece and kept with its shapes.
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

/// One level of a segment, or of what the shard has of it, and where it lies in the shard's index. A root has up to 64
/// nodes, a node 64 blocks, a block 64 PADs; nodes are filled up with blocks, but roots not with nodes.
struct IndexPart {
  u32 first_shape;  // of the segment, in the shard
  u32 shapes;
  u32 level;  // in use
  u32 first_node;
  u32 nodes;
  u32 first_root;
  u32 roots;
};

/// Those of a shard, segment by segment: segments begin at multiples of kSegmentShapes of the library.
std::vector<IndexPart> index_parts(const MatchRecord& match);

struct IndexRows {
  std::vector<RootRecord> roots;
  std::vector<std::uint8_t> node_boxes;   // by root: kBoxRows rows of its nodes' boxes
  std::vector<std::uint8_t> block_boxes;  // by node: of its blocks' boxes
  std::vector<std::uint8_t> rows;         // by block: a row for each element, the scales, the signs; a sign 0: no PAD
  std::vector<std::uint16_t> places;      // by block and lane: kPlaceNumbers, the source is one of the shard
  std::vector<ChordRecord> chords;        // by block and lane, where rotations are limited
};

/// What an index is made for.
struct IndexKind {
  int pad_levels = 5;
  bool with_chords = false;
};
IndexKind index_kind(const MatchingContext& context);

/// Those of some shapes, all sources of each.
struct IndexedPads {
  std::vector<LibraryPad> pads;
  std::vector<ChordRecord> chords;  // where an index has them
};

/// `of_segment`: of the segment's shapes. `order`: of the level's PADs, shape by shape; where it is empty it is made.
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

/// What the index of a shard takes on its device.
BufferBytes index_bytes(const MatchRecord& match, const IndexKind& kind);

}  // namespace tessera::worker
