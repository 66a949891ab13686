// core/field/field_lookup.h in OpenCL C, for the points of all lanes at once: bilinear look-ups in the free field.

typedef struct Field {
  global const float* value;
  int width;
  int height;
  float origin_x;
  float origin_y;
} Field;

Field free_field(constant MatchRecord* match, global const float* value) {
  const Field f = {value, match->field_width, match->field_height, match->field_origin_x, match->field_origin_y};
  return f;
}

// The cell of each point: its nodes q (upper row) and r (lower row), and the point's place within the cell.
typedef struct Cells {
  LaneFloat q0, q1, r0, r1;
  LaneFloat s, t;
  LaneInt on_grid;
} Cells;

// Loads the nodes of the cells. `node`: index of q0, for each lane.
#if kLanesAreItems
INLINE void load_nodes(const Field* f, LaneInt node, Cells* c) {
  global const float* q = f->value + node;
  c->q0 = q[0];
  c->q1 = q[1];
  c->r0 = q[f->width];
  c->r1 = q[f->width + 1];
}
#else
// Two neighbouring nodes of a row need one 8-byte load.
#define LOAD_ROWS(k)                                                       \
  vstore2(vload2(0, f->value + node.s##k), 0x##k, upper);                  \
  vstore2(vload2(0, f->value + f->width + node.s##k), 0x##k, lower)

INLINE void load_nodes(const Field* f, LaneInt node, Cells* c) {
  float upper[2 * kLanes];
  float lower[2 * kLanes];
  LOAD_ROWS(0); LOAD_ROWS(1); LOAD_ROWS(2); LOAD_ROWS(3);
  LOAD_ROWS(4); LOAD_ROWS(5); LOAD_ROWS(6); LOAD_ROWS(7);
  LOAD_ROWS(8); LOAD_ROWS(9); LOAD_ROWS(a); LOAD_ROWS(b);
  LOAD_ROWS(c); LOAD_ROWS(d); LOAD_ROWS(e); LOAD_ROWS(f);
  const float16 upper0 = vload16(0, upper);
  const float16 upper1 = vload16(1, upper);
  const float16 lower0 = vload16(0, lower);
  const float16 lower1 = vload16(1, lower);
  c->q0 = (float16)(upper0.even, upper1.even);
  c->q1 = (float16)(upper0.odd, upper1.odd);
  c->r0 = (float16)(lower0.even, lower1.even);
  c->r1 = (float16)(lower0.odd, lower1.odd);
}
#endif

Cells cells_at(const Field* f, LaneFloat x, LaneFloat y) {
  Cells c;
  const LaneFloat u = x - f->origin_x;
  const LaneFloat v = y - f->origin_y;
  c.on_grid = (u >= 0) & (v >= 0) & (u < (float)(f->width - 1)) & (v < (float)(f->height - 1));
  const LaneFloat u_on = c.on_grid ? u : (LaneFloat)0;
  const LaneFloat v_on = c.on_grid ? v : (LaneFloat)0;
  const LaneInt i = convert_lane_int(u_on);
  const LaneInt j = convert_lane_int(v_on);
  c.s = u_on - convert_lane_float(i);
  c.t = v_on - convert_lane_float(j);
  load_nodes(f, j * f->width + i, &c);
  return c;
}

LaneFloat value_in(const Cells* c) {
  const LaneFloat value =
      (c->q0 * (1 - c->s) + c->q1 * c->s) * (1 - c->t) + (c->r0 * (1 - c->s) + c->r1 * c->s) * c->t;
  return c->on_grid ? value : (LaneFloat)kOffGridDistance;
}

// The field at one point.
float field_value(const Field* f, float x, float y) {
  const float u = x - f->origin_x;
  const float v = y - f->origin_y;
  if (!(u >= 0 && v >= 0 && u < (float)(f->width - 1) && v < (float)(f->height - 1))) return kOffGridDistance;
  const int i = (int)u;
  const int j = (int)v;
  const float s = u - (float)i;
  const float t = v - (float)j;
  global const float* q = f->value + ((size_t)j * f->width + i);
  return (q[0] * (1 - s) + q[1] * s) * (1 - t) + (q[f->width] * (1 - s) + q[f->width + 1] * s) * t;
}

// The field at a point of each lane; `x`, `y` in canvas px.
LaneFloat field_values(const Field* f, LaneFloat x, LaneFloat y) {
  const Cells c = cells_at(f, x, y);
  return value_in(&c);
}

typedef struct FieldSamples {
  LaneFloat value;
  LaneFloat gradient_x;
  LaneFloat gradient_y;
} FieldSamples;

// The field with its gradient. Outside the grid the gradient leads back to the middle, so that a stray pose returns.
FieldSamples field_samples(const Field* f, LaneFloat x, LaneFloat y) {
  const Cells c = cells_at(f, x, y);
  const LaneFloat inward_x = x - f->origin_x < (float)f->width * 0.5f ? (LaneFloat)1.f : (LaneFloat)-1.f;
  const LaneFloat inward_y = y - f->origin_y < (float)f->height * 0.5f ? (LaneFloat)1.f : (LaneFloat)-1.f;
  const LaneFloat slope_x = (c.q1 - c.q0) * (1 - c.t) + (c.r1 - c.r0) * c.t;
  const LaneFloat slope_y = (c.r0 - c.q0) * (1 - c.s) + (c.r1 - c.q1) * c.s;
  FieldSamples result;
  result.value = value_in(&c);
  result.gradient_x = c.on_grid ? slope_x : inward_x;
  result.gradient_y = c.on_grid ? slope_y : inward_y;
  return result;
}
