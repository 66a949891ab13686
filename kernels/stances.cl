// core/matching/stances.h in OpenCL C: the ways in which the shapes of this shard may stand.

typedef struct Stances {
  global const StanceRecord* stance;
  StanceListRecord list;
} Stances;

Stances stances_of(global const StanceRecord* stances, global const StanceListRecord* stance_lists,
                   global const uint* shape_class, uint shape) {
  const StanceListRecord list = stance_lists[shape_class[shape]];
  const Stances result = {stances + list.first, list};
  return result;
}

// core/matching/size_map.h: the part of its sizes that a shape may have at a place.
float size_part(constant MatchRecord* match, global const float* size_map, float x, float y) {
  if (match->size_width == 0) return 1;
  const float u = clamp(x * match->size_cells_per_px - 0.5f, 0.f, (float)(match->size_width - 1));
  const float v = clamp(y * match->size_cells_per_px - 0.5f, 0.f, (float)(match->size_height - 1));
  const uint i = (uint)u;
  const uint j = (uint)v;
  const uint right = min(i + 1, match->size_width - 1);
  const uint below = min(j + 1, match->size_height - 1);
  const float s = u - (float)i;
  const float t = v - (float)j;
  global const float* upper = size_map + (size_t)j * match->size_width;
  global const float* lower = size_map + (size_t)below * match->size_width;
  return (upper[i] * (1 - s) + upper[right] * s) * (1 - t) + (lower[i] * (1 - s) + lower[right] * s) * t;
}

StanceRecord with_sizes_up_to(float part, StanceRecord stance) {
  if (part >= 1) return stance;
  stance.log2_scale_ratio = part * stance.log2_scale_ratio;
  stance.max_scale_px = stance.min_scale_px * portable_exp2(stance.log2_scale_ratio);
  return stance;
}
