// core/geometry/similarity.h in OpenCL C, and the points of a shape under it.

float scale_of(PoseRecord s) { return sqrt(s.a * s.a + s.b * s.b); }

bool rotation_allowed(constant MatchRecord* match, PoseRecord s) {
  if (match->rotation_min_cosine <= -1) return true;
  return s.a * match->rotation_middle_x + s.b * match->rotation_middle_y >= match->rotation_min_cosine * scale_of(s);
}

// Canvas px of 16 points.
typedef struct Points {
  float16 x;
  float16 y;
} Points;

// Points [16 block, 16 block + 16) of a set of `count` points (all x, then all y).
Points placed_points(PoseRecord s, global const float* set, int count, int block) {
  const float16 x = vload16(block, set);
  const float16 y = vload16(block, set + count);
  Points p;
  p.x = s.a * x - s.b * y + s.tx;
  p.y = s.b * x + s.a * y + s.ty;
  return p;
}
