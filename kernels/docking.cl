// core/matching/docking.cpp in OpenCL C (paper section 3.3): makes a similarity from a pair or from random bits, and
// tests it at a few points of the free field.

#define NO_DOCKING (-1.f)

typedef struct Alignment {
  PoseRecord canvas_from_shape;
  uint stance;  // index in the list
  bool valid;
} Alignment;

// (x, y) of the shape and (x, y) of the target, for key point `i`.
float4 keypoint_pair(global const short* shape_x, global const short* shape_y, float step,
                     global const SampleRecord* target, int i) {
  return (float4)((float)shape_x[i] * step, (float)shape_y[i] * step, target->keypoint_x[i], target->keypoint_y[i]);
}

// Means and products of the key points of shape and target, for least squares.
typedef struct Moments {
  float4 mean;     // of the shape, then of the target
  float4 product;  // real and imaginary part of the product, variance sum of the shape, then of the target
  float count;
} Moments;

Moments moments(global const short* shape_x, global const short* shape_y, float step, global const SampleRecord* target,
                int begin, int end) {
  Moments m;
  m.count = (float)(end - begin);
  float4 sum = 0;
  for (int i = begin; i < end; ++i) {
    sum += keypoint_pair(shape_x, shape_y, step, target, i);
  }
  m.mean = sum * (1 / m.count);
  m.product = (float4)(0, 0, 1e-12f, 0);
  for (int i = begin; i < end; ++i) {
    const float4 d = keypoint_pair(shape_x, shape_y, step, target, i) - m.mean;
    m.product += d.xxxz * d.zwxz + (float4)(d.y, -d.y, d.y, d.w) * d.wzyw;
  }
  return m;
}

typedef struct Fit {
  PoseRecord pose;
  float residual;  // mean square, px^2
} Fit;

// The best pose within the stance. False where the rotation would have to change by more than a right angle.
bool fit_within(const StanceRecord* stance, const Moments* m, Fit* fit) {
  float2 product = m->product.xy;
  const DirectionRange rotations = allowed_rotations(stance);
  if (!direction_allowed(rotations, product.x, product.y, 0, 0)) {
    const float2 direction = nearest_edge(rotations, product.x, product.y);
    const float along = product.x * direction.x + product.y * direction.y;
    if (along <= 0) return false;
    product = direction * along;
  }
  const PoseRecord best = {product.x / m->product.z, product.y / m->product.z, 0, 0};
  const float best_scale = scale_of(best);
  fit->pose = pulled_in(stance, best);
  const float off = scale_of(fit->pose) - best_scale;
  fit->residual = (m->product.w - (best_scale * best_scale - off * off) * m->product.z) / m->count;
  return true;
}

// Least squares at the longest level at which shape and target agree, with the stance that fits best. `shape_x`,
// `shape_y`: key points of the shape's sample, in steps.
Alignment align_pyramids(const Stances* stances, float sizes, global const short* shape_x, global const short* shape_y,
                         float step, global const SampleRecord* target, float scale_low_px, float scale_high_px) {
  Alignment result;
  result.valid = false;
  const int least_level = max(0, kPadLevels - kAlignmentLevels);
  for (int level = kPadLevels - 1; level >= least_level && !result.valid; --level) {
    const Moments m =
        moments(shape_x, shape_y, step, target, kPadLevels - 1 - level, kPadLevels + 2 + level);
    float least = kAlignmentTolerance * kAlignmentUnit_px * sqrt(m.product.w / m.count);
    for (uint k = 0; k < stances->list.count; ++k) {
      const StanceRecord stance = with_sizes_up_to(sizes, stances->stance[k]);
      Fit fit;
      if (!fit_within(&stance, &m, &fit) || fit.residual > least) continue;
      const float scale = scale_of(fit.pose);
      if (scale < scale_low_px || scale > scale_high_px) continue;
      if (result.valid && fit.residual == least) continue;
      least = fit.residual;
      result.canvas_from_shape = fit.pose;
      result.stance = k;
      result.valid = true;
    }
    if (!result.valid) continue;
    const PoseRecord s = result.canvas_from_shape;
    result.canvas_from_shape.tx = m.mean.z - (s.a * m.mean.x - s.b * m.mean.y);
    result.canvas_from_shape.ty = m.mean.w - (s.b * m.mean.x + s.a * m.mean.y);
  }
  return result;
}

float hopeless_depth_px(float scale) { return max(kHopelessDocking_px, kHopelessDocking * scale); }

// A first test with one look-up: where the largest disc inside does not fit, the piece does not fit. It rejects most.
bool disc_fits(global const ShapeRecord* shape, PoseRecord s, const Field* field) {
  const float scale = scale_of(s);
  const float disc_x = s.tx + (s.a * shape->disc_x - s.b * shape->disc_y);
  const float disc_y = s.ty + (s.b * shape->disc_x + s.a * shape->disc_y);
  return field_value(field, disc_x, disc_y) >= shape->disc_radius * scale - hopeless_depth_px(scale);
}

// Counters of boundary points in one int: sums over a block keep each kind in digits of its own.
enum Tally { HIT = 1, BAD = 1 << 8, TOO_BAD = (kMostBadPoints + 1) * BAD, HOPELESS = 1 << 16 };

// The rank of a pose whose disc fits, from 32 boundary points and a third of the interior points. Where the rank is
// below kLeastDockingKey, the result may be any smaller number.
float docking_key(Lanes lanes, global const float* sketch, global const ShapeRecord* shape, PoseRecord s,
                  const Field* field, float max_scale_px) {
  const float scale = scale_of(s);
  const float hopeless_px = hopeless_depth_px(scale);
  const float near_px = max(kNearDocking_px, kNearDocking * scale);
  int tally = 0;
  for (int block = 0; block < kCoarsePoints / kLanes && tally < TOO_BAD; ++block) {
    const Points p = placed_points(lanes, s, sketch + kCoarseAt, kCoarsePoints, block);
    const LaneFloat d = field_values(field, p.x, p.y);
    const LaneInt near = d < near_px ? (LaneInt)HIT : (LaneInt)0;
    const LaneInt deep = d < -hopeless_px ? (LaneInt)HOPELESS : (LaneInt)BAD;
    tally += int_sum_of_lanes(lanes, d < -near_px ? deep : near);
  }
  const int hits = tally % BAD;
  const int bad = tally / BAD;
  const float contact = ((float)hits - kBadPointCost * (float)bad) / (float)kCoarsePoints;
  // Large pieces come first: they are harder to place later.
  const float size = sqrt(sqrt(scale / max_scale_px));
  // Interior points can only lower the rank.
  const bool rejected = tally >= TOO_BAD || contact * size < kLeastDockingKey;
  int covered = 0;
  const int coarse_points = ((int)shape->interior_points + kInteriorStride - 1) / kInteriorStride;
  for (int block = 0; block * kLanes < coarse_points && !rejected; ++block) {
    const Points p = placed_points(lanes, s, sketch + kCoarseInteriorAt, kCoarseInteriorPoints, block);
    const LaneInt used = numbers_of_block(lanes, block) < coarse_points;
    covered += count_lanes(lanes, used & (field_values(field, p.x, p.y) < 0));
  }
  if (rejected) return NO_DOCKING;
  const float points = (float)shape->interior_points;
  const float interior = shape->interior_points == 0 ? 0.f : kCoveredCost * (float)covered / points;
  return (contact - interior) * size;
}

// The factor for the difference between the piece's mean colour and the picture's colour at its place.
float docking_colour_worth(const Picture* picture, global const ShapeRecord* shape, PoseRecord s) {
  if (picture->record->levels == 0) return 1;
  return colour_worth(picture, mean_colour_difference(picture, shape, s));
}

int level_of_source(constant MatchRecord* match, uint source) {
  int k = 0;
  while (source >= match->level[k].first + match->level[k].count) ++k;
  return k;
}

// Appends a docking; the host gathers the answer to a request from these. Those beyond `capacity` are lost, but
// counted.
void add_docking(DockingRecord docking, uint capacity, global uint* count, global DockingRecord* dockings) {
  const uint place = claim_places(count, 1);
  if (place < capacity) dockings[place] = docking;
}

// Computes the key of the docking and appends it unless the early reject drops it.
INLINE void dock(Lanes lanes, DockingRecord docking, constant MatchRecord* match, global const StanceRecord* stances,
                 global const float* sketches, global const ShapeRecord* shapes, const Field* field,
                 const Picture* picture, uint capacity, global uint* count, global DockingRecord* dockings) {
  const uint shape = docking.shape - match->first_shape;
  global const float* sketch = sketches + (size_t)shape * kSketchFloats;
  const float key = docking_key(lanes, sketch, shapes + shape, docking.canvas_from_shape, field, match->max_scale_px);
  if (key < kLeastDockingKey) return;
  docking.key =
      key * docking_colour_worth(picture, shapes + shape, docking.canvas_from_shape) * stances[docking.stance].weight;
  if (lanes.item == 0) add_docking(docking, capacity, count, dockings);
}

// The docking of a pair. Its key is NO_DOCKING where there is none or its disc does not fit.
DockingRecord aligned_pair(PairRecord pair, constant MatchRecord* match, const Stances* standing, float sizes,
                           global const short* keypoint, global const ShapeRecord* shape,
                           global const SampleRecord* target, const Field* field, global uint* evaluated) {
  const uint source = pair.source % match->sources;
  DockingRecord docking = {pair.sample, match->first_shape + pair.source / match->sources, source, 0, NO_DOCKING,
                           {0, 0, 0, 0}};
  constant LevelRecord* level = match->level + level_of_source(match, source);
  const Alignment aligned = align_pyramids(standing, sizes, keypoint, keypoint + kPadKeypoints, shape->keypoint_step,
                                           target, level->scale_low_px, level->scale_high_px);
  if (!aligned.valid) return docking;
  atomic_inc(evaluated);
  docking.stance = standing->list.first + aligned.stance;
  docking.canvas_from_shape = aligned.canvas_from_shape;
  if (disc_fits(shape, aligned.canvas_from_shape, field)) docking.key = 0;
  return docking;
}

// Index of the next docking from `i` on, or `count`.
int next_docking(SHARED const DockingRecord* dockings, int count, int i) {
  while (i < count && dockings[i].key == NO_DOCKING) ++i;
  return i;
}

// Work item: a pair. `pair_keypoints` holds the key points of its shape: all x, then all y, in steps. The items of a
// group align one pair each; then all lanes test the remaining dockings one after the other and append those that the
// early reject leaves. `evaluated`: number of dockings tested in the field, for each target sample.
DOCKING_KERNEL void dock_pairs(constant MatchRecord* match, global const StanceRecord* stances,
                       global const StanceListRecord* stance_lists, global const uint* shape_class,
                       global const float* size_map, global const float* field_value,
                       constant ColourRecord* colour, global const float* texels,
                       global const float* sketches, global const ShapeRecord* shapes,
                       global const SampleRecord* samples, uint count, global const PairRecord* pairs,
                       global const short* pair_keypoints, global uint* evaluated, uint capacity,
                       global uint* docking_count, global DockingRecord* dockings) {
  SHARED int scratch[kScratch];
  SHARED DockingRecord aligned[kItems];
  const Lanes lanes = lanes_of_docking(scratch);
  const Field field = free_field(match, field_value);
  const uint i = get_global_id(0);
  aligned[lanes.item].key = NO_DOCKING;
  if (i < count) {
    const PairRecord pair = pairs[i];
    const uint shape = pair.source / match->sources;
    global const SampleRecord* target = samples + pair.sample;
    const Stances standing = stances_of(stances, stance_lists, shape_class, shape);
    const float sizes = size_part(match, size_map, target->position_x, target->position_y);
    aligned[lanes.item] =
        aligned_pair(pair, match, &standing, sizes, pair_keypoints + (size_t)i * 2 * kPadKeypoints,
                     shapes + shape, target, &field, evaluated + pair.sample);
  }
  sync_lanes();
  const Picture picture = {colour, texels};
  for (int k = next_docking(aligned, kItems, 0); k < kItems; k = next_docking(aligned, kItems, k + 1)) {
    dock(lanes, aligned[k], match, stances, sketches, shapes, &field, &picture, capacity, docking_count, dockings);
  }
}

// The boundary points of a block whose tangents lead to an allowed rotation, as a mask.
LaneInt docking_points(Lanes lanes, DirectionRange range, global const float* contour, int block,
                       global const SampleRecord* target) {
  const LaneFloat ux = load_lanes(lanes, block, contour + kTangentAt);
  const LaneFloat uy = load_lanes(lanes, block, contour + kTangentAt + kBoundaryPoints);
  const LaneFloat x = ux * target->tangent_x + uy * target->tangent_y;
  const LaneFloat y = ux * target->tangent_y - uy * target->tangent_x;
  const LaneFloat along = x * range.middle_x + y * range.middle_y;
  const LaneFloat across = fabs(range.middle_x * y - range.middle_y * x);
  const LaneInt inside = across * range.edge_x - along * range.edge_y <= 0;
  return range.edge_x > 0 ? inside & (along > 0) : inside;
}

// Values of TangentDraw::point. NO_POINT: none. POINT_TO_FIND: all points have to be tested for allowed rotations.
#define NO_POINT (-1)
#define POINT_TO_FIND (-2)

INLINE int drawn_point(const StanceRecord* stance, uint point_bits) {
  if (docked_rotations(stance).edge_x > -1) return POINT_TO_FIND;
  return (int)(((ulong)point_bits * kBoundaryPoints) >> 32);
}

INLINE int found_point(Lanes lanes, global const StanceRecord* allowed, global const float* contour, uint point_bits,
                       global const SampleRecord* target) {
  const StanceRecord stance = *allowed;
  const DirectionRange range = docked_rotations(&stance);
  LaneInt docks = 0;
  for (int block = 0; block < kBoundaryPoints / kLanes; ++block) {
    docks += docking_points(lanes, range, contour, block, target) ? (LaneInt)1 : (LaneInt)0;
  }
  const int count = int_sum_of_lanes(lanes, docks);
  int before = (int)(((ulong)point_bits * (ulong)count) >> 32);
  int point = NO_POINT;
  for (int block = 0; block < kBoundaryPoints / kLanes && point == NO_POINT; ++block) {
    const int lane = set_lane(lanes, docking_points(lanes, range, contour, block, target), &before);
    if (lane != NO_LANE) point = block * kLanes + lane;
  }
  return point;
}

// A boundary point and its tangent, in shape units.
typedef struct PointFrame {
  float x, y, ux, uy;
} PointFrame;

PointFrame point_frame(global const float* contour, uint point) {
  const PointFrame frame = {contour[kFineAt + point], contour[kFineAt + kBoundaryPoints + point],
                            contour[kTangentAt + point], contour[kTangentAt + kBoundaryPoints + point]};
  return frame;
}

// The pose that aligns the frame of a boundary point with the target's frame, at a given scale.
INLINE PoseRecord tangent_docking(const StanceRecord* stance, PointFrame point, float scale_px,
                                  global const SampleRecord* target) {
  PoseRecord s;
  s.a = (point.ux * target->tangent_x + point.uy * target->tangent_y) * scale_px;
  s.b = (point.ux * target->tangent_y - point.uy * target->tangent_x) * scale_px;
  s.tx = 0;
  s.ty = 0;
  if (stance->rotation_edge_x > -1) s = pulled_in(stance, s);  // otherwise the scale was drawn within its range
  s.tx = target->position_x - (s.a * point.x - s.b * point.y);
  s.ty = target->position_y - (s.b * point.x + s.a * point.y);
  return s;
}

// A random docking, as drawn from random bits.
typedef struct TangentDraw {
  uint library_shape;
  uint stance;  // index in the table
  float scale_px;
  uint point_bits;
  int point;  // NO_POINT: the shape is not in this shard, or no point docks
} TangentDraw;

#define NO_SHAPE 0xffffffffu

// The shape that is drawn. `open_shapes`: shapes of the whole library that may be drawn, unless `all_open`.
// `near_shapes`: lists of shapes of similar colour, each `near_length` long.
INLINE uint drawn_shape(ulong bits, uint draw, global const SampleRecord* target, uint open_count, uint all_open,
                        global const uint* open_shapes, uint near_length, global const uint* near_shapes) {
  if (open_count == 0) return NO_SHAPE;
  if (target->near_list == kAnyColour || draw % kAnyColourDraws == 0) {
    const uint drawn = (uint)(((bits >> 32) * open_count) >> 32);
    return all_open ? drawn : open_shapes[drawn];
  }
  const ulong squared = ((bits >> 32) * (bits >> 32)) >> 32;
  return near_shapes[(size_t)target->near_list * near_length + ((squared * near_length) >> 32)];
}

// The docking of a draw. Its key is NO_DOCKING where its disc does not fit.
INLINE DockingRecord drawn_docking(TangentDraw drawn, uint draw, uint t, const StanceRecord* stance, PointFrame frame,
                                   global const ShapeRecord* shape, global const SampleRecord* target,
                                   const Field* field) {
  const PoseRecord pose = tangent_docking(stance, frame, drawn.scale_px, target);
  const DockingRecord docking = {t, drawn.library_shape, kTangentSource + draw, drawn.stance,
                                 disc_fits(shape, pose, field) ? 0 : NO_DOCKING, pose};
  return docking;
}

enum { kDraws = kItems * kDrawsPerItem };  // of all items of a group

// Index of the next draw from `i` on whose point has to be found, or kDraws.
int next_to_find(SHARED const TangentDraw* drawn, int i) {
  while (i < kDraws && drawn[i].point != POINT_TO_FIND) ++i;
  return i;
}

// Work item: (kDrawsPerItem draws, target sample). The items of a group make their draws; then all lanes test the
// dockings one after the other and append those of this shard's shapes that the early reject leaves. The data of a
// draw's shape may be anywhere in memory: each item loads them for all its draws before it uses any. `contour_places`:
// index of the contour, for each shape of the shard that may be drawn.
DOCKING_KERNEL void dock_tangents(constant MatchRecord* match, global const StanceRecord* stances,
                          global const StanceListRecord* stance_lists, global const uint* shape_class,
                          global const float* size_map, uint open_count, uint all_open, global const uint* open_shapes,
                          uint near_length, global const uint* near_shapes, global const float* field_value,
                          constant ColourRecord* colour, global const float* texels, global const float* contours,
                          global const uint* contour_places, global const float* sketches,
                          global const ShapeRecord* shapes, global const SampleRecord* samples, uint draws,
                          global uint* evaluated, uint capacity, global uint* docking_count,
                          global DockingRecord* dockings) {
  SHARED int scratch[kScratch];
  SHARED TangentDraw drawn[kDraws];
  SHARED DockingRecord docked[kDraws];
  const Lanes lanes = lanes_of_docking(scratch);
  const uint first = (uint)(get_global_id(0) - lanes.item) * kDrawsPerItem;
  const uint t = get_global_id(1);
  global const SampleRecord* target = samples + t;
  const float sizes = size_part(match, size_map, target->position_x, target->position_y);
  for (int i = lanes.item; i < kDraws; i += kItems) {
    const uint draw = first + i;
    const ulong bits = mix_bits(match->seed ^ mix_bits(mix_bits(((ulong)target->edge << 32) | target->pass) ^ draw));
    const ulong more = mix_bits(bits);
    drawn[i].library_shape =
        drawn_shape(bits, draw, target, open_count, all_open, open_shapes, near_length, near_shapes);
    drawn[i].point = NO_POINT;
    const uint shape = drawn[i].library_shape - match->first_shape;  // wraps round where the shape lies before the shard
    if (draw >= draws || open_count == 0 || shape >= match->shapes) continue;
    const Stances standing = stances_of(stances, stance_lists, shape_class, shape);
    const uint place = (uint)(((more & 0xffffffffu) * standing.list.count) >> 32);
    const StanceRecord stance = with_sizes_up_to(sizes, standing.stance[place]);
    drawn[i].stance = standing.list.first + place;
    drawn[i].scale_px =
        stance.min_scale_px * portable_exp2(unit_float((uint)(more >> 32)) * stance.log2_scale_ratio);
    drawn[i].point_bits = (uint)(bits & 0xffffffffu);
    drawn[i].point = drawn_point(&stance, drawn[i].point_bits);
  }
  sync_lanes();
  for (int i = next_to_find(drawn, 0); i < kDraws; i = next_to_find(drawn, i + 1)) {
    const uint shape = drawn[i].library_shape - match->first_shape;
    global const float* contour = contours + (size_t)contour_places[shape] * kContourFloats;
    const int point = found_point(lanes, stances + drawn[i].stance, contour, drawn[i].point_bits, target);
    if (lanes.item == 0) drawn[i].point = point;
  }
  sync_lanes();
  PointFrame frames[kDrawsPerItem];
  for (int k = 0; k < kDrawsPerItem; ++k) {
    const TangentDraw draw = drawn[lanes.item + k * kItems];
    if (draw.point == NO_POINT) continue;
    const uint place = contour_places[draw.library_shape - match->first_shape];
    frames[k] = point_frame(contours + (size_t)place * kContourFloats, (uint)draw.point);
  }
  const Field field = free_field(match, field_value);
  for (int k = 0; k < kDrawsPerItem; ++k) {
    const int i = lanes.item + k * kItems;
    docked[i].key = NO_DOCKING;
    if (drawn[i].point == NO_POINT) continue;
    const uint shape = drawn[i].library_shape - match->first_shape;
    const StanceRecord stance = with_sizes_up_to(sizes, stances[drawn[i].stance]);
    docked[i] = drawn_docking(drawn[i], first + i, t, &stance, frames[k], shapes + shape, target, &field);
  }
  sync_lanes();
  const Picture picture = {colour, texels};
  uint looked_at = 0;
  for (int i = 0; i < kDraws; ++i) {
    if (drawn[i].point != NO_POINT) ++looked_at;
  }
  for (int i = next_docking(docked, kDraws, 0); i < kDraws; i = next_docking(docked, kDraws, i + 1)) {
    dock(lanes, docked[i], match, stances, sketches, shapes, &field, &picture, capacity, docking_count, dockings);
  }
  if (lanes.item == 0 && looked_at > 0) atomic_add(evaluated + t, looked_at);
}
