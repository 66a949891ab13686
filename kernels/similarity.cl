// core/geometry/similarity.h in OpenCL C, and the points of a shape mapped by it.

float scale_of(PoseRecord s) { return sqrt(s.a * s.a + s.b * s.b); }

// core/matching/pose_range.h: the allowed rotations of a pose.
typedef struct DirectionRange {
  float middle_x;
  float middle_y;
  float edge_x;  // cosine and sine of half the width; a cosine of -1: every direction
  float edge_y;
} DirectionRange;

DirectionRange allowed_rotations(const StanceRecord* stance) {
  const DirectionRange range = {stance->rotation_middle_x, stance->rotation_middle_y, stance->rotation_edge_x,
                                stance->rotation_edge_y};
  return range;
}

DirectionRange docked_rotations(const StanceRecord* stance) {
  const DirectionRange range = {stance->rotation_middle_x, stance->rotation_middle_y, stance->docked_edge_x,
                                stance->docked_edge_y};
  return range;
}

bool direction_allowed(DirectionRange range, float x, float y, float length, float slack) {
  if (range.edge_x <= -1) return true;
  const float along = x * range.middle_x + y * range.middle_y;
  const float across = fabs(range.middle_x * y - range.middle_y * x);
  if (range.edge_x > 0 && along <= 0) return false;
  return across * range.edge_x - along * range.edge_y <= slack * length;
}

float2 nearest_edge(DirectionRange range, float x, float y) {
  const float side = range.middle_x * y - range.middle_y * x >= 0 ? range.edge_y : -range.edge_y;
  return (float2)(range.middle_x * range.edge_x - range.middle_y * side,
                  range.middle_y * range.edge_x + range.middle_x * side);
}

bool pose_allowed(const StanceRecord* stance, PoseRecord s) {
  const float scale = scale_of(s);
  return scale >= stance->min_scale_px * (1 - kScaleRounding) && scale <= stance->max_scale_px * (1 + kScaleRounding) &&
         direction_allowed(allowed_rotations(stance), s.a, s.b, scale, kRotationRounding_rad);
}

PoseRecord pulled_in(const StanceRecord* stance, PoseRecord s) {
  const float scale = scale_of(s);
  float wanted = scale;
  if (scale < stance->min_scale_px) wanted = stance->min_scale_px * (1 + kInsideBound);
  if (scale > stance->max_scale_px) wanted = stance->max_scale_px * (1 - kInsideBound);
  const DirectionRange range = allowed_rotations(stance);
  if (!direction_allowed(range, s.a, s.b, scale, 0)) {
    const float2 direction = nearest_edge(range, s.a, s.b);
    s.a = direction.x * wanted;
    s.b = direction.y * wanted;
  } else if (wanted != scale) {
    s.a *= wanted / scale;
    s.b *= wanted / scale;
  }
  return s;
}

// The lowest and highest allowed turn, as Cayley angles.
float2 turn_limits(const StanceRecord* stance, PoseRecord s) {
  float2 limits = (float2)(-kNoTurnLimit, kNoTurnLimit);
  const DirectionRange range = allowed_rotations(stance);
  if (range.edge_x <= -1) return limits;
  const float scale = scale_of(s);
  const float along = s.a * range.middle_x + s.b * range.middle_y;
  const float across = range.middle_x * s.b - range.middle_y * s.a;
  const float to_high = along * range.edge_x + across * range.edge_y;
  const float to_low = along * range.edge_x - across * range.edge_y;
  const bool high_ahead = to_high > 0 && (range.edge_x > 0 || across >= 0);
  const bool low_ahead = to_low > 0 && (range.edge_x > 0 || across <= 0);
  if (high_ahead) limits.y = fmax(0.f, 2 * (along * range.edge_y - across * range.edge_x) / (scale + to_high));
  if (low_ahead) limits.x = fmin(0.f, 2 * (-along * range.edge_y - across * range.edge_x) / (scale + to_low));
  return limits;
}

// A point for each lane, in canvas px.
typedef struct Points {
  LaneFloat x;
  LaneFloat y;
} Points;

// Points [16 block, 16 block + 16) of a set of `count` points (all x, then all y), mapped to the canvas.
Points placed_points(Lanes lanes, PoseRecord s, global const float* set, int count, int block) {
  const LaneFloat x = load_lanes(lanes, block, set);
  const LaneFloat y = load_lanes(lanes, block, set + count);
  Points p;
  p.x = s.a * x - s.b * y + s.tx;
  p.y = s.b * x + s.a * y + s.ty;
  return p;
}
