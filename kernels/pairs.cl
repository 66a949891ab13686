// core/pair_selection.cpp in OpenCL C (paper section 3.3; design, method 4): scale window, sign, PAD distance, local
// minima along the shape's curve, the best few of each (target sample, shape).
//
// A shape's PADs lie level by level, each level element by element: element 0 of all its samples, element 1, .., then
// the length that estimates the scale, then the convexity.

enum PairSizes {
  kPadElements = 2 * (kPadLevels - 1),
  kPadFloats = kPadElements + 2,
  kRim = kLanes  // before and after the distances, for the neighbours of the first and the last
};

#define NO_PAIR 9.f

uint distance_bin(float distance, float beta) {
  const int bin = (int)(distance / beta * (float)kDistanceBins);
  return (uint)(bin < kDistanceBins ? bin : kDistanceBins - 1);
}

// Distances of PADs [16 block, 16 block + 16) of a level; NO_PAIR where the scale or the sign cannot fit, or where half
// of the elements show that no lane comes below beta.
float16 pad_distances(global const float* pads, constant LevelRecord* level, uint block,
                      global const SampleRecord* target, float beta) {
  const uint count = level->count;
  const float16 length = vload16(block, pads + kPadElements * count);
  const float16 convexity = vload16(block, pads + (kPadElements + 1) * count);
  const int16 fits = (target->scale_length >= length * (level->scale_low_px * kScaleWindowLow)) &
                     (target->scale_length <= length * (level->scale_high_px * kScaleWindowHigh)) &
                     (target->convexity * convexity >= 0);
  if (!any_lane(fits)) return NO_PAIR;
  float16 distance = 0;
  for (int e = 0; e < kPadElements / 2; ++e) {
    distance = max(distance, fabs(target->element[e] - vload16(block, pads + e * count)));
  }
  if (!any_lane(fits & (distance < beta))) return NO_PAIR;
  for (int e = kPadElements / 2; e < kPadElements; ++e) {
    distance = max(distance, fabs(target->element[e] - vload16(block, pads + e * count)));
  }
  return fits ? distance : (float16)NO_PAIR;
}

typedef struct BestPairs {
  int count;
  float distance[kPairsPerShape];
  uint source[kPairsPerShape];
} BestPairs;

// A pair must be nearer than this: where the list is full, a later pair of equal distance comes behind and falls off.
float farthest_kept(const BestPairs* best, float beta) {
  return best->count < kPairsPerShape ? beta : best->distance[kPairsPerShape - 1];
}

// Sources come in ascending order, so that a later pair of equal distance comes behind.
void keep_pair(BestPairs* best, float distance, uint source) {
  int at = best->count < kPairsPerShape ? best->count++ : kPairsPerShape - 1;
  for (; at > 0 && best->distance[at - 1] > distance; --at) {
    best->distance[at] = best->distance[at - 1];
    best->source[at] = best->source[at - 1];
  }
  best->distance[at] = distance;
  best->source[at] = source;
}

// `distance` points at the first of a closed curve's distances; the places before and behind them are free.
void keep_local_minima(BestPairs* best, float* distance, uint count, uint first_source, float beta) {
  distance[-1] = distance[count - 1];
  distance[count] = distance[0];
  for (uint j = 0; j < count; j += kLanes) {
    const float16 d = vload16(0, distance + j);
    const int16 near = d < farthest_kept(best, beta);
    const int16 minimum = near & (d <= vload16(0, distance + j - 1)) & (d < vload16(0, distance + j + 1));
    for (uint left = lane_bits(minimum); left != 0; left &= left - 1) {
      const uint k = 31 - clz(left & -left);
      if (distance[j + k] < farthest_kept(best, beta)) keep_pair(best, distance[j + k], first_source + j + k);
    }
  }
}

// Work item: (target sample - first_sample, shape). The pairs of (sample, shape) start at place
// ((sample - first_sample) * shapes + shape) * kPairsPerShape.
kernel void select_pairs(constant MatchRecord* match, global const float* pads, uint first_sample, uint end_sample,
                         global const SampleRecord* samples, global PairRecord* pairs, global uint* pair_count) {
  const uint t = first_sample + get_global_id(0);
  const uint shape = get_global_id(1);
  if (t >= end_sample) return;
  global const SampleRecord* target = samples + t;
  float distance[kRim + kMaxLevelSamples + kRim];
  BestPairs best;
  best.count = 0;
  for (uint k = 0; k < match->level_count; ++k) {
    constant LevelRecord* level = match->level + k;
    global const float* level_pads = pads + ((size_t)shape * match->sources + level->first) * kPadFloats;
    int16 near = 0;
    for (uint block = 0; block < level->count / kLanes; ++block) {
      const float16 d = pad_distances(level_pads, level, block, target, match->beta);
      vstore16(d, block, distance + kRim);
      near |= d < match->beta;
    }
    if (any_lane(near)) keep_local_minima(&best, distance + kRim, level->count, level->first, match->beta);
  }
  const size_t place = (size_t)get_global_id(0) * match->shapes + shape;
  pair_count[place] = best.count;
  for (int i = 0; i < best.count; ++i) {
    const PairRecord pair = {best.source[i], best.distance[i]};
    pairs[place * kPairsPerShape + i] = pair;
  }
}

// Work item as in select_pairs, whose pairs begin with sample `first_paired`. `histogram`: kDistanceBins for each target
// sample. Whole numbers: any order will do.
kernel void count_pairs(constant MatchRecord* match, uint first_sample, uint end_sample, uint first_paired,
                        global const PairRecord* pairs, global const uint* pair_count, global uint* histogram) {
  const uint t = first_sample + get_global_id(0);
  if (t >= end_sample) return;
  const size_t place = (size_t)(t - first_paired) * match->shapes + get_global_id(1);
  for (uint i = 0; i < pair_count[place]; ++i) {
    const uint bin = distance_bin(pairs[place * kPairsPerShape + i].distance, match->beta);
    atomic_inc(histogram + t * kDistanceBins + bin);
  }
}
