// The 16 lanes of a docking: its points are looked up 16 at a time. The same source serves two kinds of devices:
// - kLanesAreItems == 0, for CPUs: a work item has all lanes of a docking, in vectors of 16.
// - kLanesAreItems == 1, for GPUs: the 16 work items of a group have one lane each.
// A LaneFloat or LaneInt holds one number for each lane: a vector, or the number of the work item's own lane.
// Comparisons give masks, which work with &, ~ and ? : in both cases; a set lane is -1 in a vector and 1 alone.
//
// Decisions about a docking depend on all its lanes. The functions below give each work item the same result, so that
// all items take the same branches and may meet at barriers in any of them.

#if kLanesAreItems
typedef float LaneFloat;
typedef int LaneInt;
#define as_lane_float as_float
#define convert_lane_float convert_float
#define convert_lane_int convert_int
// Memory that the work items of a docking share. What one item writes the others may read after sync_lanes.
#define SHARED local
#define DOCKING_KERNEL kernel __attribute__((reqd_work_group_size(kLanes, 1, 1)))
#else
typedef float16 LaneFloat;
typedef int16 LaneInt;
#define as_lane_float as_float16
#define convert_lane_float convert_float16
#define convert_lane_int convert_int16
#define SHARED private
#define DOCKING_KERNEL kernel
#endif

enum LaneSizes {
  kItems = kLanesAreItems ? kLanes : 1,  // work items of a docking
  kRow = kLanes + 1,  // of scratch: with rows of 16 all items would use the same few banks of local memory
  kScratch = kLanesAreItems ? kLanes * kRow : 1
};

typedef struct Lanes {
  int item;             // index of this work item within its docking
  SHARED int* scratch;  // memory for exchange between the items
} Lanes;

// Each DOCKING_KERNEL must declare: SHARED int scratch[kScratch];
Lanes lanes_of_docking(SHARED int* scratch) {
  const Lanes lanes = {(int)get_local_id(0) % kItems, scratch};
  return lanes;
}

void sync_lanes(void) {
#if kLanesAreItems
  barrier(CLK_LOCAL_MEM_FENCE);
#endif
}

// The numbers of all lanes, in every item.
int16 ints_of_lanes(Lanes lanes, LaneInt v) {
#if kLanesAreItems
  sync_lanes();  // until every item has read the old content
  lanes.scratch[lanes.item] = v;
  sync_lanes();
  return vload16(0, lanes.scratch);
#else
  return v;
#endif
}

float16 floats_of_lanes(Lanes lanes, LaneFloat v) {
#if kLanesAreItems
  return as_float16(ints_of_lanes(lanes, as_int(v)));
#else
  return v;
#endif
}

// The sum of the lanes: the upper half is added to the lower half, repeatedly (core/base/lanes.h).
float sum_of_16(float16 v) {
  const float8 a = v.lo + v.hi;
  const float4 b = a.lo + a.hi;
  const float2 c = b.lo + b.hi;
  return c.x + c.y;
}

float sum_of_lanes(Lanes lanes, LaneFloat v) { return sum_of_16(floats_of_lanes(lanes, v)); }

// The sum over the lanes of each of `count` (at most 16) numbers.
void sums_of_lanes(Lanes lanes, int count, const LaneFloat* v, float* sums) {
#if kLanesAreItems
  sync_lanes();
  for (int k = 0; k < count; ++k) lanes.scratch[k * kRow + lanes.item] = as_int(v[k]);
  sync_lanes();
  SHARED int* row = lanes.scratch + lanes.item * kRow;  // each work item sums one row and stores the sum at its end
  if (lanes.item < count) row[kLanes] = as_int(sum_of_16(as_float16(vload16(0, row))));
  sync_lanes();
  for (int k = 0; k < count; ++k) sums[k] = as_float(lanes.scratch[k * kRow + kLanes]);
#else
  for (int k = 0; k < count; ++k) sums[k] = sum_of_16(v[k]);
#endif
}

int int_sum_of_16(int16 v) {
  const int8 a = v.lo + v.hi;
  const int4 b = a.lo + a.hi;
  const int2 c = b.lo + b.hi;
  return c.x + c.y;
}

int int_sum_of_lanes(Lanes lanes, LaneInt v) { return int_sum_of_16(ints_of_lanes(lanes, v)); }

int count_lanes(Lanes lanes, LaneInt mask) { return int_sum_of_lanes(lanes, mask ? (LaneInt)1 : (LaneInt)0); }

// Whether a lane of this work item is set; lanes of other items are not tested.
int any_own_lane(LaneInt mask) {
#if kLanesAreItems
  return mask;
#else
  const int8 a = mask.lo | mask.hi;
  const int4 b = a.lo | a.hi;
  const int2 c = b.lo | b.hi;
  return c.x | c.y;
#endif
}

int any_lane(Lanes lanes, LaneInt mask) {
#if kLanesAreItems
  return count_lanes(lanes, mask);
#else
  return any_own_lane(mask);
#endif
}

// The set lane that has `*before` set lanes before it. Where there is none: NO_LANE, and `*before` is reduced by the
// number of set lanes.
#define NO_LANE (-1)
int set_lane(Lanes lanes, LaneInt mask, int* before) {
  const int16 set = ints_of_lanes(lanes, mask ? (LaneInt)1 : (LaneInt)0);
  const int count = int_sum_of_16(set);
  int lane = NO_LANE;
  if (*before < count) {
    int one[kLanes];
    vstore16(set, 0, one);
    for (int left = *before; left >= 0; left -= one[lane]) ++lane;
  }
  *before -= count;
  return lane;
}

float largest_lane(Lanes lanes, LaneFloat v) {
  const float16 all = floats_of_lanes(lanes, v);
  const float8 a = max(all.lo, all.hi);
  const float4 b = max(a.lo, a.hi);
  const float2 c = max(b.lo, b.hi);
  return max(c.x, c.y);
}

float smallest_lane(Lanes lanes, LaneFloat v) { return -largest_lane(lanes, -v); }

// The index of each lane's element in block `block`, where elements are dealt to lanes 0 to 15 in turn.
LaneInt numbers_of_block(Lanes lanes, int block) {
#if kLanesAreItems
  return block * kLanes + lanes.item;
#else
  return (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15) + block * kLanes;
#endif
}

LaneFloat load_lanes(Lanes lanes, int block, global const float* from) {
#if kLanesAreItems
  return from[block * kLanes + lanes.item];
#else
  return vload16(block, from);
#endif
}

void store_lanes(Lanes lanes, LaneFloat v, int block, SHARED float* to) {
#if kLanesAreItems
  to[block * kLanes + lanes.item] = v;
#else
  vstore16(v, block, to);
#endif
}

LaneFloat portable_exp2_lanes(LaneFloat x) {
  const LaneFloat whole = floor(x);
  EXP2_OF_FRACTION(LaneFloat, p, (x - whole));
  return p * as_lane_float((convert_lane_int(whole) + 127) << 23);  // times a power of two: always exact
}
