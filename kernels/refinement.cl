// core/matching/refinement.cpp in OpenCL C: Gauss-Newton on the free field, then push until no point is too
// deep. The points of a piece are looked up 16 at once and added up one after the other, as the reference does.

// A symmetric 4 x 4 system; unknowns: shift x, shift y, growth, rotation, the last two as movements at `arm_px`.
// sum: m00, m10 m11, m20 m21 m22, m30 m31 m32 m33, g0 g1 g2 g3, unused.
typedef struct NormalEquations {
  float16 sum;
  int points;
} NormalEquations;

void add_point(NormalEquations* equations, float4 j, float value, float weight) {
  const float4 w = weight * j;
  const float16 left = (float16)(w.x, w.yy, w.zzz, w.wwww, w, 0, 0);
  const float16 right = (float16)(j.x, j.xy, j.xyz, j, (float4)value, 0, 0);
  equations->sum += left * right;
  ++equations->points;
}

typedef struct Limits {
  float low;
  float high;
} Limits;

float limited(Limits limits, float x) { return x < limits.low ? limits.low : x > limits.high ? limits.high : x; }

// Solves (M + damping) x = -g by L D L^T, growth and turn within their limits.
float4 solve(const NormalEquations* equations, Limits growth, Limits turn) {
  const float16 sum = equations->sum;
  float m[4][4] = {{sum.s0, 0, 0, 0}, {sum.s1, sum.s2, 0, 0}, {sum.s3, sum.s4, sum.s5, 0},
                   {sum.s6, sum.s7, sum.s8, sum.s9}};
  const float g[4] = {sum.sa, sum.sb, sum.sc, sum.sd};
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

// Turns and scales about the piece's own centre, then shifts.
PoseRecord moved(PoseRecord s, float dx, float dy, float growth, float angle) {
  const float t = 0.5f * angle;
  const float k = (1 + growth) / (1 + t * t);
  const float c = k * (1 - t * t);
  const float n = k * (2 * t);
  const PoseRecord result = {s.a * c - s.b * n, s.b * c + s.a * n, s.tx + dx, s.ty + dy};
  return result;
}

// Points [16 block, 16 block + 16) of a set that are nearer than `radius`, or outside.
void add_points(NormalEquations* equations, PoseRecord s, global const float* set, int count, int block,
                const Field* field, float arm, float radius, float overlap_weight) {
  const Points p = placed_points(s, set, count, block);
  const FieldSamples f = field_samples(field, p.x, p.y);
  const int16 near = f.value <= radius;
  if (!any_lane(near)) return;
  const float16 q = f.value / radius;
  const float16 fade = (1 - q * q) * (1 - q * q);
  const float16 weights = f.value >= 0 ? fade : (float16)overlap_weight;
  const float16 ux = p.x - s.tx;
  const float16 uy = p.y - s.ty;
  const float16 growths = (f.gradient_x * ux + f.gradient_y * uy) / arm;
  const float16 turns = (f.gradient_y * ux - f.gradient_x * uy) / arm;
  int is_near[kLanes];
  float gradient_x[kLanes], gradient_y[kLanes], growth[kLanes], turn[kLanes], value[kLanes], weight[kLanes];
  vstore16(near, 0, is_near);
  vstore16(f.gradient_x, 0, gradient_x);
  vstore16(f.gradient_y, 0, gradient_y);
  vstore16(growths, 0, growth);
  vstore16(turns, 0, turn);
  vstore16(f.value, 0, value);
  vstore16(weights, 0, weight);
  for (int k = 0; k < kLanes; ++k) {
    if (is_near[k]) {
      add_point(equations, (float4)(gradient_x[k], gradient_y[k], growth[k], turn[k]), value[k], weight[k]);
    }
  }
}

// One piece on one field.
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
  bool all_points;  // else the medium set
} Descent;

// One of core/tuning.h.
#define DESCENT(name) \
  {name##_steps, name##_first_radius_px, name##_last_radius_px, name##_overlap_weight, name##_all_points}

PoseRecord descended(PoseRecord s, const Piece* piece, Descent descent) {
  global const float* set = piece->contour + (descent.all_points ? kFineAt : kMediumAt);
  const int count = descent.all_points ? kBoundaryPoints : kMediumPoints;
  for (int step = 0; step < descent.steps; ++step) {
    const float progress = descent.steps > 1 ? (float)step / (float)(descent.steps - 1) : 1.f;
    const float radius = descent.first_radius_px + (descent.last_radius_px - descent.first_radius_px) * progress;
    const float scale = scale_of(s);
    const float arm = piece->shape->radius * scale * kArm;
    NormalEquations equations = {0, 0};
    for (int block = 0; block < count / kLanes; ++block) {
      add_points(&equations, s, set, count, block, piece->field, arm, radius, descent.overlap_weight);
    }
    if (equations.points < kLeastDrawnPoints) return s;
    const float2 turns = turn_limits(&piece->stance, s);
    const Limits turn = {turns.x * arm, turns.y * arm};
    const Limits growth = {(piece->stance.min_scale_px / scale - 1) * arm,
                           (piece->stance.max_scale_px / scale - 1) * arm};
    float4 x = solve(&equations, growth, turn);
    const float4 size = fabs(x);
    const float largest = max(max(size.x, size.y), max(size.z, size.w));
    if (largest > radius) x = x * (radius / largest);
    s = pulled_in(&piece->stance, moved(s, x.x, x.y, x.z / arm, x.w / arm));
  }
  return s;
}

// How deep the piece reaches into what is covered, or as soon as that is known anything above kHopelessDepth_px.
float depth_px(PoseRecord s, const Piece* piece) {
  float16 deepest = 0;
  for (int block = 0; block < kBoundaryPoints / kLanes; ++block) {
    const Points p = placed_points(s, piece->contour + kFineAt, kBoundaryPoints, block);
    deepest = max(deepest, -field_values(piece->field, p.x, p.y));
    if (any_lane(deepest > kHopelessDepth_px)) break;
  }
  const int interior_points = piece->shape->interior_points;
  for (int block = 0; block * kLanes < interior_points; ++block) {
    if (any_lane(deepest > kHopelessDepth_px)) break;
    const Points p = placed_points(s, piece->contour + kInteriorAt, kMaxInteriorPoints, block);
    const float16 d = -field_values(piece->field, p.x, p.y);
    const int16 covered = (lane_index() + block * kLanes < interior_points) & (d > 0);
    deepest = max(deepest, covered ? d + kInteriorDepth_px : (float16)0);
  }
  return largest_lane(deepest);
}

// Gives whether the refined pose is feasible.
bool refine(PoseRecord* pose, const Piece* piece, float hard_depth_px) {
  PoseRecord s = *pose;
  const Descent nestle = DESCENT(kNestle);
  const Descent push = DESCENT(kPush);
  Descent approach = DESCENT(kApproach);
  approach.first_radius_px = max(approach.first_radius_px, kApproachRadius * scale_of(s));
  s = descended(s, piece, approach);
  s = descended(s, piece, nestle);
  float depth = depth_px(s, piece);
  for (int pushed = 0; pushed < kPushSteps && depth > hard_depth_px && depth <= kHopelessDepth_px; ++pushed) {
    if (pushed > 0) {
      s.a *= kPushShrink;
      s.b *= kPushShrink;
      s = pulled_in(&piece->stance, s);
    }
    s = descended(s, piece, push);
    depth = depth_px(s, piece);
  }
  *pose = s;
  return depth <= hard_depth_px && pose_allowed(&piece->stance, s);
}

// core/geometry/extent.h, of the boundary points.
ExtentRecord extent_of(PoseRecord s, global const float* contour) {
  Points low = placed_points(s, contour + kFineAt, kBoundaryPoints, 0);
  Points high = low;
  for (int block = 1; block < kBoundaryPoints / kLanes; ++block) {
    const Points p = placed_points(s, contour + kFineAt, kBoundaryPoints, block);
    low.x = min(low.x, p.x);
    low.y = min(low.y, p.y);
    high.x = max(high.x, p.x);
    high.y = max(high.y, p.y);
  }
  const ExtentRecord extent = {smallest_lane(low.x), smallest_lane(low.y), largest_lane(high.x), largest_lane(high.y)};
  return extent;
}

// Work item: a docking, whose shape is of this shard and has a contour on the device.
kernel void refine_dockings(constant MatchRecord* match, global const StanceRecord* stances,
                            global const float* size_map, global const float* field_value,
                            constant ColourRecord* colour, global const float* texels, global const float* contours,
                            global const uint* contour_places, global const ShapeRecord* shapes, uint count, global const DockingRecord* dockings,
                            global RefinedRecord* refined) {
  const size_t i = get_global_id(0);
  if (i >= count) return;
  const uint shape = dockings[i].shape - match->first_shape;
  const Field field = free_field(match, field_value);
  const Picture picture = {colour, texels};
  const PoseRecord pose = dockings[i].canvas_from_shape;
  const float sizes = size_part(match, size_map, pose.tx, pose.ty);
  const Piece piece = {contours + (size_t)contour_places[shape] * kContourFloats, shapes + shape, &field,
                       with_sizes_up_to(sizes, stances[dockings[i].stance])};
  RefinedRecord result = {pose, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, 0, 0, 0};
  if (refine(&result.canvas_from_shape, &piece, match->hard_depth_px)) {
    result.feasible = 1;
    result.terms = docking_terms(match, piece.contour, piece.shape, result.canvas_from_shape, &field, &picture);
    result.extent = extent_of(result.canvas_from_shape, piece.contour);
    result.perimeter = piece.shape->perimeter;
    result.radius = piece.shape->radius;
  }
  refined[i] = result;
}

// Work item: a docking, whose shape is of this shard and has a contour on the device.
kernel void measure_dockings(constant MatchRecord* match, global const float* field_value,
                             constant ColourRecord* colour, global const float* texels,
                             global const float* contours, global const uint* contour_places,
                             global const ShapeRecord* shapes, uint count,
                             global const DockingRecord* dockings, global TermsRecord* terms) {
  const size_t i = get_global_id(0);
  if (i >= count) return;
  const uint shape = dockings[i].shape - match->first_shape;
  const Field field = free_field(match, field_value);
  const Picture picture = {colour, texels};
  terms[i] = docking_terms(match, contours + (size_t)contour_places[shape] * kContourFloats, shapes + shape,
                           dockings[i].canvas_from_shape, &field, &picture);
}
