// core/matching/docking.cpp in OpenCL C (paper section 3.3): from a pair, or from random bits, to a similarity, and how
// well it looks on a few points of the free field.

#define NO_DOCKING (-1.f)

typedef struct Alignment {
  PoseRecord canvas_from_shape;
  uint stance;  // place in the list
  bool valid;
} Alignment;

// x, y of the shape, x, y of the target.
float4 keypoint_pair(global const short* shape_x, global const short* shape_y, float step,
                     global const SampleRecord* target, int i) {
  return (float4)((float)shape_x[i] * step, (float)shape_y[i] * step, target->keypoint_x[i], target->keypoint_y[i]);
}

// Key points of both, less their means: what least squares needs of them.
typedef struct Moments {
  float4 mean;     // of the shape, of the target
  float4 product;  // real and imaginary part of the product, spread of the shape, spread of the target
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

// The best pose of the stance. False where it would have to be turned by more than a right angle.
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

// `shape_x`, `shape_y`: key points of the shape's sample, steps. Least squares at the longest level at which both
// agree, by the stance that fits best.
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

// How a pose ranks by 32 boundary points and a third of the interior points; where that is below kLeastDockingKey
// anything below it.
float docking_key(global const float* sketch, global const ShapeRecord* shape, PoseRecord s, const Field* field,
                  float max_scale_px) {
  const float scale = scale_of(s);
  const float hopeless_px = max(kHopelessDocking_px, kHopelessDocking * scale);
  const float near_px = max(kNearDocking_px, kNearDocking * scale);
  // One look-up settles most: where the disc does not fit, the piece does not.
  const float disc_x = s.tx + (s.a * shape->disc_x - s.b * shape->disc_y);
  const float disc_y = s.ty + (s.b * shape->disc_x + s.a * shape->disc_y);
  if (field_value(field, disc_x, disc_y) < shape->disc_radius * scale - hopeless_px) return NO_DOCKING;
  int hits = 0;
  int bad = 0;
  for (int block = 0; block < kCoarsePoints / kLanes; ++block) {
    const Points p = placed_points(s, sketch + kCoarseAt, kCoarsePoints, block);
    const float16 d = field_values(field, p.x, p.y);
    if (any_lane(d < -hopeless_px)) return NO_DOCKING;
    const int16 deep = d < -near_px;
    bad += count_lanes(deep);
    if (bad > kMostBadPoints) return NO_DOCKING;
    hits += count_lanes(~deep & (d < near_px));
  }
  const float contact = ((float)hits - kBadPointCost * (float)bad) / (float)kCoarsePoints;
  // Large pieces first: they are harder to place later.
  const float size = sqrt(sqrt(scale / max_scale_px));
  if (contact * size < kLeastDockingKey) return NO_DOCKING;  // interior points can only make it less
  int covered = 0;
  const int coarse_points = ((int)shape->interior_points + kInteriorStride - 1) / kInteriorStride;
  for (int block = 0; block * kLanes < coarse_points; ++block) {
    const Points p = placed_points(s, sketch + kCoarseInteriorAt, kCoarseInteriorPoints, block);
    const int16 used = lane_index() + block * kLanes < coarse_points;
    covered += count_lanes(used & (field_values(field, p.x, p.y) < 0));
  }
  const float points = (float)shape->interior_points;
  const float interior = shape->interior_points == 0 ? 0.f : kCoveredCost * (float)covered / points;
  return (contact - interior) * size;
}

// Of the piece's mean colour on that of the place.
float docking_colour_worth(const Picture* picture, global const ShapeRecord* shape, PoseRecord s) {
  if (picture->record->levels == 0) return 1;
  return colour_worth(picture, mean_colour_difference(picture, shape, s));
}

int level_of_source(constant MatchRecord* match, uint source) {
  int k = 0;
  while (source >= match->level[k].first + match->level[k].count) ++k;
  return k;
}

// The dockings that a question is answered with are gathered from these, on the host. Of more than `capacity` the rest
// is lost, but counted.
void add_docking(DockingRecord docking, uint capacity, global uint* count, global DockingRecord* dockings) {
  const uint place = claim_places(count, 1);
  if (place < capacity) dockings[place] = docking;
}

// Work item: a pair, whose shape's key points are `pair_keypoints`: all x, then all y, steps. Its docking is added where
// the early reject leaves it. `evaluated`: dockings that looked at the field, by target sample.
kernel void dock_pairs(constant MatchRecord* match, global const StanceRecord* stances,
                       global const StanceListRecord* stance_lists, global const uint* shape_class,
                       global const float* size_map, global const float* field_value,
                       constant ColourRecord* colour, global const float* texels,
                       global const float* sketches, global const ShapeRecord* shapes,
                       global const SampleRecord* samples, uint count, global const PairRecord* pairs,
                       global const short* pair_keypoints, global uint* evaluated, uint capacity,
                       global uint* docking_count, global DockingRecord* dockings) {
  const uint i = get_global_id(0);
  if (i >= count) return;
  const PairRecord pair = pairs[i];
  const uint shape = pair.source / match->sources;
  const uint source = pair.source % match->sources;
  global const SampleRecord* target = samples + pair.sample;
  const Stances standing = stances_of(stances, stance_lists, shape_class, shape);
  const float sizes = size_part(match, size_map, target->position_x, target->position_y);
  constant LevelRecord* level = match->level + level_of_source(match, source);
  global const short* keypoint = pair_keypoints + (size_t)i * 2 * kPadKeypoints;
  const Alignment aligned =
      align_pyramids(&standing, sizes, keypoint, keypoint + kPadKeypoints, shapes[shape].keypoint_step, target,
                     level->scale_low_px, level->scale_high_px);
  if (!aligned.valid) return;
  atomic_inc(evaluated + pair.sample);
  const Field field = free_field(match, field_value);
  const float key = docking_key(sketches + (size_t)shape * kSketchFloats, shapes + shape, aligned.canvas_from_shape,
                                &field, match->max_scale_px);
  if (key < kLeastDockingKey) return;
  const Picture picture = {colour, texels};
  const float worth = docking_colour_worth(&picture, shapes + shape, aligned.canvas_from_shape);
  const DockingRecord docking = {pair.sample, match->first_shape + shape, source,
                                 standing.list.first + aligned.stance,
                                 key * worth * standing.stance[aligned.stance].weight, aligned.canvas_from_shape};
  add_docking(docking, capacity, docking_count, dockings);
}

// Which of 16 boundary points' tangents imply a rotation that docks.
int16 docking_points(DirectionRange range, global const float* contour, int block, global const SampleRecord* target) {
  const float16 ux = vload16(block, contour + kTangentAt);
  const float16 uy = vload16(block, contour + kTangentAt + kBoundaryPoints);
  const float16 x = ux * target->tangent_x + uy * target->tangent_y;
  const float16 y = ux * target->tangent_y - uy * target->tangent_x;
  const float16 along = x * range.middle_x + y * range.middle_y;
  const float16 across = fabs(range.middle_x * y - range.middle_y * x);
  const int16 inside = across * range.edge_x - along * range.edge_y <= 0;
  return range.edge_x > 0 ? inside & (along > 0) : inside;
}

// The boundary point that a draw docks, or NO_POINT.
#define NO_POINT (-1)
INLINE int docked_point(global const StanceRecord* allowed, global const float* contour, uint point_bits,
                        global const SampleRecord* target) {
  const StanceRecord stance = *allowed;
  const DirectionRange range = docked_rotations(&stance);
  if (range.edge_x <= -1) return (int)(((ulong)point_bits * kBoundaryPoints) >> 32);
  int count = 0;
  for (int block = 0; block < kBoundaryPoints / kLanes; ++block) {
    count += count_lanes(docking_points(range, contour, block, target));
  }
  int before = (int)(((ulong)point_bits * (ulong)count) >> 32);
  for (int block = 0; count > 0 && block < kBoundaryPoints / kLanes; ++block) {
    const int16 docks = docking_points(range, contour, block, target);
    const int here = count_lanes(docks);
    if (before >= here) {
      before -= here;
      continue;
    }
    int lane[kLanes];
    vstore16(docks, 0, lane);
    for (int k = 0; k < kLanes; ++k) {
      if (lane[k] && before-- == 0) return block * kLanes + k;
    }
  }
  return NO_POINT;
}

// A boundary point and its tangent there. Shape units.
typedef struct PointFrame {
  float x, y, ux, uy;
} PointFrame;

PointFrame point_frame(global const float* contour, uint point) {
  const PointFrame frame = {contour[kFineAt + point], contour[kFineAt + kBoundaryPoints + point],
                            contour[kTangentAt + point], contour[kTangentAt + kBoundaryPoints + point]};
  return frame;
}

// Frames aligned at a boundary point, at a given scale.
INLINE PoseRecord tangent_docking(const StanceRecord* stance, PointFrame point, float scale_px,
                                  global const SampleRecord* target) {
  PoseRecord s;
  s.a = (point.ux * target->tangent_x + point.uy * target->tangent_y) * scale_px;
  s.b = (point.ux * target->tangent_y - point.uy * target->tangent_x) * scale_px;
  s.tx = 0;
  s.ty = 0;
  if (stance->rotation_edge_x > -1) s = pulled_in(stance, s);  // the scale was drawn within its range
  s.tx = target->position_x - (s.a * point.x - s.b * point.y);
  s.ty = target->position_y - (s.b * point.x + s.a * point.y);
  return s;
}

// What random bits say.
typedef struct TangentDraw {
  uint library_shape;
  uint stance;  // place in the shape's list
  float scale_px;
  uint point_bits;
  bool docks;  // the shape is of this shard
} TangentDraw;

#define NO_SHAPE 0xffffffffu

// `open_shapes`: the shapes of the whole library that may be drawn, unless all may; `near_shapes`: `near_length` of each
// list of shapes of about one colour.
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

// Work item: (kDrawsPerItem draws, target sample). Their dockings are added where the shape is of this shard and the
// early reject leaves them. A draw's shape lies anywhere in memory: what several draws need of it is asked for before
// any of it is used. `contour_places`: by shape of the shard, for those that may be drawn.
kernel void dock_tangents(constant MatchRecord* match, global const StanceRecord* stances,
                          global const StanceListRecord* stance_lists, global const uint* shape_class,
                          global const float* size_map, uint open_count, uint all_open, global const uint* open_shapes,
                          uint near_length, global const uint* near_shapes, global const float* field_value,
                          constant ColourRecord* colour, global const float* texels, global const float* contours,
                          global const uint* contour_places, global const float* sketches,
                          global const ShapeRecord* shapes, global const SampleRecord* samples, uint draws,
                          global uint* evaluated, uint capacity, global uint* docking_count,
                          global DockingRecord* dockings) {
  const uint first = (uint)get_global_id(0) * kDrawsPerItem;
  const uint t = get_global_id(1);
  global const SampleRecord* target = samples + t;
  const float sizes = size_part(match, size_map, target->position_x, target->position_y);
  TangentDraw drawn[kDrawsPerItem];
  for (uint i = 0; i < kDrawsPerItem; ++i) {
    const uint draw = first + i;
    const ulong bits = mix_bits(match->seed ^ mix_bits(mix_bits(((ulong)target->edge << 32) | target->pass) ^ draw));
    const ulong more = mix_bits(bits);
    drawn[i].library_shape =
        drawn_shape(bits, draw, target, open_count, all_open, open_shapes, near_length, near_shapes);
    const uint shape = drawn[i].library_shape - match->first_shape;  // wraps round below the shard
    drawn[i].docks = draw < draws && open_count > 0 && shape < match->shapes;
    if (!drawn[i].docks) continue;
    const Stances standing = stances_of(stances, stance_lists, shape_class, shape);
    drawn[i].stance = (uint)(((more & 0xffffffffu) * standing.list.count) >> 32);
    const StanceRecord stance = with_sizes_up_to(sizes, standing.stance[drawn[i].stance]);
    drawn[i].scale_px =
        stance.min_scale_px * portable_exp2(unit_float((uint)(more >> 32)) * stance.log2_scale_ratio);
    drawn[i].point_bits = (uint)(bits & 0xffffffffu);
  }
  PointFrame frames[kDrawsPerItem];
  for (uint i = 0; i < kDrawsPerItem; ++i) {
    if (!drawn[i].docks) continue;
    const uint shape = drawn[i].library_shape - match->first_shape;
    const Stances standing = stances_of(stances, stance_lists, shape_class, shape);
    global const float* contour = contours + (size_t)contour_places[shape] * kContourFloats;
    const int point = docked_point(standing.stance + drawn[i].stance, contour, drawn[i].point_bits, target);
    drawn[i].docks = point != NO_POINT;
    frames[i] = point_frame(contour, (uint)max(point, 0));
  }
  const Field field = free_field(match, field_value);
  const Picture picture = {colour, texels};
  uint looked_at = 0;
  for (uint i = 0; i < kDrawsPerItem; ++i) {
    if (!drawn[i].docks) continue;
    const uint shape = drawn[i].library_shape - match->first_shape;
    const Stances standing = stances_of(stances, stance_lists, shape_class, shape);
    const StanceRecord stance = with_sizes_up_to(sizes, standing.stance[drawn[i].stance]);
    const PoseRecord pose = tangent_docking(&stance, frames[i], drawn[i].scale_px, target);
    const float key = docking_key(sketches + (size_t)shape * kSketchFloats, shapes + shape, pose, &field,
                                  match->max_scale_px);
    ++looked_at;
    if (key < kLeastDockingKey) continue;
    const float weighted = key * docking_colour_worth(&picture, shapes + shape, pose) * stance.weight;
    const DockingRecord docking = {t, drawn[i].library_shape, kTangentSource + first + i,
                                   standing.list.first + drawn[i].stance, weighted, pose};
    add_docking(docking, capacity, docking_count, dockings);
  }
  if (looked_at > 0) atomic_add(evaluated + t, looked_at);
}
