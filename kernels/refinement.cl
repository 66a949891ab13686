// core/matching/refinement.cpp in OpenCL C: Gauss-Newton on the free field, then pushing until no point is too deep.

// A symmetric 4 x 4 system. Unknowns: shift x, shift y, growth, rotation; the last two are movements at a distance of
// `arm_px`. Order: m00, m10 m11, m20 m21 m22, m30 m31 m32 m33, g0 g1 g2 g3, number of points.
enum EquationSums { FIRST_OF_M = 0, FIRST_OF_G = 10, POINTS = 14, SUMS = 15 };

// The sums while points are added: point i of the set belongs to lane i % 16.
typedef struct NormalEquations {
  LaneFloat sum[SUMS];
} NormalEquations;

typedef struct Limits {
  float low;
  float high;
} Limits;

float limited(Limits limits, float x) { return x < limits.low ? limits.low : x > limits.high ? limits.high : x; }

// Solves (M + damping) x = -g by L D L^T, with growth and turn within their limits.
float4 solve(const float* sum, Limits growth, Limits turn) {
  float m[4][4] = {{sum[0], 0, 0, 0}, {sum[1], sum[2], 0, 0}, {sum[3], sum[4], sum[5], 0},
                   {sum[6], sum[7], sum[8], sum[9]}};
  const float* g = sum + FIRST_OF_G;
  const float trace = m[0][0] + m[1][1] + m[2][2] + m[3][3];
  for (int r = 0; r < 4; ++r) m[r][r] += kDamping * trace + kLeastDamping;
  m[2][2] += kGrowthDamping * trace;
  float d[4];
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < r; ++c) {
      float rest = m[r][c];
      for (int k = 0; k < c; ++k) rest -= m[r][k] * m[c][k] * d[k];
      m[r][c] = rest / d[c];
    }
    float rest = m[r][r];
    for (int k = 0; k < r; ++k) rest -= m[r][k] * m[r][k] * d[k];
    d[r] = rest;
  }
  float x[4];
  for (int r = 0; r < 4; ++r) {
    float rest = -g[r];
    for (int k = 0; k < r; ++k) rest -= m[r][k] * x[k];
    x[r] = rest;
  }
  for (int r = 0; r < 4; ++r) x[r] = x[r] / d[r];
  for (int r = 3; r >= 0; --r) {
    for (int k = r + 1; k < 4; ++k) x[r] -= m[k][r] * x[k];
    if (r == 3) x[r] = limited(turn, x[r]);
    if (r == 2) x[r] = limited(growth, x[r]);
  }
  return (float4)(x[0], x[1], x[2], x[3]);
}

// The pose turned and scaled about the piece's centre, then shifted.
PoseRecord moved(PoseRecord s, float dx, float dy, float growth, float angle) {
  const float t = 0.5f * angle;
  const float k = (1 + growth) / (1 + t * t);
  const float c = k * (1 - t * t);
  const float n = k * (2 * t);
  const PoseRecord result = {s.a * c - s.b * n, s.b * c + s.a * n, s.tx + dx, s.ty + dy};
  return result;
}

// Adds points [16 block, 16 block + 16) of a set that are nearer than `radius` or outside; others have no weight.
INLINE void add_points(Lanes lanes, NormalEquations* equations, PoseRecord s, global const float* set, int count,
                       int block, const Field* field, float arm, float radius, float overlap_weight) {
  const Points p = placed_points(lanes, s, set, count, block);
  const FieldSamples f = field_samples(field, p.x, p.y);
  const LaneInt near = f.value <= radius;
  if (!any_own_lane(near)) return;
  const LaneFloat q = f.value / radius;
  const LaneFloat fade = (1 - q * q) * (1 - q * q);
  const LaneFloat inside = near ? fade : (LaneFloat)0;
  const LaneFloat weights = f.value >= 0 ? inside : (LaneFloat)overlap_weight;
  const LaneFloat ux = p.x - s.tx;
  const LaneFloat uy = p.y - s.ty;
  const LaneFloat j[4] = {f.gradient_x, f.gradient_y, (f.gradient_x * ux + f.gradient_y * uy) / arm,
                          (f.gradient_y * ux - f.gradient_x * uy) / arm};
  LaneFloat* sum = equations->sum;
  for (int r = 0; r < 4; ++r) {
    const LaneFloat weighted = weights * j[r];
    sum[FIRST_OF_G + r] += weighted * f.value;
    for (int c = 0; c <= r; ++c) sum[r * (r + 1) / 2 + c] += weighted * j[c];
  }
  sum[POINTS] += near ? (LaneFloat)1 : (LaneFloat)0;
}

// A piece and the field that it lies in.
typedef struct Piece {
  global const float* contour;
  global const ShapeRecord* shape;
  const Field* field;
  StanceRecord stance;
} Piece;

typedef struct Descent {
  int steps;
  float first_radius_px;
  float last_radius_px;
  float overlap_weight;
  bool all_points;  // false: only the medium set
} Descent;

// The constants of one descent in core/settings/tuning.h.
#define DESCENT(name) \
  {name##_steps, name##_first_radius_px, name##_last_radius_px, name##_overlap_weight, name##_all_points}

// One step of a descent from the sums.
PoseRecord stepped(PoseRecord s, const Piece* piece, const float* sums, float arm, float radius) {
  const float scale = scale_of(s);
  const float2 turns = turn_limits(&piece->stance, s);
  const Limits turn = {turns.x * arm, turns.y * arm};
  const Limits growth = {(piece->stance.min_scale_px / scale - 1) * arm,
                         (piece->stance.max_scale_px / scale - 1) * arm};
  float4 x = solve(sums, growth, turn);
  const float4 size = fabs(x);
  const float largest = max(max(size.x, size.y), max(size.z, size.w));
  if (largest > radius) x = x * (radius / largest);
  return pulled_in(&piece->stance, moved(s, x.x, x.y, x.z / arm, x.w / arm));
}

PoseRecord descended(Lanes lanes, PoseRecord s, const Piece* piece, Descent descent) {
  global const float* set = piece->contour + (descent.all_points ? kFineAt : kMediumAt);
  const int count = descent.all_points ? kBoundaryPoints : kMediumPoints;
  bool drawn = true;
  for (int step = 0; step < descent.steps && drawn; ++step) {
    const float progress = descent.steps > 1 ? (float)step / (float)(descent.steps - 1) : 1.f;
    const float radius = descent.first_radius_px + (descent.last_radius_px - descent.first_radius_px) * progress;
    const float scale = scale_of(s);
    const float arm = piece->shape->radius * scale * kArm;
    NormalEquations equations;
    for (int k = 0; k < SUMS; ++k) equations.sum[k] = 0;
    for (int block = 0; block < count / kLanes; ++block) {
      add_points(lanes, &equations, s, set, count, block, piece->field, arm, radius, descent.overlap_weight);
    }
    float sums[SUMS];
    sums_of_lanes(lanes, SUMS, equations.sum, sums);
    drawn = sums[POINTS] >= kLeastDrawnPoints;
    if (drawn) s = stepped(s, piece, sums, arm, radius);
  }
  return s;
}

// The depth of the piece in the covered area, px; any value above kMaxPushDepth_px once that depth is exceeded.
float depth_px(Lanes lanes, PoseRecord s, const Piece* piece) {
  LaneFloat deepest = 0;
  bool hopeless = false;
  for (int block = 0; block < kBoundaryPoints / kLanes && !hopeless; ++block) {
    const Points p = placed_points(lanes, s, piece->contour + kFineAt, kBoundaryPoints, block);
    deepest = max(deepest, -field_values(piece->field, p.x, p.y));
    hopeless = any_lane(lanes, deepest > kMaxPushDepth_px);
  }
  const int interior_points = piece->shape->interior_points;
  for (int block = 0; block * kLanes < interior_points && !hopeless; ++block) {
    const Points p = placed_points(lanes, s, piece->contour + kInteriorAt, kMaxInteriorPoints, block);
    const LaneFloat d = -field_values(piece->field, p.x, p.y);
    const LaneInt covered = (numbers_of_block(lanes, block) < interior_points) & (d > 0);
    deepest = max(deepest, covered ? d + kInteriorDepth_px : (LaneFloat)0);
    hopeless = any_lane(lanes, deepest > kMaxPushDepth_px);
  }
  return largest_lane(lanes, deepest);
}

// Refines the pose; returns whether it is feasible. Two descents bring the pose near, then pushes repeat while it is
// too deep. Descent and depth occur only once in the code, as devices inline them.
bool refine(Lanes lanes, PoseRecord* pose, const Piece* piece, float hard_depth_px) {
  PoseRecord s = *pose;
  const Descent nestle = DESCENT(kCloseFit);
  const Descent push = DESCENT(kPush);
  Descent approach = DESCENT(kApproach);
  approach.first_radius_px = max(approach.first_radius_px, kApproachRadius * scale_of(s));
  float depth = 0;
  bool too_deep = true;
  for (int pushed = -1; pushed < kPushSteps && too_deep; ++pushed) {
    if (pushed > 0) {
      s.a *= kPushShrink;
      s.b *= kPushShrink;
      s = pulled_in(&piece->stance, s);
    }
    for (int k = pushed < 0 ? 0 : 2; k < (pushed < 0 ? 2 : 3); ++k) {
      s = descended(lanes, s, piece, k == 0 ? approach : k == 1 ? nestle : push);
    }
    depth = depth_px(lanes, s, piece);
    too_deep = depth > hard_depth_px && depth <= kMaxPushDepth_px;
  }
  *pose = s;
  return depth <= hard_depth_px && pose_allowed(&piece->stance, s);
}

// core/geometry/extent.h, for the boundary points.
ExtentRecord extent_of(Lanes lanes, PoseRecord s, global const float* contour) {
  Points low = placed_points(lanes, s, contour + kFineAt, kBoundaryPoints, 0);
  Points high = low;
  for (int block = 1; block < kBoundaryPoints / kLanes; ++block) {
    const Points p = placed_points(lanes, s, contour + kFineAt, kBoundaryPoints, block);
    low.x = min(low.x, p.x);
    low.y = min(low.y, p.y);
    high.x = max(high.x, p.x);
    high.y = max(high.y, p.y);
  }
  const ExtentRecord extent = {smallest_lane(lanes, low.x), smallest_lane(lanes, low.y), largest_lane(lanes, high.x),
                               largest_lane(lanes, high.y)};
  return extent;
}

// kItems work items: one docking. Its shape is in this shard and has a contour on the device.
DOCKING_KERNEL void refine_dockings(constant MatchRecord* match, global const StanceRecord* stances,
                            global const float* size_map, global const float* field_value,
                            constant ColourRecord* colour, global const float* texels, global const float* contours,
                            global const uint* contour_places, global const ShapeRecord* shapes, uint count,
                            global const DockingRecord* dockings, global RefinedRecord* refined) {
  SHARED int scratch[kScratch];
  SHARED float distance[kBoundaryPoints];
  const Lanes lanes = lanes_of_docking(scratch);
  const size_t i = get_global_id(0) / kItems;
  if (i >= count) return;
  const uint shape = dockings[i].shape - match->first_shape;
  const Field field = free_field(match, field_value);
  const Picture picture = {colour, texels};
  const PoseRecord pose = dockings[i].canvas_from_shape;
  const float sizes = size_part(match, size_map, pose.tx, pose.ty);
  const Piece piece = {contours + (size_t)contour_places[shape] * kContourFloats, shapes + shape, &field,
                       with_sizes_up_to(sizes, stances[dockings[i].stance])};
  RefinedRecord result = {pose, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, 0, 0, 0};
  if (refine(lanes, &result.canvas_from_shape, &piece, match->hard_depth_px)) {
    result.feasible = 1;
    result.terms = docking_terms(lanes, distance, match, piece.contour, piece.shape, result.canvas_from_shape, &field,
                                 &picture);
    result.extent = extent_of(lanes, result.canvas_from_shape, piece.contour);
    result.perimeter = piece.shape->perimeter;
    result.radius = piece.shape->radius;
  }
  if (lanes.item == 0) refined[i] = result;
}

// kItems work items: one docking. Its shape is in this shard and has a contour on the device.
DOCKING_KERNEL void measure_dockings(constant MatchRecord* match, global const float* field_value,
                             constant ColourRecord* colour, global const float* texels,
                             global const float* contours, global const uint* contour_places,
                             global const ShapeRecord* shapes, uint count,
                             global const DockingRecord* dockings, global TermsRecord* terms) {
  SHARED int scratch[kScratch];
  SHARED float distance[kBoundaryPoints];
  const Lanes lanes = lanes_of_docking(scratch);
  const size_t i = get_global_id(0) / kItems;
  if (i >= count) return;
  const uint shape = dockings[i].shape - match->first_shape;
  const Field field = free_field(match, field_value);
  const Picture picture = {colour, texels};
  global const float* contour = contours + (size_t)contour_places[shape] * kContourFloats;
  const TermsRecord measured =
      docking_terms(lanes, distance, match, contour, shapes + shape, dockings[i].canvas_from_shape, &field, &picture);
  if (lanes.item == 0) terms[i] = measured;
}
