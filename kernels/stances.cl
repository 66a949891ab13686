// core/matching/stances.h in OpenCL C: the stances of the shapes of this shard.

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

// core/geometry/size_map.h: the part of its range of sizes that a shape may use at a place.
float size_part(constant MatchRecord* match, global const float* size_map, float x, float y) {
  if (match->size_width == 0) return 1;
  const CellLookup c = cell_lookup(x, y, match->size_cells_per_px, match->size_width, match->size_height);
  global const float* upper = size_map + (size_t)c.upper * match->size_width;
  global const float* lower = size_map + (size_t)c.lower * match->size_width;
  return (upper[c.left] * (1 - c.s) + upper[c.right] * c.s) * (1 - c.t) +
         (lower[c.left] * (1 - c.s) + lower[c.right] * c.s) * c.t;
}

StanceRecord with_sizes_up_to(float part, StanceRecord stance) {
  if (part >= 1) return stance;
  stance.log2_scale_ratio = part * stance.log2_scale_ratio;
  stance.max_scale_px = stance.min_scale_px * portable_exp2(stance.log2_scale_ratio);
  return stance;
}
