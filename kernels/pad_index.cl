// core/pad/pad_index.h in OpenCL C: which blocks of the index may hold pairs of a target sample.
//
// 64 boxes, or PADs, are tested at once; the loop over them is left to the compiler: it knows how many bytes the device
// handles at once.

enum IndexSizes {
  kPadElements = 2 * (kPadLevels - 1),
  kFilterRows = kPadElements + 2,
  kBoxRows = 2 * kPadElements + 3,  // the elements' least bytes, their largest, the scales', the signs
  // Numbers of 16 bits: the elements' low bits, four of each; the upper half of the length that estimates the scale; the
  // source, lower half first.
  kLowNumbers = (kPadElements + 3) / 4,
  kPlaceNumbers = kLowNumbers + 3
};

// One byte for each lane, 0 or 1.
typedef union LaneBytes {
  uchar byte[kFilterLanes];
  ulong word[kFilterLanes / 8];
} LaneBytes;

INLINE ulong lane_bits(const LaneBytes* lanes) {
  ulong any = 0;
  for (int k = 0; k < kFilterLanes / 8; ++k) any |= lanes->word[k];
  if (any == 0) return 0;
  ulong bits = 0;
  // The product gathers the lowest bits of eight bytes in its highest byte.
  for (int k = 0; k < kFilterLanes / 8; ++k) bits |= (lanes->word[k] * 0x0102040810204080ul >> 56) << (8 * k);
  return bits;
}

// Bytes that a pair of a target sample has, inclusive (core/pad/pad_filter.h).
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

// Bit i is set where box i may hold a pair.
INLINE ulong boxes_met(global const uchar* rows, const Bounds* bounds) {
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

// Work item: (target sample, root). The blocks that may hold pairs within the sample's reach, in no
// particular order; of more than `capacity` the rest is lost, but counted. Where `look_at_boxes` is 0, all blocks.
// Segments whose number is no multiple of `segment_stride` are left out.
kernel void find_blocks(global const RootRecord* roots, global const uchar* node_boxes,
                        global const uchar* block_boxes, uint look_at_boxes, uint segment_stride,
                        global const SampleRecord* samples,
                        uint sample_count, uint capacity, global uint* block_count,
                        global BlockRecord* blocks) {
  const uint t = get_global_id(0);
  if (t >= sample_count || samples[t].reach == 0) return;
  const RootRecord root = roots[get_global_id(1)];
  if (root.segment % segment_stride != 0) return;
  Bounds bounds = bounds_of(samples + t, root.level);
  if (!look_at_boxes) bounds = all_bytes();
  global const uchar* root_rows = node_boxes + get_global_id(1) * (kBoxRows * kFilterLanes);
  for (ulong nodes = boxes_met(root_rows, &bounds); nodes != 0; nodes &= nodes - 1) {
    const uint node = root.first_node + 63 - (uint)clz(nodes & -nodes);
    const ulong met = boxes_met(block_boxes + (size_t)node * (kBoxRows * kFilterLanes), &bounds);
    if (met == 0) continue;
    uint place = claim_places(block_count, (uint)popcount(met));
    for (ulong left = met; left != 0 && place < capacity; left &= left - 1) {
      const BlockRecord block = {t, node * kFilterLanes + 63 - (uint)clz(left & -left), root.level};
      blocks[place++] = block;
    }
  }
}
