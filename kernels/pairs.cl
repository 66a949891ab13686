// core/matching/pair_selection.cpp in OpenCL C (paper section 3.3): scale window, sign, PAD distance, local
// minima along the shape's curve, the best few of each (target sample, shape).
//
// First an exact filter of bytes (core/pad/pad_filter.h), then the distance itself where a pair may be near. The
// filter's loop over kFilterLanes sources is left to the compiler: it knows how many bytes the device handles at once.

enum PairSizes { kPadElements = 2 * (kPadLevels - 1), kFilterRows = kPadElements + 2 };

// Elements of a PAD behind one another, zeros behind them.
#if kPadRow == 8
typedef ushort8 PadRow;
#define load_row vload8
uint largest_element(PadRow row) {
  const ushort4 a = max(row.lo, row.hi);
  const ushort2 b = max(a.lo, a.hi);
  return max(b.x, b.y);
}
#else
typedef ushort16 PadRow;
#define load_row vload16
uint largest_element(PadRow row) {
  const ushort8 a = max(row.lo, row.hi);
  const ushort4 b = max(a.lo, a.hi);
  const ushort2 c = max(b.lo, b.hi);
  return max(c.x, c.y);
}
#endif

#define NO_PAIR 0xffffffffu

uint distance_bin(uint distance_steps, uint beta_steps) { return distance_steps * kDistanceBins / beta_steps; }

// A target sample as its pairs need it.
typedef struct Target {
  PadRow row;
  float scale_length;
  float convexity;
  uint reach;
  float chord_x;
  float chord_y;
  Stances stances;
} Target;

// Key points between which the chord tells the rotation before any alignment.
enum ChordEnds {
  kChordReach = kChordLevel < kPadLevels - 1 ? kChordLevel : kPadLevels - 1,
  kChordFirst = kPadLevels - 1 - kChordReach,
  kChordLast = kPadLevels + 1 + kChordReach
};

Target load_target(global const SampleRecord* sample, Stances stances) {
  ushort element[kPadRow];
  for (int e = 0; e < kPadRow; ++e) element[e] = e < kPadElements ? (ushort)sample->element[e] : (ushort)0;
  const Target target = {load_row(0, element), sample->scale_length, sample->convexity, sample->reach,
                         sample->keypoint_x[kChordLast] - sample->keypoint_x[kChordFirst],
                         sample->keypoint_y[kChordLast] - sample->keypoint_y[kChordFirst], stances};
  return target;
}

// What the filter lets through of a target sample and one level (core/pad/pad_filter.h).
typedef struct FilterWindow {
  uchar low[kPadElements];
  uchar width;
  uchar scale_low;
  uchar scale_width;
  uchar signs;
} FilterWindow;

void set_pad_window(FilterWindow* window, global const SampleRecord* sample) {
  window->signs = (uchar)sample->signs;
  window->width = (uchar)sample->pad_width;
  for (int e = 0; e < kPadElements; ++e) window->low[e] = (uchar)sample->pad_low[e];
}

// Bit i is set where source i of the block may be near.
INLINE ulong filter_block(global const uchar* rows, const FilterWindow* window) {
  uchar passes[kFilterLanes];
  for (int i = 0; i < kFilterLanes; ++i) {
    uchar farthest = 0;
#pragma unroll
    for (int e = 0; e < kPadElements; ++e) {
      farthest = max(farthest, (uchar)(rows[e * kFilterLanes + i] - window->low[e]));
    }
    const uchar scale = (uchar)(rows[kPadElements * kFilterLanes + i] - window->scale_low);
    const uchar sign = rows[(kPadElements + 1) * kFilterLanes + i] & window->signs;
    passes[i] = (uchar)((farthest <= window->width) & (scale <= window->scale_width) & (sign != 0));
  }
  const ulong* words = (const ulong*)passes;
  ulong any = 0;
  for (int k = 0; k < kFilterLanes / 8; ++k) any |= words[k];
  if (any == 0) return 0;
  ulong bits = 0;
  // The product gathers the lowest bits of eight bytes in its highest byte.
  for (int k = 0; k < kFilterLanes / 8; ++k) bits |= (words[k] * 0x0102040810204080ul >> 56) << (8 * k);
  return bits;
}

// A shape's PADs.
typedef struct Pads {
  global const ushort* row;
  global const PadRecord* record;
  global const short* keypoint;
} Pads;

bool may_turn(const Pads* pads, uint source, const Target* target) {
  if (target->stances.stance->docked_edge_x <= -1) return true;
  global const short* x = pads->keypoint + (size_t)source * 2 * kPadKeypoints;
  global const short* y = x + kPadKeypoints;
  const float chord_x = (float)x[kChordLast] - (float)x[kChordFirst];
  const float chord_y = (float)y[kChordLast] - (float)y[kChordFirst];
  const float turn_x = chord_x * target->chord_x + chord_y * target->chord_y;
  const float turn_y = chord_x * target->chord_y - chord_y * target->chord_x;
  for (uint i = 0; i < target->stances.list.count; ++i) {
    const StanceRecord stance = target->stances.stance[i];
    if (direction_allowed(docked_rotations(&stance), turn_x, turn_y, 1, 0)) return true;
  }
  return false;
}

// Equation 1, steps; NO_PAIR where the scale, the sign or the rotation cannot fit.
INLINE uint pair_distance(const Pads* pads, uint source, constant LevelRecord* level, const Target* target) {
  const PadRecord record = pads->record[source];
  const float low_px = max(level->scale_low_px, target->stances.list.min_scale_px);
  const float high_px = min(level->scale_high_px, target->stances.list.max_scale_px);
  if (target->scale_length < record.scale_length * (low_px * kScaleWindowLow) ||
      target->scale_length > record.scale_length * (high_px * kScaleWindowHigh) ||
      target->convexity * record.convexity < 0 || !may_turn(pads, source, target)) {
    return NO_PAIR;
  }
  return largest_element(abs_diff(target->row, load_row(source, pads->row)));
}

typedef struct BestPairs {
  int count;
  uint distance[kPairsPerShape];
  uint source[kPairsPerShape];
} BestPairs;

// A pair must be nearer than this: where the list is full, a later pair of equal distance comes behind and falls off.
uint farthest_kept(const BestPairs* best, uint reach) {
  return best->count < kPairsPerShape ? reach : best->distance[kPairsPerShape - 1];
}

// Sources come in ascending order, so that a later pair of equal distance comes behind.
void keep_pair(BestPairs* best, uint distance, uint source) {
  int at = best->count < kPairsPerShape ? best->count++ : kPairsPerShape - 1;
  for (; at > 0 && best->distance[at - 1] > distance; --at) {
    best->distance[at] = best->distance[at - 1];
    best->source[at] = best->source[at - 1];
  }
  best->distance[at] = distance;
  best->source[at] = source;
}

// Keeps a source that is a local minimum along its level's closed curve.
void keep_if_minimum(BestPairs* best, const Pads* pads, uint source, constant LevelRecord* level,
                     const Target* target) {
  const uint distance = pair_distance(pads, source, level, target);
  if (distance >= farthest_kept(best, target->reach)) return;
  const uint last = level->first + level->count - 1;
  const uint before = source == level->first ? last : source - 1;
  const uint after = source == last ? level->first : source + 1;
  if (distance > pair_distance(pads, before, level, target)) return;
  if (distance >= pair_distance(pads, after, level, target)) return;
  keep_pair(best, distance, source);
}

// Work item: (target sample - first_sample, shape). The pairs of (sample, shape) start at place
// ((sample - first_sample) * shapes + shape) * kPairsPerShape. `only_longer_reach`: the places hold what was found
// within each sample's held_reach.
kernel void select_pairs(constant MatchRecord* match, global const StanceRecord* stances,
                         global const StanceListRecord* stance_lists, global const uint* shape_class,
                         global const uchar* pad_bytes, global const ushort* rows, global const PadRecord* records,
                         global const short* keypoints, constant ColourRecord* colour, global const uint* near_bits,
                         uint first_sample, uint end_sample, uint only_longer_reach,
                         global const SampleRecord* samples, global PairRecord* pairs, global uint* pair_count) {
  const uint t = first_sample + get_global_id(0);
  const uint shape = get_global_id(1);
  if (t >= end_sample) return;
  global const SampleRecord* sample = samples + t;
  if (only_longer_reach && sample->reach <= sample->held_reach) return;
  BestPairs best;
  best.count = 0;
  const Stances standing = stances_of(stances, stance_lists, shape_class, shape);
  if (sample->reach > 0 && standing.list.count > 0 &&
      has_near_colour(sample, near_bits, colour->near_words, match->first_shape + shape)) {
    const size_t first_source = (size_t)shape * match->sources;
    global const uchar* bytes = pad_bytes + first_source * kFilterRows;
    const Pads pads = {rows + first_source * kPadRow, records + first_source,
                       keypoints + first_source * 2 * kPadKeypoints};
    const Target target = load_target(sample, standing);
    FilterWindow window;
    set_pad_window(&window, sample);
    for (uint k = 0; k < match->level_count; ++k) {
      constant LevelRecord* level = match->level + k;
      window.scale_low = (uchar)sample->scale_low[k];
      window.scale_width = (uchar)sample->scale_width[k];
      for (uint first = level->first; first < level->first + level->count; first += kFilterLanes) {
        for (ulong left = filter_block(bytes + first * kFilterRows, &window); left != 0; left &= left - 1) {
          keep_if_minimum(&best, &pads, first + 63 - (uint)clz(left & -left), level, &target);
        }
      }
    }
  }
  const size_t place = (size_t)get_global_id(0) * match->shapes + shape;
  pair_count[place] = best.count;
  for (int i = 0; i < best.count; ++i) {
    const PairRecord pair = {best.source[i], best.distance[i]};
    pairs[place * kPairsPerShape + i] = pair;
  }
}

// Work item as in select_pairs, whose pairs begin with sample `first_paired`. `histogram`: kDistanceBins for each
// target sample. Whole numbers: any order will do.
kernel void count_pairs(constant MatchRecord* match, uint first_sample, uint end_sample, uint first_paired,
                        global const SampleRecord* samples, global const PairRecord* pairs,
                        global const uint* pair_count, global uint* histogram) {
  const uint t = first_sample + get_global_id(0);
  if (t >= end_sample) return;
  const size_t place = (size_t)(t - first_paired) * match->shapes + get_global_id(1);
  for (uint i = 0; i < pair_count[place]; ++i) {
    const uint distance = pairs[place * kPairsPerShape + i].distance;
    if (distance >= samples[t].reach) break;  // best first
    atomic_inc(histogram + t * kDistanceBins + distance_bin(distance, match->beta_steps));
  }
}
