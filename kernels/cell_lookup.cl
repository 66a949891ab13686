// core/geometry/cell_lookup.h in OpenCL C: the four cells round a point, and the point's place between their centres.

typedef struct CellLookup {
  uint left, right, upper, lower;
  float s, t;
} CellLookup;

CellLookup cell_lookup(float x, float y, float cells_per_px, uint width, uint height) {
  const float u = clamp(x * cells_per_px - 0.5f, 0.f, (float)(width - 1));
  const float v = clamp(y * cells_per_px - 0.5f, 0.f, (float)(height - 1));
  CellLookup c;
  c.left = (uint)u;
  c.upper = (uint)v;
  c.right = min(c.left + 1, width - 1);
  c.lower = min(c.upper + 1, height - 1);
  c.s = u - (float)c.left;
  c.t = v - (float)c.upper;
  return c;
}
