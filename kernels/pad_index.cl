// core/pad/pad_index.h in OpenCL C: finds the blocks of the index that may hold pairs of a target sample.
//
// 64 boxes, or PADs, are tested at once. The compiler vectorises the loop over them, as it knows the device's width.

enum IndexSizes {
  kPadElements = 2 * (kPadLevels - 1),
  kFilterRows = kPadElements + 2,
  kBoxRows = 2 * kPadElements + 3,  // the elements' smallest bytes, their largest bytes, two rows of scales, the signs
  // Numbers of 16 bits: the low bits of the elements, four elements in each number; the upper half of the length that
  // estimates the scale; the source, lower half first.
  kLowNumbers = (kPadElements + 3) / 4,
  kPlaceNumbers = kLowNumbers + 3
};

// The range of bytes, inclusive, that a pair of a target sample can have (core/pad/pad_filter.h).
typedef struct Bounds {
  uchar low[kPadElements];
  uchar high[kPadElements];
  uchar scale_low;
  uchar scale_high;
  uchar signs;
} Bounds;

Bounds bounds_of(global const SampleRecord* sample, uint level) {
  Bounds bounds;
  for (int e = 0; e < kPadElements; ++e) {
    bounds.low[e] = (uchar)sample->pad_low[e];
    bounds.high[e] = (uchar)sample->pad_high[e];
  }
  bounds.scale_low = (uchar)sample->scale_low[level];
  bounds.scale_high = (uchar)sample->scale_high[level];
  bounds.signs = (uchar)sample->signs;
  return bounds;
}

Bounds all_bytes() {
  Bounds bounds;
  for (int e = 0; e < kPadElements; ++e) {
    bounds.low[e] = 0;
    bounds.high[e] = 255;
  }
  bounds.scale_low = 0;
  bounds.scale_high = 255;
  bounds.signs = 3;
  return bounds;
}

#if kLanesAreItems

// For GPUs: 16 work items share the 64 boxes or PADs; each has four of them, as the bytes of one number. Neighbouring
// items read neighbouring numbers, and each goes on with what its four leave. A group is one warp of NVIDIA: some
// devices refuse larger ones (Mesa's rusticl allows 32).
enum { kSearchItems = 32, kItemsOfBlock = kFilterLanes / 4, kBlocksAtOnce = kSearchItems / kItemsOfBlock };
#define SEARCH_KERNEL kernel __attribute__((reqd_work_group_size(kSearchItems, 1, 1)))

typedef uint Met;  // a set bit is the highest bit of a byte

INLINE uint in_all_bytes(uint byte) { return byte * 0x01010101u; }

// Sets the highest bit of each byte where the byte of `a` is at least that of `b`.
INLINE Met at_least(uint a, uint b) {
  const uint low_bits = (a | 0x80808080u) - (b & 0x7f7f7f7fu);
  return ((a & ~b) | (~(a ^ b) & low_bits)) & 0x80808080u;
}

INLINE Met any_bit(uint bytes, uint bits) { return ((bytes & in_all_bytes(bits)) + 0x7f7f7f7fu) & 0x80808080u; }

// This item's four bytes of a row.
INLINE uint row_part(global const uchar* rows, int row) {
  return ((global const uint*)rows)[row * kItemsOfBlock + (int)get_local_id(0) % kItemsOfBlock];
}

INLINE Met boxes_met(global const uchar* rows, const Bounds* bounds) {
  Met met = at_least(in_all_bytes(bounds->scale_high), row_part(rows, 2 * kPadElements)) &
            at_least(row_part(rows, 2 * kPadElements + 1), in_all_bytes(bounds->scale_low)) &
            any_bit(row_part(rows, 2 * kPadElements + 2), bounds->signs);
#pragma unroll
  for (int e = 0; e < kPadElements; ++e) {
    met &= at_least(in_all_bytes(bounds->high[e]), row_part(rows, e)) &
           at_least(row_part(rows, kPadElements + e), in_all_bytes(bounds->low[e]));
  }
  return met;
}

INLINE uint next_lane(Met met) {
  return (uint)(get_local_id(0) % kItemsOfBlock) * 4 + (31 - (uint)clz(met & -met)) / 8;
}

#else

#define SEARCH_KERNEL kernel
enum { kItemsOfBlock = 1, kBlocksAtOnce = 1 };

typedef ulong Met;  // one bit for each of the 64

// One byte for each lane: 0 or 1.
typedef union LaneBytes {
  uchar byte[kFilterLanes];
  ulong word[kFilterLanes / 8];
} LaneBytes;

INLINE Met lane_bits(const LaneBytes* lanes) {
  ulong any = 0;
  for (int k = 0; k < kFilterLanes / 8; ++k) any |= lanes->word[k];
  if (any == 0) return 0;
  ulong bits = 0;
  // The product gathers the lowest bits of eight bytes in its highest byte.
  for (int k = 0; k < kFilterLanes / 8; ++k) bits |= (lanes->word[k] * 0x0102040810204080ul >> 56) << (8 * k);
  return bits;
}

INLINE Met boxes_met(global const uchar* rows, const Bounds* bounds) {
  LaneBytes met;
  for (int i = 0; i < kFilterLanes; ++i) {
    global const uchar* low = rows + i;
    global const uchar* high = low + kPadElements * kFilterLanes;
    global const uchar* rest = high + kPadElements * kFilterLanes;
    uchar meets = (uchar)((rest[0] <= bounds->scale_high) & (rest[kFilterLanes] >= bounds->scale_low) &
                          ((rest[2 * kFilterLanes] & bounds->signs) != 0));
#pragma unroll
    for (int e = 0; e < kPadElements; ++e) {
      meets &= (uchar)((low[e * kFilterLanes] <= bounds->high[e]) & (high[e * kFilterLanes] >= bounds->low[e]));
    }
    met.byte[i] = meets;
  }
  return lane_bits(&met);
}

INLINE uint next_lane(Met met) { return 63 - (uint)clz(met & -met); }

#endif

// The boxes of a root that the bounds meet, from all items of the sample.
INLINE ulong nodes_met(global const uchar* rows, const Bounds* bounds, local uint* shared) {
#if kLanesAreItems
  local uint* halves = shared + 2 * (get_local_id(0) / kItemsOfBlock);
  const uint item = (uint)get_local_id(0) % kItemsOfBlock;
  if (item < 2) halves[item] = 0;
  barrier(CLK_LOCAL_MEM_FENCE);
  uint bits = 0;
  for (Met met = boxes_met(rows, bounds); met != 0; met &= met - 1) bits |= 1u << (next_lane(met) % 32);
  if (bits != 0) atomic_or(halves + item / 8, bits);
  barrier(CLK_LOCAL_MEM_FENCE);
  return (ulong)halves[1] << 32 | halves[0];
#else
  return boxes_met(rows, bounds);
#endif
}

// Work item: (target sample, root); on GPUs 16 items together. Finds the blocks that may hold pairs within the sample's
// reach, in no particular order; blocks beyond `capacity` are lost, but counted. Where `look_at_boxes` is 0 it finds
// all blocks. Segments whose number is no multiple of `segment_stride` are skipped.
SEARCH_KERNEL void find_blocks(global const RootRecord* roots, global const uchar* node_boxes,
                               global const uchar* block_boxes, uint look_at_boxes, uint segment_stride,
                               global const SampleRecord* samples, uint sample_count, uint capacity,
                               global uint* block_count, global BlockRecord* blocks) {
  local uint shared[2 * kBlocksAtOnce];
  const RootRecord root = roots[get_global_id(1)];
  if (root.segment % segment_stride != 0) return;  // the same for all items of a group
  const uint t = (uint)get_global_id(0) / kItemsOfBlock;
  const bool is_asked = t < sample_count && samples[min(t, sample_count - 1)].reach != 0;
  Bounds bounds = bounds_of(samples + min(t, sample_count - 1), root.level);
  if (!look_at_boxes) bounds = all_bytes();
  global const uchar* root_rows = node_boxes + get_global_id(1) * (kBoxRows * kFilterLanes);
  ulong nodes = nodes_met(root_rows, &bounds, shared);
  if (!is_asked) return;
  for (; nodes != 0; nodes &= nodes - 1) {
    const uint node = root.first_node + 63 - (uint)clz(nodes & -nodes);
    const Met met = boxes_met(block_boxes + (size_t)node * (kBoxRows * kFilterLanes), &bounds);
    if (met == 0) continue;
    uint place = claim_places(block_count, (uint)popcount(met));
    for (Met left = met; left != 0 && place < capacity; left &= left - 1) {
      const BlockRecord block = {t, node * kFilterLanes + next_lane(left), root.level};
      blocks[place++] = block;
    }
  }
}
