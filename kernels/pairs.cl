// core/matching/pair_selection.cpp in OpenCL C (paper section 3.3), up to the PAD distance: scale window, sign,
// rotation, distance within reach. src/worker/pair_choice.cpp decides which pairs of a shape are local minima along its
// curve, as it has all of them.
//
// For the blocks that the index has found (pad_index.cl), an exact filter tests bytes (core/pad/pad_filter.h). Then the
// distance itself is computed for the PADs that may be near.

enum {
  kMostBlocksAtATime = 256,                    // for one work group
  kPadsOfItem = kFilterLanes / kItemsOfBlock,  // of each block
  // Pairs that an item gathers before it appends them to the list. When each pair was appended alone, all cores changed the
  // same counter and wrote into the same lines of the cache: on two cores a search took 1.4 times as long.
  kGathered = kItemsOfBlock > 1 ? kPadsOfItem : 4 * kPadsOfItem
};

// The number of searchers of a work group. A searcher tests one block at a time: one work item on CPUs, 16 on GPUs.
uint searchers(void) { return (uint)get_local_size(0) / kItemsOfBlock; }

// Blocks in a portion, out of `count`. Each work group gets four portions, so that all groups have work, but a portion
// has at least one block for each searcher.
uint blocks_at_a_time(uint count) {
  const uint items = searchers();
  const uint of_an_item = count / (4 * (uint)get_num_groups(0) * items);
  return items * clamp(of_an_item, 1u, max(1u, kMostBlocksAtATime / items));
}

// The part of a target sample that tests of pairs need.
typedef struct Target {
  ushort element[kPadElements];
  float scale_length;
  float chord_x;
  float chord_y;
} Target;

Target load_target(global const SampleRecord* sample) {
  Target target;
  for (int e = 0; e < kPadElements; ++e) target.element[e] = (ushort)sample->element[e];
  target.scale_length = sample->scale_length;
  target.chord_x = sample->chord_x;
  target.chord_y = sample->chord_y;
  return target;
}

// The PADs of a block that may be near to the sample, judged by their bytes.
INLINE Met filter_block(global const uchar* rows, const Bounds* bounds) {
#if kLanesAreItems
  const uint scales = row_part(rows, kPadElements);
  Met passes = at_least(scales, in_all_bytes(bounds->scale_low)) & at_least(in_all_bytes(bounds->scale_high), scales) &
               any_bit(row_part(rows, kPadElements + 1), bounds->signs);
#pragma unroll
  for (int e = 0; e < kPadElements; ++e) {
    const uint bytes = row_part(rows, e);
    passes &= at_least(bytes, in_all_bytes(bounds->low[e])) & at_least(in_all_bytes(bounds->high[e]), bytes);
  }
  return passes;
#else
  LaneBytes passes;
  for (int i = 0; i < kFilterLanes; ++i) {
    global const uchar* row = rows + i;
    global const uchar* rest = row + kPadElements * kFilterLanes;
    uchar pass = (uchar)((rest[0] >= bounds->scale_low) & (rest[0] <= bounds->scale_high) &
                         ((rest[kFilterLanes] & bounds->signs) != 0));
#pragma unroll
    for (int e = 0; e < kPadElements; ++e) {
      const uchar byte = row[e * kFilterLanes];
      pass &= (uchar)((byte >= bounds->low[e]) & (byte <= bounds->high[e]));
    }
    passes.byte[i] = pass;
  }
  return lane_bits(&passes);
#endif
}

// Whether the pair implies an allowed rotation. `chord`: of the PAD; not read where every rotation is allowed.
bool may_turn(const Stances* stances, global const ChordRecord* chord, const Target* target) {
  if (stances->stance->docked_edge_x <= -1) return true;
  const float turn_x = chord->x * target->chord_x + chord->y * target->chord_y;
  const float turn_y = chord->x * target->chord_y - chord->y * target->chord_x;
  for (uint i = 0; i < stances->list.count; ++i) {
    const StanceRecord stance = stances->stance[i];
    if (direction_allowed(docked_rotations(&stance), turn_x, turn_y, 1, 0)) return true;
  }
  return false;
}

bool may_scale(const Stances* stances, constant LevelRecord* level, float scale_length, const Target* target) {
  const float low_px = max(level->scale_low_px, stances->list.min_scale_px);
  const float high_px = min(level->scale_high_px, stances->list.max_scale_px);
  return !(target->scale_length < scale_length * (low_px * kScaleWindowLow)) &&
         !(target->scale_length > scale_length * (high_px * kScaleWindowHigh));
}

// Equation 1 in steps for PAD `lane` of a block. `rows`: high bytes of the elements; `place`: the PAD's own numbers.
// The lowest four bits of a library's elements are 0 (core/pad/quantised_pad.h).
INLINE uint pad_distance(global const uchar* rows, uint lane, global const ushort* place, const Target* target) {
  ushort farthest = 0;
#pragma unroll
  for (int e = 0; e < kPadElements; ++e) {
    const ushort element = (ushort)(rows[e * kFilterLanes + lane] << 8 | (place[e / 4] >> 4 * (e % 4) & 15) << 4);
    farthest = max(farthest, abs_diff(target->element[e], element));
  }
  return farthest;
}

// Prefetches the rows of a block: blocks lie anywhere in memory, and on a CPU half of a search was waiting for them.
// OpenCL's own prefetch() does nothing in PoCL; a GPU has other work to do meanwhile.
INLINE void ask_for_rows(global const uchar* rows) {
#if defined(__x86_64__) || defined(__aarch64__)
  for (int row = 0; row < kFilterRows; ++row) __builtin_prefetch((const void*)(size_t)(rows + row * kFilterLanes));
#endif
}

// Appends pairs to the list. Those beyond `capacity` are lost, but counted.
INLINE void append_pairs(const PairRecord* gathered, uint count, uint capacity, global uint* pair_count,
                         global PairRecord* pairs) {
  if (count == 0) return;
  const uint first = claim_places(pair_count, count);
  for (uint k = 0; k < count && first + k < capacity; ++k) pairs[first + k] = gathered[k];
}

// Work group: some portions of the blocks that were found; its searchers take blocks in turn. There is only one launch.
// Blocks of a portion are neighbours in the list and mostly in the index: a CPU's cache keeps the rows for the next
// samples.
// `index_rows`: for each block one row for each element, one for the scales and one for the signs. `index_places`: data
// for a PAD's exact test; `index_chords`: data for the test of its rotation.
// `pairs`: the pairs nearer than their sample's reach, in no particular order; those beyond `capacity` are lost, but
// counted.
SEARCH_KERNEL void find_pairs(constant MatchRecord* match, global const StanceRecord* stances,
                              global const StanceListRecord* stance_lists, global const uint* shape_class,
                              global const uchar* index_rows, global const ushort* index_places,
                              global const ChordRecord* index_chords, constant ColourRecord* colour,
                              global const uint* near_bits, global const SampleRecord* samples,
                              global const uint* block_count, uint block_capacity, global const BlockRecord* blocks,
                              uint capacity, global uint* pair_count, global PairRecord* pairs) {
  const uint count = min(*block_count, block_capacity);
  const uint portion = blocks_at_a_time(count);
  const uint searcher = (uint)get_local_id(0) / kItemsOfBlock;
  PairRecord gathered[kGathered];
  uint gathered_count = 0;
  for (uint first = get_group_id(0) * portion; first < count; first += get_num_groups(0) * portion) {
    const uint end = min(first + portion, count);
    for (uint i = first + searcher; i < end; i += searchers()) {
      const BlockRecord block = blocks[i];
      uint next = i + searchers();
      if (next >= end) next = first + get_num_groups(0) * portion + searcher;
      if (next < count) ask_for_rows(index_rows + (size_t)blocks[next].block * kFilterRows * kFilterLanes);
      global const SampleRecord* sample = samples + block.sample;
      global const uchar* rows = index_rows + (size_t)block.block * kFilterRows * kFilterLanes;
      const Bounds bounds = bounds_of(sample, block.level);
      Met left = filter_block(rows, &bounds);
      if (left == 0) continue;
      const Target target = load_target(sample);
      for (; left != 0; left &= left - 1) {
        const uint lane = next_lane(left);
        const size_t pad = (size_t)block.block * kFilterLanes + lane;
        global const ushort* place = index_places + pad * kPlaceNumbers;
        const uint distance = pad_distance(rows, lane, place, &target);
        if (distance >= sample->reach) continue;
        const uint source = place[kLowNumbers + 1] | (uint)place[kLowNumbers + 2] << 16;
        const uint shape = source / match->sources;
        const Stances standing = stances_of(stances, stance_lists, shape_class, shape);
        if (standing.list.count == 0 ||
            !may_scale(&standing, match->level + block.level, as_float((uint)place[kLowNumbers] << 16), &target) ||
            !may_turn(&standing, index_chords + pad, &target) ||
            !has_near_colour(sample, near_bits, colour->near_words, match->first_shape + shape)) {
          continue;
        }
        const PairRecord pair = {block.sample, source, distance};
        gathered[gathered_count++] = pair;
      }
      if (gathered_count + kPadsOfItem <= kGathered) continue;
      append_pairs(gathered, gathered_count, capacity, pair_count, pairs);
      gathered_count = 0;
    }
  }
  append_pairs(gathered, gathered_count, capacity, pair_count, pairs);
}
